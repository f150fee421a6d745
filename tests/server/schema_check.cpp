#include "schema_check.hpp"

#include <algorithm>

namespace waybreaker::server {
namespace {

using Json = nlohmann::json;

bool has_type(const Json& value, const std::string& type) {
    if (type == "null") return value.is_null();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "array") return value.is_array();
    return type == "object" && value.is_object();
}

bool has_type(const Json& value, const Json& types) {
    if (types.is_string()) return has_type(value, types.get<std::string>());
    return std::any_of(types.begin(), types.end(),
                       [&](const Json& type) { return has_type(value, type.get<std::string>()); });
}

}  // namespace

const Json& resolved(const Json& api, const Json& value) {
    if (!value.is_object() || !value.contains("$ref")) return value;
    return api.at(Json::json_pointer(value.at("$ref").get<std::string>().substr(1)));
}

std::vector<std::string> schema_faults(const Json& api, const Json& given, const Json& value,
                                       const std::string& place) {
    const Json& schema = resolved(api, given);
    std::vector<std::string> faults;
    const auto descend = [&](const Json& inner, const Json& part, const std::string& where) {
        const auto more = schema_faults(api, inner, part, where);
        faults.insert(faults.end(), more.begin(), more.end());
    };
    if (schema.contains("type") && !has_type(value, schema.at("type"))) return {place + " has another type"};
    if (schema.contains("enum") &&
        std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end()) {
        faults.push_back(place + " is none of the words");
    }
    if (value.is_number()) {
        const auto number = value.get<double>();
        if (number < schema.value("minimum", number)) faults.push_back(place + " is too small");
        if (number > schema.value("maximum", number)) faults.push_back(place + " is too large");
        if (schema.contains("exclusiveMinimum") && number <= schema["exclusiveMinimum"].get<double>()) {
            faults.push_back(place + " is too small");
        }
    }
    if (value.is_object()) {
        for (const Json& name : schema.value("required", Json::array())) {
            if (!value.contains(name.get<std::string>())) faults.push_back(place + " lacks " + name.get<std::string>());
        }
        const Json properties = schema.value("properties", Json::object());
        const Json others = schema.value("additionalProperties", Json(true));
        for (const auto& [name, part] : value.items()) {
            if (properties.contains(name)) {
                descend(properties.at(name), part, place + "." + name);
            } else if (others.is_object()) {
                descend(others, part, place + "." + name);
            } else if (others == false) {
                faults.push_back(place + " has an unknown " + name);
            }
        }
    }
    if (value.is_array()) {
        if (value.size() < schema.value("minItems", std::size_t{0})) faults.push_back(place + " is too short");
        if (value.size() > schema.value("maxItems", value.size())) faults.push_back(place + " is too long");
        for (std::size_t i = 0; schema.contains("items") && i < value.size(); ++i) {
            descend(schema.at("items"), value[i], place + "[" + std::to_string(i) + "]");
        }
    }
    return faults;
}

}  // namespace waybreaker::server

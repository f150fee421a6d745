#include "schema_check.hpp"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace waybreaker::service {

using Json = nlohmann::json;
using valijson::adapters::NlohmannJsonAdapter;

const Json& resolved(const Json& document, const Json& value) {
    if (!value.is_object() || !value.contains("$ref")) return value;
    return document.at(Json::json_pointer(value.at("$ref").get<std::string>().substr(1)));
}

// OpenAPI's schemas are JSON Schema of 2020, of which they use no word that draft 7 has not.
std::vector<std::string> schema_faults(const Json& document, const Json& schema, const Json& value) {
    const Json alone{{"allOf", Json::array({schema})}, {"components", document.value("components", Json::object())}};
    valijson::Schema parsed;
    valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(alone), parsed);
    valijson::ValidationResults results;
    valijson::Validator().validate(parsed, NlohmannJsonAdapter(value), &results);
    std::vector<std::string> faults;
    for (const valijson::ValidationResults::Error& error : results) {
        std::string& fault = faults.emplace_back();
        for (const std::string& step : error.context) fault += step;
        fault += ": " + error.description;
    }
    return faults;
}

}  // namespace waybreaker::service

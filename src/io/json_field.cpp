#include "io/json_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/byte_order_mark.hpp"
#include "core/control_character.hpp"
#include "core/in_quotes.hpp"
#include "core/utf8.hpp"
#include "io/json_position.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

// As editors save it, with a byte order mark or without.
bool is_utf16(std::string_view text) {
    if (text.size() < 2) return false;
    const auto begins = [&](char first, char second) { return text[0] == first && text[1] == second; };
    return begins('\xFF', '\xFE') || begins('\xFE', '\xFF') || begins('{', '\0') || begins('\0', '{');
}

}  // namespace

JsonDocument parse_json(std::string_view text, const std::string& file, int max_depth) {
    text = without_byte_order_mark(text);
    const auto fail = [&](std::size_t byte, const std::string& what) {
        throw InputError(file_position(file, text, byte), 0, what);
    };
    const auto not_too_deep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        if (depth > max_depth) fail(depth_at(text, max_depth), "its values are nested too deep");
        return true;
    };
    if (is_utf16(text)) fail(0, "this is not JSON: it is in UTF-16; save it in UTF-8");
    // To the parser it is the end of the text.
    if (const std::size_t null = text.find('\0'); null != text.npos) fail(null, "this is not JSON: it has a null byte");
    try {
        JsonDocument document{text, file, nlohmann::json::parse(text, not_too_deep)};
        // The parser takes the last of them; who wrote the file may have meant another.
        if (const auto twice = repeated_name(text)) {
            fail(twice->at, "the member " + in_quotes(twice->name) + " is there twice");
        }
        return document;
    } catch (const nlohmann::json::parse_error& error) {
        // `byte` is the last one that was read, counted from 1.
        const bool whole = error.byte <= text.size();
        const std::size_t utf8 = utf8_prefix(text);
        if (utf8 < std::min(error.byte, text.size())) fail(utf8, "this is not JSON: it is not in UTF-8; save it so");
        fail(std::min(error.byte - 1, text.size()), whole ? "this is not JSON" : "this is not JSON: it ends too early");
    } catch (const nlohmann::json::exception&) {
        fail(overflow_at(text), "this number is too large");
    }
    return {};
}

JsonField JsonField::operator[](const char* key) const {
    if (!json_->is_object()) fail("is not an object");
    const auto member = json_->find(key);
    if (member == json_->end()) fail(std::string("has no member ") + key);
    return {*member, place_.empty() ? key : place_ + "." + key, document_};
}

std::optional<JsonField> JsonField::find(const char* key) const {
    if (!json_->is_object()) fail("is not an object");
    const auto member = json_->find(key);
    if (member == json_->end() || member->is_null()) return std::nullopt;
    return (*this)[key];
}

void JsonField::require_format(std::string_view format) const {
    const auto given = find("format");
    if (!given) fail("has no member format: give it \"format\": \"" + std::string(format) + '"');
    if (given->json() != format) given->fail("is not " + std::string(format));
}

void JsonField::allow(std::initializer_list<std::string_view> names) const {
    if (!json_->is_object()) fail("is not an object");
    for (const auto& [key, value] : json_->items()) {
        if (std::find(names.begin(), names.end(), key) != names.end()) continue;
        std::string known;
        for (const std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string(name);
        const std::size_t object = value_at(document_->text, place_);
        fail_at(name_at(document_->text, object, key),
                "has a member " + in_quotes(key) + ", which is none of " + known);
    }
}

bool JsonField::truth() const {
    if (!json_->is_boolean()) fail("is neither true nor false");
    return json_->get<bool>();
}

std::vector<JsonField> JsonField::items() const {
    if (!json_->is_array()) fail("is not an array");
    std::vector<JsonField> fields;
    for (const nlohmann::json& value : *json_) {
        fields.push_back({value, place_ + "[" + std::to_string(fields.size()) + "]", document_});
    }
    return fields;
}

double JsonField::number() const {
    if (!json_->is_number()) fail("is not a number");
    return json_->get<double>();  // finite: the parser refuses what is too large
}

std::optional<double> JsonField::number_or_null() const {
    return json_->is_null() ? std::nullopt : std::optional(number());
}

std::int64_t JsonField::whole_number(std::int64_t least, std::int64_t most) const {
    const double value = number();
    constexpr double exact = 1e15;  // up to here every number with a decimal point says what it means
    if (value != std::floor(value) || (json_->is_number_float() && std::abs(value) > exact)) {
        fail("is not a whole number");
    }
    if (value < double(least) || value > double(most)) {
        fail("is not between " + std::to_string(least) + " and " + std::to_string(most));
    }
    return json_->is_number_float() ? std::int64_t(value) : std::clamp(json_->get<std::int64_t>(), least, most);
}

std::string JsonField::text() const {
    if (!json_->is_string()) fail("is not a text");
    const auto& text = json_->get_ref<const std::string&>();
    for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(1)) {
        if (control_length(rest) > 0) fail("holds control characters");
    }
    return text;
}

void JsonField::fail(const std::string& what) const {
    fail_at(value_at(document_->text, place_), what);
}

void JsonField::fail_at(std::size_t byte, const std::string& what) const {
    throw InputError(file_position(document_->file, document_->text, byte), 0,
                     (place_.empty() ? "the document" : place_) + " " + what);
}

}  // namespace waybreaker::io

// A value of a JSON document that knows where it stands, so that errors can say so: "plan.json:7:12: removed[2].at is
// not a cell". The document is untrusted: everything is validated.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waybreaker::io {

// It takes up to 40 times the memory of its text.
struct JsonDocument {
    std::string_view text;
    std::string file;
    nlohmann::json json;
};

// Throws InputError naming file, line and column unless the text, which must outlive the document, is JSON of at most
// `max_depth` levels, whose objects have no member twice.
JsonDocument parse_json(std::string_view text, const std::string& file, int max_depth);

class JsonField {
  public:
    // The whole document, which must outlive the field.
    explicit JsonField(const JsonDocument& document) : json_(&document.json), document_(&document) {}

    // A member of an object; find() is empty where there is none, or null.
    JsonField operator[](const char* key) const;
    std::optional<JsonField> find(const char* key) const;

    // Throws InputError if its member `format`, which says what a document is, is missing or another.
    void require_format(std::string_view format) const;

    // Throws InputError if the object has a member of another name: a typing error, most likely.
    void allow(std::initializer_list<std::string_view> names) const;

    // Its type, to choose between forms.
    const nlohmann::json& json() const { return *json_; }

    // The values of an array.
    std::vector<JsonField> items() const;

    // The value; throws InputError if it is of another type.
    double number() const;
    std::int64_t whole_number(std::int64_t least, std::int64_t most) const;
    std::string text() const;  // of printable characters
    template <class Value>
    Value one_of(const std::vector<std::pair<std::string, Value>>& choices) const;

    bool truth() const;

    std::optional<double> number_or_null() const;

    // Throws InputError: where this stands and what is wrong with it.
    [[noreturn]] void fail(const std::string& what) const;

  private:
    JsonField(const nlohmann::json& value, std::string place, const JsonDocument* document)
        : json_(&value), place_(std::move(place)), document_(document) {}
    [[noreturn]] void fail_at(std::size_t byte, const std::string& what) const;

    const nlohmann::json* json_;
    std::string place_;
    const JsonDocument* document_;
};

template <class Value>
Value JsonField::one_of(const std::vector<std::pair<std::string, Value>>& choices) const {
    std::string words;
    for (const auto& [word, value] : choices) {
        if (*json_ == word) return value;
        words += (words.empty() ? "" : ", ") + word;
    }
    fail((choices.size() == 1 ? "is not " : "is none of ") + words);
}

}  // namespace waybreaker::io

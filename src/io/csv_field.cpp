#include "io/csv_field.hpp"

#include "core/number.hpp"

namespace waybreaker::io {
namespace {

bool is_formula(std::string_view text) {
    constexpr std::string_view begins = "=+-@\t\r";
    return !text.empty() && begins.find(text.front()) != std::string_view::npos && !waybreaker::number<double>(text);
}

}  // namespace

std::string csv_field(std::string_view text) {
    std::string shown(text);
    if (is_formula(text)) shown.insert(shown.begin(), '\'');
    if (shown.find_first_of(",\"\r\n") == std::string::npos) return shown;
    std::string quoted = "\"";
    for (const char c : shown) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

}  // namespace waybreaker::io

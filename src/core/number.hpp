// Numbers in text.
#pragma once

#include <charconv>
#include <concepts>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace waybreaker {

// A decimal number as std::from_chars reads it, for standard libraries that read integers only (libc++ before 20). Not
// infinity, and nothing between zero and the least normal number.
inline std::optional<double> decimal_number(std::string_view word) {
    const bool decimal = word.find_first_not_of("0123456789.eE+-") == std::string_view::npos;
    if (!decimal || word.empty() || word.front() == '+') return std::nullopt;
    std::istringstream text{std::string(word)};
    text.imbue(std::locale::classic());
    double value = 0;
    text >> value;
    if (text.fail() || text.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
    // A stream makes zero of what is too small for a double; std::from_chars refuses it.
    const bool zero = word.substr(0, word.find_first_of("eE")).find_first_of("123456789") == std::string_view::npos;
    if (value == 0 && !zero) return std::nullopt;
    return value;
}

// The number a word is, if it is one from end to end.
template <class Number>
std::optional<Number> number(std::string_view word) {
#ifndef __cpp_lib_to_chars
    if constexpr (std::floating_point<Number>) {
        return decimal_number(word);
    } else
#endif
    {
        Number value{};
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
        return value;
    }
}

}  // namespace waybreaker

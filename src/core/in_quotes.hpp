// Quotes text from outside in messages.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker {

// A word from outside for an error message: its first characters, without control characters.
inline std::string in_quotes(std::string_view word) {
    constexpr std::size_t most = 32;
    std::string text = "'";
    for (const char c : word.substr(0, most)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + (word.size() > most ? "...'" : "'");
}

}  // namespace waybreaker

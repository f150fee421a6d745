// Quotes text from outside in messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/control_character.hpp"
#include "core/utf8.hpp"

namespace waybreaker {

// A word from outside for an error message: its first bytes, without control characters and what is not UTF-8.
inline std::string in_quotes(std::string_view word) {
    constexpr std::size_t most = 32;
    std::string text = "'";
    while (!word.empty() && text.size() <= most) {
        const std::size_t control = control_length(word);
        const auto character = control > 0 ? std::nullopt : first_character(word);
        const std::size_t length = character ? character->length : std::max(control, std::size_t{1});
        text += character ? word.substr(0, length) : "?";
        word.remove_prefix(length);
    }
    return text + (word.empty() ? "'" : "...'");
}

}  // namespace waybreaker

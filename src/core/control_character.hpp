// Control characters in text from outside: they are not seen, and change how what follows them is shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/utf8.hpp"

namespace waybreaker {

// Bytes of the control character that UTF-8 text begins with; 0 if it begins with none. Beside those of ASCII and
// Latin-1 these are the ends of lines and paragraphs, and what turns the direction of writing (Unicode's annex 9, 2.1
// to 2.5), by which one name can be made to look like another.
inline std::size_t control_length(std::string_view text) {
    if (text.empty()) return 0;
    const std::optional<Utf8Character> character = first_character(text);
    if (!character) return 0;
    const auto lies_in = [&](std::uint32_t first, std::uint32_t last) {
        return first <= character->code && character->code <= last;
    };
    const bool is_control =
        lies_in(0, 0x1F) || lies_in(0x7F, 0x9F) || lies_in(0x2028, 0x202E) || lies_in(0x2066, 0x2069);
    return is_control ? character->length : 0;
}

}  // namespace waybreaker

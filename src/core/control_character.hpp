// Control characters in text from outside: they are not seen, and change how what follows them is shown.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace waybreaker {

// Bytes of the control character that UTF-8 text begins with; 0 if it begins with none. Beside those of ASCII and
// Latin-1 these are the ends of lines and paragraphs, and what turns the direction of writing (Unicode's annex 9, 2.1
// to 2.5), by which one name can be made to look like another.
inline std::size_t control_length(std::string_view text) {
    struct Range {
        std::string_view first;
        std::string_view last;
    };
    constexpr std::array<Range, 5> ranges{{{{"\x00", 1}, "\x1F"},
                                           {"\x7F", "\x7F"},
                                           {"\xC2\x80", "\xC2\x9F"},            // U+0080 to U+009F
                                           {"\xE2\x80\xA8", "\xE2\x80\xAE"},    // U+2028 to U+202E
                                           {"\xE2\x81\xA6", "\xE2\x81\xA9"}}};  // U+2066 to U+2069
    for (const auto& [first, last] : ranges) {
        const std::string_view character = text.substr(0, first.size());
        if (character.size() == first.size() && first <= character && character <= last) return first.size();
    }
    return 0;
}

}  // namespace waybreaker

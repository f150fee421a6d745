// The beginning of a foreign text, for an error message.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::io {

// Enough for what people type, and for nearly every path.
inline constexpr std::size_t most_excerpt = 200;

// The text itself if it is short; else its first bytes and "...", never half a UTF-8 character.
inline std::string excerpt(std::string_view text, std::size_t most = most_excerpt) {
    if (text.size() <= most) return std::string(text);
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0U) == 0x80U) --most;
    return std::string(text.substr(0, most)) + "...";
}

}  // namespace waybreaker::io

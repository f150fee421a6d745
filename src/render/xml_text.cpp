#include "render/xml_text.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/utf8.hpp"

namespace waybreaker::render {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD
constexpr std::string_view ellipsis = "\xE2\x80\xA6";     // U+2026

// XML 1.0, section 2.2, without the discouraged control characters; tabs and line ends are none of a caption's.
bool is_shown(std::uint32_t code) {
    if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return false;
    return code < 0xFFFE || code > 0xFFFF;
}

// Length of the UTF-8 sequence that `bytes` begins with, or 0 if there is none that may be shown.
std::size_t character_length(std::string_view bytes) {
    const std::optional<Utf8Character> character = first_character(bytes);
    return character && is_shown(character->code) ? character->length : 0;
}

std::string escaped(std::string_view character) {
    if (character == "&") return "&amp;";
    if (character == "<") return "&lt;";
    if (character == ">") return "&gt;";
    if (character == "\"") return "&quot;";
    if (character == "'") return "&#39;";
    return std::string(character);
}

}  // namespace

std::string xml_text(std::string_view bytes, std::size_t most) {
    std::string text;
    for (std::size_t characters = 0; !bytes.empty(); ++characters) {
        if (characters == most) return text += ellipsis;
        const std::size_t length = character_length(bytes);
        text += length == 0 ? std::string(replacement) : escaped(bytes.substr(0, length));
        bytes.remove_prefix(length == 0 ? 1 : length);
    }
    return text;
}

std::size_t letter_count(std::string_view bytes) {
    return std::size_t(
        std::count_if(bytes.begin(), bytes.end(), [](char byte) { return (std::uint8_t(byte) & 0xC0U) != 0x80U; }));
}

}  // namespace waybreaker::render

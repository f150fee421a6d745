// UTF-8 (RFC 3629).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace waybreaker {

struct Utf8Character {
    std::uint32_t code = 0;
    std::size_t length = 1;  // in bytes
};

// The character that `bytes`, which are not empty, begin with; none if that is not UTF-8.
inline std::optional<Utf8Character> first_character(std::string_view bytes) {
    const auto byte = [&](std::size_t i) { return std::uint8_t(bytes[i]); };
    if (byte(0) < 0x80) return Utf8Character{byte(0), 1};
    const std::size_t length = std::size_t(std::countl_one(byte(0)));
    if (length < 2 || length > 4 || length > bytes.size()) return std::nullopt;
    std::uint32_t code = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return std::nullopt;
        code = code << 6U | (byte(i) & 0x3FU);
    }
    constexpr std::uint32_t least_code[] = {0, 0, 0x80, 0x800, 0x10000};  // below: an overlong form
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < least_code[length] || surrogate || code > 0x10FFFF) return std::nullopt;
    return Utf8Character{code, length};
}

// How many bytes come before the first that is not UTF-8.
inline std::size_t utf8_prefix(std::string_view bytes) {
    std::size_t length = 0;
    while (length < bytes.size()) {
        const std::optional<Utf8Character> character = first_character(bytes.substr(length));
        if (!character) break;
        length += character->length;
    }
    return length;
}

inline bool is_utf8(std::string_view bytes) {
    return utf8_prefix(bytes) == bytes.size();
}

}  // namespace waybreaker

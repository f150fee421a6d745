// Messages of libraries, which can quote any amount of a file, as one line of ours.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace waybreaker {

// Its beginning, without control characters, and not cut within a character of UTF-8.
inline std::string one_line(std::string_view message) {
    constexpr std::size_t most = 300;
    std::size_t end = std::min(message.size(), most);
    while (end < message.size() && end > 0 && (static_cast<unsigned char>(message[end]) & 0xC0U) == 0x80) --end;
    std::string line = std::string(message.substr(0, end)) + (end < message.size() ? "..." : "");
    std::ranges::replace_if(
        line, [](unsigned char c) { return c < ' '; }, ' ');
    return line;
}

}  // namespace waybreaker

// Reads the texts of metadata items piece by piece.
#pragma once

#include <algorithm>
#include <string_view>

namespace waybreaker::labels {

// Up to the next of these characters, which goes as well.
inline std::string_view take_until(char end, std::string_view& text) {
    const std::size_t at = std::min(text.find(end), text.size());
    const std::string_view taken = text.substr(0, at);
    text.remove_prefix(std::min(at + 1, text.size()));
    return taken;
}

}  // namespace waybreaker::labels

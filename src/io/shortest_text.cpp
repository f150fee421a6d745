#include "io/shortest_text.hpp"

#include <array>
#include <charconv>

namespace waybreaker::io {

std::string shortest_text(double value) {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), end};
}

}  // namespace waybreaker::io

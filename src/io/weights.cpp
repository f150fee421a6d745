#include "io/weights.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/output_file.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

constexpr std::string_view blanks = " \t\r";

// The next word of a line, which loses it; empty at its end.
std::string_view next_word(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, std::min(line.find_first_of(blanks), line.size()));
    line.remove_prefix(word.size());
    return word;
}

template <class Number>
std::optional<Number> number(std::string_view word) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

}  // namespace

std::vector<double> read_weights(const std::string& path, const Map& map) {
    const std::string text = read_whole(path, std::size_t{1} << 28);
    std::vector<double> weights(map.obstacles().size() + 1, 1);
    std::vector<bool> named(weights.size(), false);
    std::size_t number_of_line = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        ++number_of_line;
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = std::string_view(text).substr(begin, end - begin);
        begin = end + 1;
        line = line.substr(0, line.find('#'));
        const std::string_view first = next_word(line);
        if (first.empty()) continue;
        const std::optional<std::uint32_t> id = number<std::uint32_t>(first);
        const std::optional<double> weight = number<double>(next_word(line));
        const auto fail = [&](const std::string& what) { throw InputError(path, number_of_line, what); };
        if (!id || !weight || !next_word(line).empty()) fail("expected an obstacle and its weight, such as \"17 2.5\"");
        if (*id < 1 || *id >= weights.size()) {
            fail("there is no obstacle " + std::to_string(*id) + "; the map has " + std::to_string(weights.size() - 1));
        }
        if (!(*weight > 0) || !std::isfinite(*weight)) fail("a weight must be a positive number");
        if (named[*id]) fail("obstacle " + std::to_string(*id) + " has a weight already");
        named[*id] = true;
        weights[*id] = *weight;
    }
    return weights;
}

}  // namespace waybreaker::io

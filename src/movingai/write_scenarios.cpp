// MovingAI scenarios as text. The length has the eight decimals of the published files.
#include <algorithm>
#include <array>
#include <charconv>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

void require_one_word(const std::string& map) {
    const auto ends_a_column = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
    if (!map.empty() && std::ranges::none_of(map, ends_a_column)) return;
    throw InputError("the map " + in_quotes(map) +
                     " cannot stand in a scenario file, whose columns end at blanks: rename the file or its folder");
}

std::string decimals(double value) {
    std::array<char, 400> text;  // the largest double has 309 digits before the point
    char* const end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 8).ptr;
    return {text.data(), end};
}

}  // namespace

std::string movingai_scenarios(std::span<const Scenario> scenarios) {
    std::string text = "version 1\n";
    for (const Scenario& scenario : scenarios) {
        require_one_word(scenario.map);
        text += std::to_string(scenario.bucket);
        text.append(1, '\t').append(scenario.map);
        for (const int number :
             {scenario.width, scenario.height, scenario.start.x, scenario.start.y, scenario.goal.x, scenario.goal.y}) {
            text.append(1, '\t').append(std::to_string(number));
        }
        text.append(1, '\t').append(decimals(scenario.optimal_length)).append(1, '\n');
    }
    return text;
}

}  // namespace waybreaker

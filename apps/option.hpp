// Options with values, read strictly: the whole text must be what it should be, and an error names the option.
//
// The type name of an option says what it takes, to people and to shell completion alike: a placeholder in capitals
// ("FILE", "X,Y") or the words to choose from ("makespan|flowtime").
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/map_file.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::apps {

// What was given, in an error: its beginning.
std::string shown(std::string_view given);

// The number that a text is, from end to end.
std::optional<double> number_from(std::string_view text);

// The share from 0 to 1 that a text is, as such or in per cent: "0.005", "0.5%".
std::optional<double> share_from(std::string_view text);

// "12,20"
CLI::Option* add_cell(CLI::App& app, const std::string& name, std::optional<Cell>& value, const std::string& text);

// "13.41,52.52"
CLI::Option* add_lon_lat(CLI::App& app, const std::string& name, double& lon, double& lat, const std::string& text);

// "13.37,52.51,13.41,52.53": west, south, east, north
CLI::Option* add_box(CLI::App& app, const std::string& name, std::optional<std::array<double, 4>>& value,
                     const std::string& text);

// A whole number from `least` to `most`.
CLI::Option* add_count(CLI::App& app, const std::string& name, const std::function<void(std::int64_t)>& assign,
                       std::int64_t least, std::int64_t most, const std::string& text);

struct Range {
    double least;
    double most;
};

// A number from a range.
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::function<void(double)>& assign, Range range,
                        const std::string& type, const std::string& text);

// A share.
CLI::Option* add_share(CLI::App& app, const std::string& name, double& value, const std::string& text);

// A number of cells, from 0 to `most`.
CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& value, double most,
                        const std::string& text);

// Ids of obstacles: "17,4".
CLI::Option* add_obstacles(CLI::App& app, const std::string& name, std::vector<ObstacleId>& value,
                           const std::string& text);

// The name of a file, not empty. Of an option `type` is what help calls it.
CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& value, const std::string& text,
                      const std::string& type = "FILE");

// A word that is not empty.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& type,
                      const std::string& text);

// The names of files, at least one.
CLI::Option* add_files(CLI::App& app, const std::string& name, std::vector<std::string>& value,
                       const std::string& text);

// One of the words, given by its position to `assign`.
CLI::Option* add_word(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
                      const std::function<void(std::size_t)>& assign, const std::string& text);

// One of some values by name; the first is the default.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const Choices<Value>& choices, Target& target,
                        const std::string& text) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back(choice.first);
    const auto assign = [choices, &target](std::size_t i) { target = choices[i].second; };
    return add_word(app, name, words, assign, text);
}

// The same, given to `assign`.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, const Choices<Value>& choices,
                        const std::type_identity_t<std::function<void(Value)>>& assign, const std::string& text) {
    std::vector<std::string> words;
    for (const auto& choice : choices) words.push_back(choice.first);
    return add_word(
        app, name, words, [choices, assign](std::size_t i) { assign(choices[i].second); }, text);
}

// How blocked cells make obstacles.
CLI::Option* add_connectivity(CLI::App& app, Connectivity& value);

// What blocks in maps that are images.
void add_image_reading(CLI::App& app, io::ImageReading& value);

// The words an option offers; empty if it takes something else.
std::vector<std::string> words_of(const CLI::Option& option);

}  // namespace waybreaker::apps

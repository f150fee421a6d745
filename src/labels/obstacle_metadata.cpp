#include "labels/obstacle_metadata.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "waybreaker/error.hpp"

namespace waybreaker::labels {
namespace {

constexpr const char* obstacles_item = "WAYBREAKER_OBSTACLES";
constexpr const char* weights_item = "WAYBREAKER_WEIGHTS";
constexpr const char* breach_times_item = "WAYBREAKER_BREACH_TIMES";

// That an entry, the last of so many, is not what it should be.
InputError refusal(const std::string& name, const char* item, std::size_t entry, const char* what) {
    return InputError(
        fmt::format("{}: entry {} of its metadata item {} is no {}; drop the item with 'gdal_edit.py "
                    "-unsetmd' or import the map anew",
                    name, entry, item, what));
}

// Goes past a number and the comma after it, which must not be the end; false if there is something else.
template <class Number>
bool take_number(std::string_view& text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool separated = rest != end && *rest == ',' && rest + 1 != end;
    if (error != std::errc() || (rest != end && !separated)) return false;
    text.remove_prefix(std::size_t(rest - text.data()) + (separated ? 1 : 0));
    return true;
}

// Empty if there is nothing to write.
std::string obstacles_text(const Map& map) {
    std::string text;
    // Else a single obstacle would be read as a mask.
    bool worth_writing = map.obstacles().size() == 1;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (!text.empty()) text += ',';
        text += fmt::format("{}{}", obstacle.destructible ? "" : "!", obstacle.source_id);
        worth_writing = worth_writing || !obstacle.destructible || obstacle.source_id != 0;
    }
    return worth_writing ? text : "";
}

std::vector<ObstacleAttributes> parse_obstacles(std::string_view text, const std::string& name) {
    std::vector<ObstacleAttributes> attributes(1);
    while (!text.empty()) {
        ObstacleAttributes& obstacle = attributes.emplace_back();
        if (text.front() == '!') {
            obstacle.destructible = false;
            text.remove_prefix(1);
        }
        if (!take_number(text, obstacle.source_id)) {
            throw refusal(name, obstacles_item, attributes.size() - 1, "source id");
        }
    }
    return attributes;
}

// A number of each obstacle, in id order, between commas; empty if each has the usual one.
std::string numbers_text(const Map& map, double Obstacle::*number, double usual) {
    std::string text;
    bool worth_writing = false;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (!text.empty()) text += ',';
        text += fmt::format("{}", obstacle.*number);
        worth_writing = worth_writing || obstacle.*number != usual;
    }
    return worth_writing ? text : "";
}

// Reads them into the attributes, and as many new ones as it takes.
void parse_numbers(std::string_view text, double ObstacleAttributes::*number, double least, const char* item,
                   const std::string& name, std::vector<ObstacleAttributes>& attributes) {
    for (std::size_t label = 1; !text.empty(); ++label) {
        if (label == attributes.size()) attributes.emplace_back();
        double& value = attributes[label].*number;
        if (!take_number(text, value) || !std::isfinite(value) || !(value >= least)) {
            throw refusal(name, item, label, least > 0 ? "number above 0" : "number of at least 0");
        }
    }
}

}  // namespace

std::vector<std::pair<const char*, std::string>> obstacle_metadata(const Map& map) {
    std::vector<std::pair<const char*, std::string>> items{
        {obstacles_item, obstacles_text(map)},
        {weights_item, numbers_text(map, &Obstacle::weight, 1)},
        {breach_times_item, numbers_text(map, &Obstacle::breach_time, 0)}};
    std::erase_if(items, [](const auto& item) { return item.second.empty(); });
    return items;
}

std::vector<ObstacleAttributes> read_obstacle_metadata(const MetadataItems& items, const std::string& name) {
    std::vector<ObstacleAttributes> attributes = parse_obstacles(items(obstacles_item), name);
    parse_numbers(items(weights_item), &ObstacleAttributes::weight, std::numeric_limits<double>::min(), weights_item,
                  name, attributes);
    parse_numbers(items(breach_times_item), &ObstacleAttributes::breach_time, 0, breach_times_item, name, attributes);
    return attributes;
}

}  // namespace waybreaker::labels

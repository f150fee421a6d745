#include "io/tagged_obstacles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

constexpr std::string_view name_key = "name";

bool is_called(const MapFile& map, ObstacleId id, const site::TagFilter& filter) {
    const auto fits = [&filter](const std::string& name) { return !name.empty() && filter.accepts(name); };
    const site::Sections& sections = map.annotations.sections;
    if (sections.empty() || sections.parts[id.value].empty()) return fits(std::string(map.annotations.name_of(id)));
    return std::ranges::any_of(sections.parts[id.value],
                               [&](std::uint32_t structure) { return fits(sections.structures[structure].name); });
}

std::vector<ObstacleId> called(const MapFile& map, const site::TagFilter& filter) {
    std::vector<ObstacleId> found;
    for (const Obstacle& obstacle : map.map.obstacles()) {
        if (is_called(map, obstacle.id, filter)) found.push_back(obstacle.id);
    }
    return found;
}

// What the map has of that key, the most frequent first: "church, chapel".
std::string values_of(const MapFile& map, const std::string& key) {
    constexpr std::size_t most = 8;
    std::vector<std::pair<std::size_t, std::string>> values;
    for (const auto& [tag, obstacles] : map.annotations.tags) {
        if (tag.starts_with(key + "=")) values.emplace_back(obstacles.size(), tag.substr(key.size() + 1));
    }
    std::ranges::stable_sort(values, std::ranges::greater(), &std::pair<std::size_t, std::string>::first);
    std::vector<std::string> words;
    for (const auto& [count, value] : values) words.push_back(words.size() == most ? "..." : value);
    words.resize(std::min(words.size(), most + 1));
    return fmt::format("{}", fmt::join(words, ", "));
}

InputError nothing_matches(const MapFile& map, const site::TagFilter& filter, const std::string& purpose) {
    const std::string what = fmt::format("nothing to {}: no obstacle of {} ", purpose, map.source);
    if (filter.key == name_key) {
        return InputError(what + "is called " + in_quotes(filter.text().substr(name_key.size() + 1)) +
                          "; a * stands for any text");
    }
    if (map.annotations.tags.empty()) {
        return InputError(what + "has tags such as " + in_quotes(filter.text()) +
                          ": maps that waybreaker import makes for a rover, truck or walker keep them");
    }
    const std::string values = values_of(map, filter.key);
    return InputError(what + "has the tag " + in_quotes(filter.text()) +
                      (values.empty()
                           ? "; maps keep amenity, barrier, building, heritage, historic and tourism, and names"
                           : "; of " + filter.key + " it has " + values));
}

}  // namespace

std::vector<ObstacleId> tagged_obstacles(const MapFile& map, const site::TagFilter& filter) {
    if (filter.key == name_key) return called(map, filter);
    std::vector<ObstacleId> found;
    for (const auto& [tag, obstacles] : map.annotations.tags) {
        const std::size_t equals = tag.find('=');
        const bool fits =
            filter.key == "*" || (tag.compare(0, equals, filter.key) == 0 && filter.accepts(tag.substr(equals + 1)));
        if (fits) found.insert(found.end(), obstacles.begin(), obstacles.end());
    }
    std::ranges::sort(found);
    const auto [first, last] = std::ranges::unique(found);
    found.erase(first, last);
    return found;
}

void add_tagged(const MapFile& map, const std::vector<site::TagFilter>& filters, const std::string& purpose,
                std::vector<ObstacleId>& ids) {
    for (const site::TagFilter& filter : filters) {
        const std::vector<ObstacleId> found = tagged_obstacles(map, filter);
        if (found.empty()) throw nothing_matches(map, filter, purpose);
        ids.insert(ids.end(), found.begin(), found.end());
    }
    if (filters.empty()) return;
    std::ranges::sort(ids);
    const auto [first, last] = std::ranges::unique(ids);
    ids.erase(first, last);
}

}  // namespace waybreaker::io

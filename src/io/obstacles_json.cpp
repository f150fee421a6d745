#include "io/obstacles_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "io/structures_json.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

// By obstacle id; no entries if the map keeps no tags.
using TagsById = std::vector<std::vector<std::string_view>>;

TagsById tags_by_id(const MapFile& file) {
    if (file.annotations.tags.empty()) return {};
    TagsById result(file.map.obstacles().size() + 1);
    for (const auto& [tag, obstacles] : file.annotations.tags) {
        for (const ObstacleId id : obstacles) result[id.value].push_back(tag);
    }
    return result;
}

// What the source of the map says of it, as far as the map keeps that.
void describe(Json& json, const MapFile& file, ObstacleId id, const TagsById& tags) {
    if (!file.annotations.kinds.empty())
        json["kind"] = site::obstacle_kind_words[std::size_t(site::kind_of(file.annotations.kinds, id))];
    if (!tags.empty() && !tags[id.value].empty()) json["tags"] = tags[id.value];
    Json structures = structures_json(id, file.annotations.sections);
    if (!structures.empty()) json["structures"] = std::move(structures);
}

void append_obstacle(std::string& text, const MapFile& file, const Obstacle& obstacle, const TagsById& tags) {
    const Box& box = obstacle.bounds;
    Json json{{"id", obstacle.id.value},
              {"source_id", obstacle.source_id},
              {"name", file.annotations.name_of(obstacle.id)},
              {"cells", obstacle.cells},
              {"bounds", {box.min.x, box.min.y, box.max.x, box.max.y}},
              {"destructible", obstacle.destructible},
              {"weight", obstacle.weight},
              {"breach_time", obstacle.breach_time}};
    describe(json, file, obstacle.id, tags);
    if (!text.empty()) text += ',';
    text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Ids are in the order in which obstacles begin: how many begin before a cell.
std::size_t begun_before(const Map& map, std::size_t cell) {
    const auto labels = map.labels().subspan(0, std::min(cell, map.labels().size()));
    return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end());
}

}  // namespace

ObstaclesPart obstacles_part(const MapFile& file, std::size_t first_cell, std::size_t most_obstacles) {
    constexpr std::size_t runs_per_obstacle = 10;
    const Map& map = file.map;
    const auto labels = map.labels();
    const TagsById tags = tags_by_id(file);
    std::string obstacles;
    std::string runs;  // by hand, for there can be millions
    const std::size_t begun = begun_before(map, first_cell);
    std::size_t known = begun;
    std::size_t count = 0;
    auto run = labels.begin() + std::ptrdiff_t(std::min(first_cell, labels.size()));
    while (run != labels.end() && count / runs_per_obstacle < most_obstacles) {
        if (*run > known) {
            if (known - begun == most_obstacles) break;
            append_obstacle(obstacles, file, map.obstacle(ObstacleId{*run}), tags);
            known = *run;
        }
        const auto end = std::find_if(run, labels.end(), [run](std::uint32_t label) { return label != *run; });
        fmt::format_to(std::back_inserter(runs), "{}{},{}", count == 0 ? "" : ",", *run, end - run);
        ++count;
        run = end;
    }
    ObstaclesPart part;
    if (run != labels.end()) part.next = std::size_t(run - labels.begin());
    part.json = fmt::format(R"({{"width":{},"height":{},"obstacles":[{}],"runs":[{}],"next":{}}})", map.width(),
                            map.height(), obstacles, runs, part.next ? std::to_string(*part.next) : "null") +
                "\n";
    return part;
}

std::string obstacles_json(const MapFile& file) {
    return obstacles_part(file, 0, std::numeric_limits<std::size_t>::max()).json;
}

}  // namespace waybreaker::io

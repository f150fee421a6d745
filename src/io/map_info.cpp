#include "io/map_info.hpp"

#include <algorithm>

#include "io/mission_document.hpp"
#include "site/unknown_ground.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

MapSummary summarise(const Map& map) {
    MapSummary summary;
    for (const Obstacle& obstacle : map.obstacles()) {
        summary.blocked += obstacle.cells;
        if (summary.largest == nullptr || obstacle.cells > summary.largest->cells) summary.largest = &obstacle;
    }
    summary.density = double(summary.blocked) / double(map.grid().cell_count());
    return summary;
}

std::optional<GroundSummary> summarise_ground(const MapFile& file) {
    if (file.annotations.kinds.empty()) return std::nullopt;
    GroundSummary summary{.open = file.map.grid().cell_count()};
    const std::vector<bool> unknown = site::unknown_obstacles(file.map, file.annotations.tags);
    for (const Obstacle& obstacle : file.map.obstacles()) {
        summary.open -= obstacle.cells;
        if (unknown[obstacle.id.value]) {
            summary.unknown += obstacle.cells;
            continue;
        }
        switch (file.annotations.kinds[obstacle.id.value]) {
            case site::ObstacleKind::water:
                summary.water += obstacle.cells;
                break;
            case site::ObstacleKind::cliff:
                summary.cliff += obstacle.cells;
                break;
            case site::ObstacleKind::forbidden:
                summary.forbidden += obstacle.cells;
                break;
            case site::ObstacleKind::off_road:
                summary.off_road += obstacle.cells;
                break;
            default:
                (obstacle.destructible ? summary.destructible : summary.protected_) += obstacle.cells;
        }
    }
    return summary;
}

std::map<std::string, std::size_t> protected_tags(const MapFile& file) {
    std::map<std::string, std::size_t> counts;
    for (const auto& [tag, obstacles] : file.annotations.tags) {
        if (tag == site::unknown_tag) continue;
        const auto stays = [&](ObstacleId id) { return !file.map.obstacle(id).destructible; };
        const auto count = std::size_t(std::ranges::count_if(obstacles, stays));
        if (count > 0) counts.emplace(tag, count);
    }
    return counts;
}

Json map_info(const MapFile& file, const Json& georeference) {
    const MapSummary summary = summarise(file.map);
    const auto cell = [](const std::optional<Cell>& c) { return c ? Json::array({c->x, c->y}) : Json(); };
    Json json{{"source", file.source},       {"format", file.format},       {"width", file.map.width()},
              {"height", file.map.height()}, {"cell_size", file.cell_size}, {"blocked", summary.blocked},
              {"density", summary.density}};
    json["obstacles"] = {{"count", file.map.obstacles().size()},
                         {"named", site::name_count(file.annotations.names)},
                         {"largest", nullptr}};
    if (const Obstacle* largest = summary.largest) {
        json["obstacles"]["largest"] = {{"id", largest->id.value},
                                        {"source_id", largest->source_id},
                                        {"name", file.annotations.name_of(largest->id)},
                                        {"cells", largest->cells}};
    }
    if (!file.annotations.sections.empty()) {
        json["obstacles"]["sections"] = site::section_count(file.annotations.sections);
        json["obstacles"]["structures"] = site::cut_structures(file.annotations.sections).size();
    }
    if (!file.annotations.tags.empty()) {
        Json& tags = json["obstacles"]["tags"];
        for (const auto& [tag, obstacles] : file.annotations.tags) tags[tag] = obstacles.size();
        json["obstacles"]["protected_tags"] = protected_tags(file);
    }
    const std::optional<site::Profile> profile = file.annotations.profile;
    json["profile"] = profile ? Json(site::profile_word(*profile)) : Json();
    json["usual_radius"] = usual_radius(file);
    json["ground"] = nullptr;
    if (const std::optional<GroundSummary> ground = summarise_ground(file)) {
        json["ground"] = {{"open", ground->open},
                          {"destructible", ground->destructible},
                          {"protected", ground->protected_},
                          {"water", ground->water},
                          {"cliff", ground->cliff},
                          {"forbidden", ground->forbidden},
                          {"off_road", ground->off_road},
                          {"unknown", ground->unknown}};
    }
    for (const std::string_view kind : site::background_kinds) json["background"][std::string(kind)] = 0;
    for (const site::Background::Feature& feature : file.annotations.background.features) {
        Json& count = json["background"][std::string(site::background_kinds[std::size_t(feature.kind)])];
        count = count.get<int>() + 1;
    }
    json["unknown"] = file.unknown;
    json["origin"] = file.origin ? Json(*file.origin) : Json();
    json["georeference"] = georeference;
    json["start"] = file.task ? cell(file.task->start) : Json();
    json["goal"] = file.task ? cell(file.task->goal) : Json();
    json["title"] = file.annotations.title;
    json["attribution"] = file.annotations.attribution;
    json["notes"] = file.all_notes();
    json["digest"] = file.digest;
    return json;
}

}  // namespace waybreaker::io

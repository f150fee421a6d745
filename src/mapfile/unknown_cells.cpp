#include "mapfile/unknown_cells.hpp"

namespace waybreaker::mapfile {

std::vector<bool> unknown_obstacles(const io::MapFile& file) {
    std::vector<bool> unknown(file.map.obstacles().size() + 1);
    if (file.ros) {
        // Nothing else of a ROS map cannot be destroyed.
        for (const Obstacle& obstacle : file.map.obstacles()) unknown[obstacle.id.value] = !obstacle.destructible;
    }
    if (const auto tagged = file.annotations.tags.find(unknown_tag); tagged != file.annotations.tags.end()) {
        for (const ObstacleId id : tagged->second) unknown[id.value] = true;
    }
    return unknown;
}

site::Annotations annotations_with_unknown(const io::MapFile& file) {
    site::Annotations known = file.annotations;
    if (!file.ros) return known;
    const std::vector<bool> unknown = unknown_obstacles(file);
    std::vector<ObstacleId> ids;
    for (std::uint32_t id = 1; id < unknown.size(); ++id) {
        if (unknown[id]) ids.push_back({id});
    }
    if (!ids.empty()) known.tags[unknown_tag] = std::move(ids);
    return known;
}

std::uint64_t tagged_unknown_cells(const io::MapFile& file) {
    const auto tagged = file.annotations.tags.find(unknown_tag);
    std::uint64_t cells = 0;
    if (tagged == file.annotations.tags.end()) return cells;
    for (const ObstacleId id : tagged->second) cells += file.map.obstacle(id).cells;
    return cells;
}

}  // namespace waybreaker::mapfile

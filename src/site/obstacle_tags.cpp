#include "site/obstacle_tags.hpp"

#include <algorithm>

#include "site/first_cells.hpp"

namespace waybreaker::site {

std::unordered_map<std::uint32_t, std::vector<const std::string*>> by_label(const LabelTags& tags) {
    std::unordered_map<std::uint32_t, std::vector<const std::string*>> result;
    for (const auto& [tag, labels] : tags) {
        for (const std::uint32_t label : labels) result[label].push_back(&tag);
    }
    return result;
}

std::vector<LabelOfCell> tagged_cells(const LabelTags& tags, std::span<const std::uint32_t> labels) {
    std::unordered_map<std::uint32_t, std::uint32_t> tagged;
    for (const auto& [tag, list] : tags) {
        for (const std::uint32_t label : list) tagged.emplace(label, label);
    }
    return first_cells<LabelOfCell>(std::move(tagged), labels);
}

ObstacleTags obstacle_tags(const Map& map, const LabelTags& tags, const std::vector<LabelOfCell>& cells) {
    std::unordered_map<std::uint32_t, ObstacleId> ids;
    for (const auto& [cell, label] : cells) ids[label] = ObstacleId{map.labels()[cell]};
    ObstacleTags result;
    for (const auto& [tag, labels] : tags) {
        std::vector<ObstacleId> found;
        for (const std::uint32_t label : labels) {
            if (const auto id = ids.find(label); id != ids.end()) found.push_back(id->second);
        }
        std::ranges::sort(found, {}, &ObstacleId::value);
        const auto [first, last] = std::ranges::unique(found);
        found.erase(first, last);
        if (!found.empty()) result.emplace(tag, std::move(found));
    }
    return result;
}

}  // namespace waybreaker::site

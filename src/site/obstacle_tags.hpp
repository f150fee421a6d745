// Tags of the obstacles of a map, as its source has them: by these people find hospitals, whose numbers they do not
// know.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::site {

// By tag, such as "building=church": the obstacles that have it, ascending. A section has the tags of all that it is a
// part of.
using ObstacleTags = std::map<std::string, std::vector<ObstacleId>>;

// By the number in a label layer, before the map renumbers its obstacles.
using LabelTags = std::map<std::string, std::vector<std::uint32_t>>;

// The tags of each label that has any; they must outlive the result.
std::unordered_map<std::uint32_t, std::vector<const std::string*>> by_label(const LabelTags& tags);

struct LabelOfCell {
    std::size_t cell;  // row by row
    std::uint32_t label;
};

// The first cell of each label that has tags.
std::vector<LabelOfCell> tagged_cells(const LabelTags& tags, std::span<const std::uint32_t> labels);

// The tags of the obstacles at these cells.
ObstacleTags obstacle_tags(const Map& map, const LabelTags& tags, const std::vector<LabelOfCell>& cells);

}  // namespace waybreaker::site

// What the obstacles of a map are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::site {

// cliff: steps of the ground: cliffs, retaining walls, ditches, sides of bridges. forbidden: ground that the rules of a
// profile close. off_road: ground beside the roads that a profile keeps to.
enum class ObstacleKind : std::uint8_t { unknown, building, barrier, water, cliff, forbidden, off_road };

// What files call the kinds, in their order.
inline constexpr std::array<std::string_view, 7> obstacle_kind_words{"unknown", "building",  "barrier", "water",
                                                                     "cliff",   "forbidden", "off_road"};

// Unknown if no kind is called that.
ObstacleKind kind_called(std::string_view word);

// By obstacle id, entry 0 unused. No entries at all if nothing is known of any.
using ObstacleKinds = std::vector<ObstacleKind>;

inline ObstacleKind kind_of(const ObstacleKinds& kinds, ObstacleId id) {
    return kinds.empty() ? ObstacleKind::unknown : kinds[id.value];
}

// By the number in a label layer, before the map renumbers its obstacles.
using LabelKinds = std::unordered_map<std::uint32_t, ObstacleKind>;

struct KindOfCell {
    std::size_t cell;  // row by row
    ObstacleKind kind;
};

// The first cell of each label whose kind is known.
std::vector<KindOfCell> kinds_of_cells(LabelKinds kinds, std::span<const std::uint32_t> labels);

// The kinds of the obstacles at these cells.
ObstacleKinds obstacle_kinds(const Map& map, const std::vector<KindOfCell>& cells);

// Cells of the map by kind, in the order of the words.
std::array<std::uint64_t, obstacle_kind_words.size()> cells_by_kind(const Map& map, const ObstacleKinds& kinds);

}  // namespace waybreaker::site

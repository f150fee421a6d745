// Labels of cells, and what they stand for: what label maps are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "site/obstacle_kinds.hpp"
#include "site/obstacle_names.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::geo {

struct Labelled {
    std::vector<std::uint32_t> labels;
    std::vector<ObstacleAttributes> attributes;  // by label, entry 0 unused
    site::LabelNames names;
    site::LabelKinds kinds;
};

// Joins what touches (4-connected, as the paper does) of the labels that `joins`: each takes the source id of the one
// that owns most of its cells, of the first one among equals, and likewise the name of one that has a name. What one of
// them forbids holds for all; breach times add up, and weights where they are `weighed`. Other labels stay as they are.
Labelled merged(const Labelled& cells, const std::vector<bool>& joins, int width, int height, bool weighed);

}  // namespace waybreaker::geo

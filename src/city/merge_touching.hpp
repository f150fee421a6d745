// Obstacles as in the paper: buildings that touch are one.
#pragma once

#include <vector>

#include "site/described_map.hpp"

namespace waybreaker::city {

// Joins what touches (4-connected, as the paper does) of the labels that `joins`: each takes the source id of the one
// that owns most of its cells, of the first one among equals, and likewise the name of one that has a name. What one of
// them forbids holds for all; breach times add up, and weights where they are `weighed`. Other labels stay as they are.
site::LabelLayer merged(const site::LabelLayer& cells, const std::vector<bool>& joins, bool weighed);

}  // namespace waybreaker::city

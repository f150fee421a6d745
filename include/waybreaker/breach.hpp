// Breach: which obstacles to remove.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

// The n destructible obstacles with the most hits (paper, section 3), most hits first; equal counts: the smaller id. An
// obstacle without a hit is never chosen, so there may be fewer than n. `hits` is SearchResult::hits.
std::vector<ObstacleId> most_hit(const Map& map, std::span<const std::uint32_t> hits, int n);

}  // namespace waybreaker

// The figures that sum up a map.
#pragma once

#include <cstdint>

#include "waybreaker/map.hpp"

namespace waybreaker::apps {

struct MapSummary {
    std::uint64_t blocked = 0;          // cells
    double density = 0;                 // blocked cells, as a share of all
    const Obstacle* largest = nullptr;  // of several the first; null if there is no obstacle. The map must outlive it.
};

MapSummary summarise(const Map& map);

}  // namespace waybreaker::apps

// What attributes say of an obstacle.
#pragma once

#include <string>

#include "core/range.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

// Throws InputError if a weight or time is out of range; `whose` ends "the weight".
inline void describe(Obstacle& obstacle, const ObstacleAttributes& given, const std::string& whose) {
    require_range(given.weight, least_weight, most_weight, "the weight " + whose);
    require_range(given.breach_time, 0, most_breach_time, "the breach time " + whose);
    obstacle.destructible = given.destructible;
    obstacle.source_id = given.source_id;
    obstacle.weight = given.weight;
    obstacle.breach_time = given.breach_time;
}

}  // namespace waybreaker

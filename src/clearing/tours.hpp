// The tours that are tried: those one change away from others.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "clearing/clearing_drive.hpp"

namespace waybreaker::clearing {

// One for each vehicle that clears; none has what another has.
using Tours = std::vector<Tour>;

// With one obstacle more, one less, one in another place, or another one instead: those that breach no more than
// `most` together, and tours[i] no more than capacities[i]. Obstacles are of the pool. In a fixed order, each once.
std::vector<Tours> neighbours(const Tours& tours, std::span<const ObstacleId> pool, std::span<const int> capacities,
                              int most);

// The rules for all others where vehicles breach these; empty where they may not, or what must be removed is left to
// nobody.
std::optional<Rules> rules_beside(const Map& map, const Mission& mission, const Tours& tours);

// Whether nothing else is breached than these.
bool are_all_in(std::span<const ObstacleId> obstacles, const Tours& tours);

// All that are breached, in id order.
std::vector<ObstacleId> obstacles_of(const Tours& tours);

}  // namespace waybreaker::clearing

// The way of one agent that breaks what is in its way, by the crossing search with a price for each obstacle.
#pragma once

#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/path_through.hpp"

namespace waybreaker {

PathThrough path_through(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal, const BreakingCost& cost,
                         const PathThroughOptions& options);

}  // namespace waybreaker

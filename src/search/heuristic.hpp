// Heuristics: estimates of the cost to go, in cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "search/surroundings.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {

inline double estimate(Heuristic heuristic, Cell from, Cell to) {
    const int dx = std::abs(to.x - from.x);
    const int dy = std::abs(to.y - from.y);
    switch (heuristic) {
        case Heuristic::euclidean:
            return distance(from, to);
        case Heuristic::octile:
            return std::max(dx, dy) + (diagonal_cost - 1) * std::min(dx, dy);
        case Heuristic::chebyshev:
            return std::max(dx, dy);
        case Heuristic::manhattan:
            return dx + dy;
        case Heuristic::zero:
            return 0;
    }
    return 0;
}

}  // namespace waybreaker

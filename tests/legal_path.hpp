// Judges a ground path from the map alone, with the slow line of sight.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "plain_map.hpp"
#include "slow_sight.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {

// What is wrong with a search's path; empty if nothing is. Theta* and Lazy Theta* drive straight in any direction, the
// others from neighbour to neighbour.
inline std::string path_fault(const PlainMap& map, Cell start, Cell goal, const SearchOptions& options,
                              const SearchResult& result) {
    const std::vector<Cell>& path = result.path;
    if (result.status != SearchStatus::found) return path.empty() ? "" : "a path without success";
    if (path.empty() || path.front() != start || path.back() != goal) return "it does not lead from start to goal";
    const bool any_angle = options.planner == Algorithm::theta || options.planner == Algorithm::lazy_theta;
    const auto place = [](Cell c) { return std::to_string(c.x) + "," + std::to_string(c.y); };
    if (!slow::sees(map, start, start, options.body)) return "it starts where the agent cannot stand";
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Cell a = path[i - 1];
        const Cell b = path[i];
        const std::string where = "from " + place(a) + " to " + place(b) + " ";
        length += std::hypot(b.x - a.x, b.y - a.y);
        if (a == b) return where + "it stands still";
        if (any_angle) {
            if (!slow::sees(map, a, b, options.body)) return where + "it is blocked";
            continue;
        }
        const int dx = b.x - a.x;
        const int dy = b.y - a.y;
        const int steps = std::max(std::abs(dx), std::abs(dy));
        const bool diagonal = dx != 0 && dy != 0;
        if (diagonal && (std::abs(dx) != std::abs(dy) || !options.diagonal)) return where + "there is no step";
        for (int k = 0; k < steps; ++k) {
            const Cell from{a.x + k * dx / steps, a.y + k * dy / steps};
            const Cell to{a.x + (k + 1) * dx / steps, a.y + (k + 1) * dy / steps};
            if (!slow::sees(map, from, to, options.body)) return where + "a step is blocked at " + place(from);
        }
    }
    if (std::abs(length - result.length) > 1e-9 * (1 + length)) return "its length is " + std::to_string(length);
    return "";
}

}  // namespace waybreaker

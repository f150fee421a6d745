// Path through: the cheapest way of one agent that breaks by itself what is in its way. "Which wall do I break?"
//
//     PathThrough way = planner.path_through(map, {1, 1}, {60, 40}, [](const Obstacle& wall) { return 2.0 * wall.cells;
//     }); if (!way.broken.empty()) attack(way.broken.front().obstacle);
#pragma once

#include <functional>
#include <vector>

#include "waybreaker/body.hpp"
#include "waybreaker/cell.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// What it costs to break an obstacle, in cells that could be driven instead: the time that it takes, times the speed.
// At least 0; infinity: it is not broken. Asked once of each obstacle that is destructible and not gone.
using BreakingCost = std::function<double(const Obstacle&)>;

struct PathThroughOptions {
    Body body = {};         // with corners `none`
    int most = any_number;  // how many obstacles it may break, >= 0: the fewer, the sooner the search ends
    double weight = 1;      // above 1: any way that costs at most so many times the least, found sooner
    Limits limits = {};     // of a single search
};

// An obstacle on the way, and where the agent stands to break it: it touches the obstacle there for the first time.
struct Broken {
    ObstacleId obstacle;
    Point at;
    double cost = 0;  // cells
};

struct PathThrough {
    // `not_found`: as CrossingResult::status.
    PlanStatus status = PlanStatus::no_plan;
    std::vector<Point> path;     // turning points from start to goal; empty unless there is a way
    std::vector<Broken> broken;  // in the order of the path, each once
    double length = 0;           // cells
    double cost = 0;             // cells: the length, and what is broken
    // No way costs less, for a point, or the unit square that stands for a disc of radius up to 0.5 (exact.md).
    double bound = 0;
};

}  // namespace waybreaker

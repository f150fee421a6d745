// How an agent that is under way already gets to its start: anywhere, so in reals. What it touches is looked for in
// short pieces, with a hair's breadth to spare.
#include <cmath>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double piece = 0.05;  // cells
constexpr double spare = 1e-3;  // cells

// From a place to the square of a cell.
double away(double x, double y, Cell c) {
    return std::hypot(std::max(std::abs(x - c.x) - 0.5, 0.0), std::max(std::abs(y - c.y) - 0.5, 0.0));
}

}  // namespace

Violations judge_approach(const Map& map, const Plan& plan, const Itinerary& ground, std::size_t points,
                          const Terms& terms) {
    const std::vector<double> standing = standing_until(map, plan, terms);
    const double radius = terms.body.reach();
    for (std::size_t i = 1; i < points; ++i) {
        const Waypoint& a = ground.path[i - 1];
        const Waypoint& b = ground.path[i];
        const int pieces = int(std::hypot(b.x - a.x, b.y - a.y) / piece) + 1;
        for (int k = 0; k <= pieces; ++k) {
            const double share = double(k) / pieces;
            const double x = a.x + share * (b.x - a.x);
            const double y = a.y + share * (b.y - a.y);
            const double time = a.t + share * (b.t - a.t);
            for (int cy = int(std::floor(y - radius)); cy <= int(std::ceil(y + radius)); ++cy) {
                for (int cx = int(std::floor(x - radius)); cx <= int(std::ceil(x + radius)); ++cx) {
                    const bool inside = radius == 0 ? std::abs(x - cx) < 0.5 - spare && std::abs(y - cy) < 0.5 - spare
                                                    : away(x, y, {cx, cy}) < radius - spare;
                    if (!inside) continue;
                    const bool on_map = cx >= 0 && cy >= 0 && cx < map.width() && cy < map.height();
                    const ObstacleId obstacle = on_map ? map.obstacle_at({cx, cy}) : ObstacleId{};
                    if (on_map &&
                        (!obstacle || time + slack(terms, time) + piece / ground.speed >= standing[obstacle.value]))
                        continue;
                    return {{Rule::collision,
                             "the " + ground.id + " agent touches " + text(obstacle) + " on the way to its start",
                             ground.id, obstacle, Point(x, y), time}};
                }
            }
        }
    }
    return {};
}

}  // namespace waybreaker::checker

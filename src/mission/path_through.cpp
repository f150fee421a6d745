#include "mission/path_through.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/stopwatch.hpp"
#include "mission/plan_status.hpp"
#include "model/timeline.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// A way that breaks few obstacles is found soon, and what costs more need not be looked at: half the time of a search
// without, in levels of rooms.
constexpr int few = 3;
constexpr double weight_of_few = 1.1;

double cost_of(const Obstacle& obstacle, const BreakingCost& cost) {
    if (!obstacle.destructible || obstacle.gone()) return 0;
    const double cells = cost(obstacle);
    if (cells >= 0) return cells;
    throw InputError("the cost of breaking obstacle " + std::to_string(obstacle.id.value) +
                     " must be a number, at least 0");
}

// In the order in which the agent comes to them. The square that stands for the disc may cross what the disc passes by.
std::vector<Broken> broken_on(const Map& map, const CrossingPath& way, std::span<const double> costs, double radius) {
    const std::vector<Waypoint> drive = timed(way.path, 1);
    std::vector<std::pair<double, Broken>> met;
    for (const ObstacleId obstacle : way.crossed) {
        const auto touch = first_touch_on(map, obstacle, drive, radius);
        if (!touch) continue;
        met.push_back({touch->time, {obstacle, place_of(way.path, *touch), costs[obstacle.value]}});
    }
    std::ranges::stable_sort(met, {}, &std::pair<double, Broken>::first);
    std::vector<Broken> broken;
    for (const auto& [time, obstacle] : met) broken.push_back(obstacle);
    return broken;
}

}  // namespace

PathThrough path_through(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal, const BreakingCost& cost,
                         const PathThroughOptions& options) {
    std::vector<double> costs{0};
    std::vector<ObstacleId> stay;
    for (const Obstacle& obstacle : map.obstacles()) {
        costs.push_back(cost_of(obstacle, cost));
        if (costs.back() < std::numeric_limits<double>::infinity()) continue;
        costs.back() = 0;
        stay.push_back(obstacle.id);
    }
    const Deadline deadline(options.limits.seconds);
    const int most = std::min(options.most, int(map.obstacles().size()));
    CrossingOptions asked{
        .body = options.body, .protect = stay, .prices = costs, .weight = options.weight, .limits = options.limits};
    CrossingPath known;
    if (most > few) {
        CrossingOptions soon = asked;
        soon.crossings = few;
        soon.weight = std::max(options.weight, weight_of_few);
        known = searcher.find(map, start, goal, soon).best;
        if (!known.path.empty()) asked.length_limit = known.cost * (1 + 1e-9);
        asked.limits.seconds = deadline.left();
    }
    asked.crossings = most;
    const CrossingResult found = searcher.find(map, start, goal, asked);
    const CrossingPath& best = found.best.path.empty() ? known : found.best;
    PathThrough way;
    way.status = plan_status(found.status);
    way.bound = found.lower_bound;
    way.path = best.path;
    way.broken = broken_on(map, best, costs, standing_radius(options.body));
    way.length = best.length;
    way.cost = best.length;
    for (const Broken& broken : way.broken) way.cost += broken.cost;
    return way;
}

}  // namespace waybreaker

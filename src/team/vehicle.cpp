#include "team/vehicle.hpp"

#include <algorithm>
#include <limits>

namespace waybreaker::team {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double lower_bound(const OpenedMap& map, const Interrupts& interrupts, CrossingSearcher& crossing,
                   const Vehicle& vehicle) {
    const Agent& agent = vehicle.agent;
    const double straight = distance(agent.start, agent.goal);
    CrossingOptions options{.body = agent.body,
                            .relaxed = agent.body.corners == Corners::none && agent.body.radius > 0};
    if (agent.body.corners == Corners::squeeze) options.body = point_body;
    if (agent.body.corners == Corners::cut) return straight;
    options.removed = map.removed();
    options.limits = interrupts.limits();
    const CrossingResult found = crossing.find(map.map(), agent.start, agent.goal, options);
    return std::max(straight, found.status == SearchStatus::found ? found.lower_bound : 0.0);
}

}  // namespace

bool drives_by_crossing(const Body& body) {
    return body.corners == Corners::none && body.radius > 0;
}

bool is_wide(const Body& body) {
    return drives_by_crossing(body) && body.reach() > 0.5;
}

Trip trip_of(const Map& map, const Agent& agent, const Interrupts& interrupts) {
    const Algorithm planner = drives_by_crossing(agent.body) ? Algorithm::optimal : Algorithm::theta;
    return {map,
            agent,
            {.planner = planner, .body = agent.body},
            interrupts.deadline,
            interrupts.expansions,
            interrupts.stop};
}

std::vector<Cell> cells_of(std::span<const Point> path) {
    std::vector<Cell> cells;
    for (const Point& p : path) cells.push_back({int(p.x), int(p.y)});
    return cells;
}

SearchStatus go_alone(const OpenedMap& map, const Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                      Vehicle& vehicle) {
    const Stopwatch watch;
    const Agent& agent = vehicle.agent;
    const Trip trip = trip_of(map.map(), agent, interrupts);
    const std::vector<ObstacleId> removed(map.removed().begin(), map.removed().end());
    const Opening way = open(trip, {theta, crossing}, removed);
    vehicle.way = cells_of(way.ground.path);
    vehicle.expanded = way.ground.expanded;
    vehicle.generated = way.ground.generated;
    vehicle.limited = way.limited;
    if (way.status != SearchStatus::found) return way.status;
    // Leg by leg, as it will be driven.
    vehicle.alone = agent.ready_at;
    for (std::size_t i = 1; i < vehicle.way.size(); ++i) {
        vehicle.alone += distance(vehicle.way[i - 1], vehicle.way[i]) / agent.speed;
    }
    const double least =
        std::min(lower_bound(map, interrupts, crossing, vehicle), way.ground.length.value_or(infinity));
    vehicle.bound = agent.ready_at + least / agent.speed;
    vehicle.seconds = watch.seconds();
    return way.status;
}

}  // namespace waybreaker::team

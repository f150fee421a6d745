#include "team/vehicle.hpp"

#include <algorithm>

namespace waybreaker::team {
namespace {

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
    return body.corners == Corners::none && body.radius > 0 && body.reach() <= 0.5;
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
    double length = 0;
    SearchStatus status = SearchStatus::no_path;
    if (drives_by_crossing(agent.body)) {
        CrossingOptions options{.body = agent.body, .removed = map.removed(), .limits = interrupts.limits()};
        const CrossingResult found = crossing.find(map.map(), agent.start, agent.goal, options);
        status = found.status;
        length = found.best.length;
        vehicle.way = cells_of(found.best.path);
        vehicle.expanded = found.expanded;
        vehicle.generated = found.generated;
    } else {
        const SearchOptions options{.body = agent.body, .limits = interrupts.limits()};
        const SearchResult found = theta.find(map, agent.start, agent.goal, options);
        status = found.status;
        length = found.length;
        vehicle.way = found.path;
        vehicle.expanded = found.expanded;
        vehicle.generated = found.generated;
    }
    if (status != SearchStatus::found) return status;
    // Leg by leg, as it will be driven.
    vehicle.alone = agent.ready_at;
    for (std::size_t i = 1; i < vehicle.way.size(); ++i) {
        vehicle.alone += distance(vehicle.way[i - 1], vehicle.way[i]) / agent.speed;
    }
    const double least = std::min(lower_bound(map, interrupts, crossing, vehicle), length);
    vehicle.bound = agent.ready_at + least / agent.speed;
    vehicle.seconds = watch.seconds();
    return status;
}

}  // namespace waybreaker::team

#include "team/vehicle.hpp"

#include <algorithm>
#include <limits>

#include "drive/punctual.hpp"
#include "model/objective.hpp"
#include "model/opened.hpp"
#include "safe_interval/driven.hpp"
#include "team/tuning.hpp"

namespace waybreaker::team {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;

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

// Takes the best of its way and of those around what it would wait for longest, then around that and the next, and so
// on.
void go_around_late(const Trip& trip, const Ground& ground, const Searchers& searchers,
                    const SafeIntervalOptions& driving, Vehicle& vehicle) {
    std::vector<ObstacleId> removed(ground.map.removed().begin(), ground.map.removed().end());
    std::vector<Cell> way = vehicle.way;
    while (!way.empty() && !trip.deadline.passed()) {
        const std::vector<Point> path(way.begin(), way.end());
        const auto late = most_waited_for(trip.map, trip.driver, path, ground.openings);
        // A path may graze what stands already.
        if (!late || std::erase(removed, *late) == 0) return;
        const Opening around = open(trip, searchers, removed);
        way = cells_of(around.ground.path);
        if (around.status != SearchStatus::found) return;
        const double arrival = safe_interval::driven(ground.map, way, driving).back().t;
        if (arrival >= vehicle.alone) continue;
        vehicle.alone = arrival;
        vehicle.way = way;
    }
}

// The shortest way in time, as the vehicle can drive it; empty where none was found that arrives before
// `vehicle.alone`.
std::vector<Cell> way_in_time(const Trip& trip, std::span<const TimedOpening> openings, const Searchers& searchers,
                              const std::vector<ObstacleId>& removed, const Vehicle& vehicle) {
    const Agent& agent = vehicle.agent;
    CrossingOptions options;
    options.body = agent.body;
    options.crossings = int(removed.size());
    options.only = removed;
    options.limits = trip.limits(trip.deadline.left());
    options.limits.expansions = std::min(options.limits.expansions, tuning::most_expansions_in_time);
    options.length_limit = (vehicle.alone - agent.ready_at) * agent.speed;
    options.opened_after = [&](std::span<const ObstacleId> crossed) {
        double last = 0;
        for (const TimedOpening& opening : openings) {
            if (std::ranges::count(crossed, opening.obstacle) > 0)
                last = std::max(last, opening.at + trip.rubble - agent.ready_at);
        }
        return last * agent.speed;
    };
    const CrossingResult found = searchers.crossing.find(trip.map, agent.start, agent.goal, options);
    if (found.best.path.empty()) return {};
    const Opening way = drivable(trip, searchers, found.best, removed);
    return way.status == SearchStatus::found ? cells_of(way.ground.path) : std::vector<Cell>();
}

// Bends where it would have to wait, and goes where it need not. `earliest`: when it would arrive if all were open.
void be_punctual(const Trip& trip, const Ground& ground, const Searchers& searchers, double earliest,
                 const SafeIntervalOptions& driving, Vehicle& vehicle) {
    const std::vector<ObstacleId> removed(ground.map.removed().begin(), ground.map.removed().end());
    const bool is_late = vehicle.alone > earliest * (1 + rounding);
    if (!is_late || !drives_by_crossing(vehicle.agent.body) || removed.size() > tuning::most_openings_in_time) return;
    const std::vector<Cell> in_time = way_in_time(trip, ground.openings, searchers, removed, vehicle);
    for (const std::vector<Cell>& way : {vehicle.way, in_time}) {
        if (way.empty()) continue;
        const std::vector<Cell> bent = punctual(ground.map, vehicle.agent, way, ground.openings, trip.rubble).path;
        const double arrival = safe_interval::driven(ground.map, bent, driving).back().t;
        if (arrival >= vehicle.alone) continue;
        vehicle.alone = arrival;
        vehicle.way = bent;
    }
}

}  // namespace

bool drives_by_crossing(const Body& body) {
    return body.corners == Corners::none && body.radius > 0;
}

Trip trip_of(const Map& map, const Agent& agent, const Interrupts& interrupts, double rubble) {
    const Algorithm planner = drives_by_crossing(agent.body) ? Algorithm::optimal : Algorithm::theta;
    return {map,
            agent,
            {.planner = planner, .body = agent.body},
            interrupts.deadline,
            interrupts.expansions,
            interrupts.stop,
            rubble};
}

std::vector<Cell> cells_of(std::span<const Point> path) {
    std::vector<Cell> cells;
    for (const Point& p : path) cells.push_back({int(p.x), int(p.y)});
    return cells;
}

void count_unreached(const Rules& rules, Vehicle& vehicle) {
    if (!rules.unreached) return;
    const double latest = unreached_at(rules, vehicle.agent);
    const bool never = vehicle.way.empty();
    vehicle.alone = never ? latest : std::min(vehicle.alone, latest);
    vehicle.bound = never ? latest : std::min(vehicle.bound, latest);
}

SearchStatus go_alone(const Ground& ground, const Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                      Vehicle& vehicle) {
    const Stopwatch watch;
    const Agent& agent = vehicle.agent;
    const Trip trip = trip_of(ground.map.map(), agent, interrupts, ground.rubble);
    const Opening way = open(trip, {theta, crossing}, {ground.map.removed().begin(), ground.map.removed().end()});
    vehicle.way = cells_of(way.ground.path);
    vehicle.expanded = way.ground.expanded;
    vehicle.generated = way.ground.generated;
    vehicle.limited = way.limited;
    if (way.status != SearchStatus::found) return way.status;
    // As it will be driven.
    SafeIntervalOptions driving;
    driving.body = agent.body;
    driving.speed = agent.speed;
    driving.ready_at = agent.ready_at;
    driving.openings = ground.openings;
    driving.rubble = ground.rubble;
    vehicle.alone = safe_interval::driven(ground.map, vehicle.way, driving).back().t;
    go_around_late(trip, ground, {theta, crossing}, driving, vehicle);
    const double earliest = agent.ready_at + cells_driven(trip, way) / agent.speed;
    be_punctual(trip, ground, {theta, crossing}, earliest, driving, vehicle);
    const double least =
        std::min(lower_bound(ground.map, interrupts, crossing, vehicle), way.ground.length.value_or(infinity));
    vehicle.bound = agent.ready_at + least / agent.speed;
    vehicle.seconds = watch.seconds();
    return way.status;
}

}  // namespace waybreaker::team

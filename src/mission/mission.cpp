// The paper's method, from mission to plan. plan() reads as its section 3.
#include "waybreaker/mission.hpp"

#include <algorithm>
#include <chrono>

#include "plan/timeline.hpp"
#include "waybreaker/breach.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const Agent& agent_of(const Mission& mission, AgentKind kind) {
    return *std::find_if(mission.agents.begin(), mission.agents.end(),
                         [kind](const Agent& agent) { return agent.kind == kind; });
}

Outcome::Ground ground_outcome(SearchResult search, double seconds) {
    Outcome::Ground ground;
    if (search.status == SearchStatus::found) ground.length = search.length;
    ground.expanded = search.expanded;
    ground.generated = search.generated;
    ground.seconds = seconds;
    ground.path.assign(search.path.begin(), search.path.end());
    return ground;
}

Outcome outcome(Outcome::Ground ground, const Flight& flight, const Agent& driver, const Agent& flyer) {
    Outcome result;
    result.air.length = flight.length;
    result.air.path.push_back(flyer.start);
    for (const BreachPoint& breach : flight.breaches) result.air.path.push_back(breach.at);
    result.air.path.push_back(flyer.goal);
    if (ground.length) {
        const double ground_time = *ground.length / driver.speed;
        const double air_time = flight.length / flyer.speed;
        result.makespan = std::max(ground_time, air_time);
        result.flowtime = ground_time + air_time;
    }
    result.ground = std::move(ground);
    return result;
}

PlanStatus plan_status(SearchStatus search) {
    switch (search) {
        case SearchStatus::found:
            return PlanStatus::solved;
        case SearchStatus::limit_reached:
            return PlanStatus::limit_reached;
        case SearchStatus::stopped:
            return PlanStatus::stopped;
        case SearchStatus::no_path:
            break;
    }
    return PlanStatus::no_plan;
}

// The removed obstacles with their times, given both agents' timed paths.
std::vector<Removal> removals(const Map& map, const Flight& flight, std::span<const std::uint32_t> hits,
                              std::span<const Waypoint> air, std::span<const Waypoint> ground, double radius) {
    std::vector<Removal> removed;
    for (std::size_t i = 0; i < flight.breaches.size(); ++i) {
        const BreachPoint& breach = flight.breaches[i];
        const Obstacle& obstacle = map.obstacle(breach.obstacle);
        removed.push_back({.obstacle = obstacle.id,
                           .source_id = obstacle.source_id,
                           .cells = obstacle.cells,
                           .hits = hits[obstacle.id.value],
                           .at = breach.at,
                           .cleared_at = air[i + 1].t,
                           .entered_at = first_touch(map, obstacle.id, ground, radius)});
    }
    return removed;
}

}  // namespace

Plan MissionPlanner::plan(const Map& map, const Mission& mission, const MissionOptions& options) {
    validate(map, mission, options);
    const Agent& driver = agent_of(mission, AgentKind::ground);
    const Agent& flyer = agent_of(mission, AgentKind::air);
    const Stopwatch total;
    Plan plan;

    // Search the ground path and count how often each obstacle is in the way.
    SearchOptions counting = options.search;
    counting.count_hits = true;
    const Stopwatch first_search;
    SearchResult before = searcher_.find(OpenedMap(map), driver.start, driver.goal, counting);
    const double before_seconds = first_search.seconds();
    const std::vector<std::uint32_t> hits = std::move(before.hits);

    // Select the obstacles to remove.
    const Stopwatch selecting;
    const std::vector<ObstacleId> chosen = most_hit(map, hits, options.removals);
    plan.seconds.select = selecting.seconds();

    // Fly past all of them.
    const Stopwatch flying;
    const Flight straight{{}, distance(flyer.start, flyer.goal)};
    const Flight flight = chosen.empty()                          ? straight
                          : options.flight == FlightRule::optimal ? fly_optimal(map, flyer.start, flyer.goal, chosen)
                                                                  : fly_nearest(map, flyer.start, flyer.goal, chosen);
    plan.seconds.flight = flying.seconds();

    // Replan the ground path on the opened map.
    SearchResult after = before;
    double after_seconds = before_seconds;
    if (!chosen.empty() && before.status != SearchStatus::stopped) {
        const Stopwatch second_search;
        after = searcher_.find(OpenedMap(map, chosen), driver.start, driver.goal, options.search);
        after_seconds = second_search.seconds();
        plan.seconds.search = after_seconds;
    }
    plan.seconds.search += before_seconds;

    // Report both.
    plan.status = plan_status(after.status);
    plan.before = outcome(ground_outcome(std::move(before), before_seconds), straight, driver, flyer);
    plan.after = outcome(ground_outcome(std::move(after), after_seconds), flight, driver, flyer);
    const std::vector<Waypoint> ground_path = timed(plan.after.ground.path, driver.speed);
    const std::vector<Point> flown(plan.after.air.path.begin(), plan.after.air.path.end());
    const std::vector<Waypoint> air_path = timed(flown, flyer.speed);
    const Motion& motion = options.search.motion;
    const double radius = motion.corners == Corners::none ? motion.radius : 0;
    plan.removed = removals(map, flight, hits, air_path, ground_path, radius);
    if (plan.status == PlanStatus::solved) {
        for (const Agent& agent : mission.agents) {
            const bool drives = agent.kind == AgentKind::ground;
            plan.agents.push_back(
                {agent.id, agent.kind, agent.speed, drives ? ground_path : air_path, agent.start, agent.goal});
        }
    }
    plan.seconds.total = total.seconds();
    return plan;
}

}  // namespace waybreaker

// waybreaker in a program of your own: draw a map, plan a mission, see which wall to break and the way through.
#include <chrono>
#include <iostream>
#include <waybreaker/waybreaker.hpp>

namespace wb = waybreaker;
static_assert(WAYBREAKER_VERSION >= 200);

int main() {
    const wb::Map map = wb::Map::from_rows({
        "....A....",
        "....A....",
        "....A....",
        ".........",
    });
    wb::Mission mission;
    mission.agents = {wb::vehicle("rover", {0, 1}, {8, 1}), wb::aircraft("drone", {0, 1})};
    mission.agents[0].ready_at = 5;
    mission.rules.removals = 1;

    wb::Planner planner;
    const auto plan = planner.try_plan(map, mission, {.expansions = 2000});
    if (!plan) {
        std::cerr << wb::to_string(plan.error().code) << ": " << plan.error().detail << '\n';
        return 1;
    }
    if (plan->status != wb::PlanStatus::solved) return 1;

    for (const wb::Breach& breach : plan->breaches) {
        std::cout << "break wall " << breach.obstacle.value << " from (" << breach.at.x << ", " << breach.at.y << ")\n";
    }
    std::cout << "drive";
    for (const wb::Waypoint& point : plan->agents[0].path) std::cout << " (" << point.x << ", " << point.y << ")";
    std::cout << '\n'
              << wb::to_string(plan->status) << ": there at " << *plan->before.makespan << " before, at "
              << *plan->after.makespan << " after\n";
    for (const wb::Violation& violation : wb::check(map, mission, *plan)) std::cerr << violation.message << '\n';

    auto job = planner.start(map, mission);  // the same plan, between frames
    for (int frame = 0; !job.step(std::chrono::milliseconds(2)); ++frame) std::clog << "draw frame " << frame << '\n';
}

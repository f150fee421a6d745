// A plan that meets the field: a breach fails, and the rest of the mission is planned anew.
#include <iostream>
#include <waybreaker/waybreaker.hpp>

namespace wb = waybreaker;

namespace {

void print(const wb::Plan& plan) {
    std::cout << "there at " << plan.after.ground_makespan.value_or(0) << ", breaks " << plan.breaches.size() << '\n';
}

}  // namespace

int main() {
    const wb::Map map = wb::Map::from_rows({
        "....A....",
        "....A....",
        "....A....",
        ".........",
    });
    wb::Mission mission;
    mission.agents = {wb::vehicle("rover", {0, 1}, {8, 1}), wb::aircraft("drone", {0, 1})};
    mission.rules.removals = 1;
    mission.rules.breach_time.per_obstacle = 1;

    wb::Planner planner;
    const wb::Plan plan = planner.plan(map, mission);
    print(plan);

    const wb::Breach& breach = plan.breaches.front();
    const wb::State state{.sequence = 1, .now = breach.cleared_at, .failed = {{breach.obstacle, breach.cleared_at}}};
    const wb::Revision next = wb::revise(planner, map, mission, plan, state);
    std::cout << "at " << state.now << " the breach of wall " << breach.obstacle.value
              << " has failed: " << wb::to_string(next.status) << '\n';
    print(next.plan);
    for (const auto& violation : wb::check_continuity(mission, plan, state, next.mission, next.plan))
        std::cerr << violation.message << '\n';
}

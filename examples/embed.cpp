// waybreaker in a program of your own: make a map, plan a mission, print which wall to break and the way through.
#include <iostream>
#include <waybreaker/waybreaker.hpp>

int main() {
    waybreaker::Grid grid(40, 20);  // every cell free
    for (int y = 0; y < 18; ++y) grid.set_blocked({20, y}, true);
    const waybreaker::Map map(std::move(grid));

    waybreaker::Planner planner;
    auto mission = waybreaker::ground_and_air({4, 4}, {36, 4});
    mission.rules.removals = 1;
    const waybreaker::Plan plan = planner.plan(map, mission);
    if (plan.status != waybreaker::PlanStatus::solved) return 1;

    for (const auto& wall : plan.breaches) {
        std::cout << "break wall " << wall.obstacle.value << " from (" << wall.at.x << ", " << wall.at.y << ")\n";
    }
    std::cout << "drive";
    for (const auto& point : plan.after.ground().path) std::cout << " (" << point.x << ", " << point.y << ")";
    std::cout << "\n" << *plan.before.makespan << " cells before, " << *plan.after.makespan << " after\n";
}

// Two agents against a search over both at once, on small maps: both step to one of four neighbours, or wait, in one
// unit of time. That is one of the ways a team may move, so where it arrives, a plan exists.
#include <gtest/gtest.h>

#include <map>
#include <queue>
#include <random>

#include "checked_plan.hpp"
#include "plain_map.hpp"
#include "team/simulation.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

using Both = std::pair<Cell, Cell>;

std::vector<Cell> steps_from(const Map& map, Cell at) {
    std::vector<Cell> cells{at};
    for (const Cell to : {Cell{at.x + 1, at.y}, {at.x - 1, at.y}, {at.x, at.y + 1}, {at.x, at.y - 1}}) {
        if (map.grid().contains(to) && !map.grid().blocked(to)) cells.push_back(to);
    }
    return cells;
}

// Whether discs of radius 0.5 stay clear of each other, looked at in small parts of the step.
bool keep_clear(const Both& from, const Both& to) {
    for (int k = 0; k <= 20; ++k) {
        const double share = k / 20.0;
        const double x =
            from.first.x - from.second.x + share * (to.first.x - from.first.x - to.second.x + from.second.x);
        const double y =
            from.first.y - from.second.y + share * (to.first.y - from.first.y - to.second.y + from.second.y);
        if (std::hypot(x, y) < 1 - 1e-9) return false;
    }
    return true;
}

// When the last of the two is at its goal; empty if there is no way.
std::optional<int> least_makespan(const Map& map, const Both& start, const Both& goal) {
    std::map<Both, int> reached{{start, 0}};
    std::queue<Both> open;
    open.push(start);
    while (!open.empty()) {
        const Both at = open.front();
        open.pop();
        if (at == goal) return reached[at];
        for (const Cell a : steps_from(map, at.first)) {
            for (const Cell b : steps_from(map, at.second)) {
                if (reached.contains({a, b}) || !keep_clear(at, {a, b})) continue;
                reached[{a, b}] = reached[at] + 1;
                open.push({a, b});
            }
        }
    }
    return std::nullopt;
}

TEST(TwoAgents, AreNoWorseThanSteppingTogether) {
    std::mt19937 random(7);
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    int solvable = 0;
    int solved = 0;
    int as_good = 0;
    for (int round = 0; round < 300; ++round) {
        PlainMap plain{3 + below(4), 2 + below(4), {}};
        for (int i = 0; i < plain.width * plain.height; ++i) plain.obstacles.push_back(below(100) < 25 ? 1 : 0);
        const std::vector<Cell> free = plain.free_cells();
        if (free.size() < 4) continue;
        const auto any = [&] { return free[std::size_t(below(int(free.size())))]; };
        const Both start{any(), any()};
        const Both goal{any(), any()};
        if (start.first == start.second || goal.first == goal.second) continue;
        const Map map(plain.grid());
        const std::optional<int> least = least_makespan(map, start, goal);
        if (!least) continue;
        ++solvable;
        Mission mission;
        mission.agents.resize(2);
        mission.agents[0].id = "a";
        mission.agents[0].start = start.first;
        mission.agents[0].goal = goal.first;
        mission.agents[1].id = "b";
        mission.agents[1].start = start.second;
        mission.agents[1].goal = goal.second;
        const Plan plan = Planner().plan(map, mission, {}, {});
        EXPECT_TRUE(is_valid(map, mission, plan));
        if (plan.status != PlanStatus::solved) continue;
        ++solved;
        EXPECT_EQ(simulate(map, mission, plan, 0.02), "");
        as_good += *plan.after.makespan <= *least + 1e-6 ? 1 : 0;
    }
    EXPECT_GT(solvable, 150);
    // One after the other is not complete: where both have to make way for each other, it can fail.
    EXPECT_GE(solved, solvable * 97 / 100) << "of " << solvable;
    EXPECT_GE(as_good, solved * 85 / 100) << "of " << solved;
}

}  // namespace
}  // namespace waybreaker

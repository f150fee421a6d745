// Teams that crowd each other on small maps, and obstacles to breach.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "plain_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

// The same numbers wherever it runs, unlike the standard library's distributions.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : engine_(seed) {}
    int number(int least, int most) { return least + int(engine_() % std::uint64_t(most - least + 1)); }
    double share() { return double(engine_() >> 11U) / double(std::uint64_t{1} << 53U); }
    template <class T, std::size_t n>
    T any_of(const std::array<T, n>& values) {
        return values[std::size_t(number(0, int(n) - 1))];
    }
    Cell cell(const PlainMap& map) { return {number(0, map.width - 1), number(0, map.height - 1)}; }

  private:
    std::mt19937_64 engine_;
};

inline PlainMap drawn_map(Draws& draws) {
    PlainMap map{draws.number(2, 11), draws.number(2, 11), {}};
    const int percent = draws.any_of(std::array{0, 5, 15, 30});
    for (int i = 0; i < map.width * map.height; ++i) map.obstacles.push_back(draws.number(0, 99) < percent ? 1 : 0);
    return map;
}

inline Mission drawn_team(Draws& draws, const PlainMap& plain, const Map& map) {
    Mission mission;
    mission.rules.objective = draws.any_of(std::array{Objective::flowtime, Objective::makespan});
    mission.rules.at_goal = draws.any_of(std::array{AtGoal::stay, AtGoal::leave});
    mission.rules.separation = draws.any_of(std::array{0.0, 0.0, 0.0, 0.3});
    mission.rules.removals = draws.number(0, 3);
    mission.rules.breach_time.per_obstacle = draws.number(0, 4);
    const int vehicles = draws.number(1, 7);
    const bool alike = draws.number(0, 1) == 1;
    const double radius = draws.any_of(std::array{0.35, 0.5, 0.25});
    for (int tries = 0; tries < 60 && int(mission.agents.size()) < vehicles; ++tries) {
        Agent agent = vehicle("v" + std::to_string(tries), draws.cell(plain), draws.cell(plain), radius);
        if (!alike) {
            agent.body.radius = draws.any_of(std::array{0.25, 0.5, 0.5, 0.9});
            agent.speed = draws.any_of(std::array{0.5, 1.0, 1.0, 1.7, 3.0});
            agent.ready_at = draws.number(0, 2) == 0 ? draws.number(1, 3) : 0;
        }
        mission.agents.push_back(agent);
        try {
            validate(map, mission);
        } catch (const InputError&) {
            mission.agents.pop_back();
        }
    }
    const int aircraft = draws.number(0, 2);
    for (int i = 0; i < aircraft; ++i) {
        const Cell home = draws.cell(plain);
        mission.agents.push_back(waybreaker::aircraft("a" + std::to_string(i), home, home, draws.number(1, 3)));
    }
    return mission;
}

// As many that are alike as a small map holds: they go round in rings.
inline Mission drawn_crowd(Draws& draws, const PlainMap& plain, const Map& map) {
    Mission mission;
    const double radius = draws.any_of(std::array{0.25, 0.35, 0.35});
    const int vehicles = draws.number(4, plain.width * plain.height - 2);
    for (int tries = 0; tries < 200 && int(mission.agents.size()) < vehicles; ++tries) {
        mission.agents.push_back(vehicle("v" + std::to_string(tries), draws.cell(plain), draws.cell(plain), radius));
        try {
            validate(map, mission);
        } catch (const InputError&) {
            mission.agents.pop_back();
        }
    }
    return mission;
}

struct Drawn {
    Map map;
    Mission mission;
    Plan plan;
};

// Calls visit(drawn, draws) for so many missions that have a plan.
void for_each_drawn_plan(int count, const auto& visit) {
    int solved = 0;
    for (std::uint64_t seed = 1; solved < count; ++seed) {
        ASSERT_LT(seed, std::uint64_t(20 * count));
        Draws draws(seed);
        const PlainMap plain = drawn_map(draws);
        Drawn drawn{Map(plain.grid()), {}, {}};
        drawn.mission = drawn_team(draws, plain, drawn.map);
        if (std::ranges::count(drawn.mission.agents, AgentKind::ground, &Agent::kind) == 0) continue;
        drawn.plan = Planner().plan(drawn.map, drawn.mission);
        if (drawn.plan.status != PlanStatus::solved) continue;
        ++solved;
        SCOPED_TRACE("seed " + std::to_string(seed));
        visit(drawn, draws);
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace waybreaker

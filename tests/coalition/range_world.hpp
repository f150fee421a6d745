// Small missions of aircraft whose batteries end.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "coalition/every_plan.hpp"
#include "plain_map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

struct RangeWorld {
    Map map;
    Mission mission;
};

inline double straight_length(const Agent& agent) {
    return distance(agent.start, agent.goal);
}

// A few walls between left and right, one or more vehicles that do not collide, one or two aircraft.
inline RangeWorld any_range_world(std::mt19937& random, int most_vehicles) {
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    const auto one_of = [&](const auto& values) { return values[std::size_t(below(int(values.size())))]; };
    PlainMap plain{5 + below(4), 3 + below(3), {}};
    plain.obstacles.assign(std::size_t(plain.width) * std::size_t(plain.height), 0);
    for (int wall = 0; wall < 3; ++wall) {
        const bool upright = below(4) > 0;
        Cell c{1 + below(plain.width - 2), below(2)};
        for (int length = 2 + below(5); length > 0 && !plain.blocked(c); --length) {
            plain.obstacles[plain.index(c)] = std::uint32_t(wall) + 1;
            ++(upright ? c.y : c.x);
        }
    }
    RangeWorld made{Map::from_labels(plain.width, plain.height, plain.obstacles), {}};
    Mission& mission = made.mission;
    mission.rules.removals = 1 + below(3);
    mission.rules.objective = one_of(std::array{Objective::makespan, Objective::flowtime, Objective::ground_makespan});
    mission.rules.breach_time.per_obstacle = one_of(std::array{0.0, 0.0, 1.0, 2.5});
    mission.rules.collisions = most_vehicles == 1;
    const std::vector<Cell> free = plain.free_cells();
    const auto any_free = [&] { return one_of(free); };
    const auto at_side = [&](bool left) {
        Cell c = any_free();
        for (int tries = 0; tries < 50 && (2 * c.x < plain.width) != left; ++tries) c = any_free();
        return c;
    };
    for (int i = 1 + below(most_vehicles); i > 0; --i) {
        Agent& agent = mission.agents.emplace_back(vehicle("rover" + std::to_string(i), at_side(true), at_side(false)));
        agent.speed = one_of(std::array{0.5, 1.0, 1.0});
    }
    for (int i = 1 + below(2); i > 0; --i) {
        const Cell start = below(3) == 0 ? any_free() : mission.agents.front().start;
        const Cell goal = below(3) == 0 ? any_free() : start;
        Agent& agent = mission.agents.emplace_back(aircraft("air" + std::to_string(i), start, goal));
        agent.speed = one_of(std::array{1.0, 1.0, 3.0});
        agent.ready_at = one_of(std::array{0.0, 0.0, 2.0});
        if (below(4) == 0) agent.reserve = 0.2;
        if (below(3) > 0) agent.range = (straight_length(agent) + 0.5 + 0.5 * below(14)) / (1 - agent.reserve);
        if (below(3) == 0)
            agent.endurance = (straight_length(agent) / agent.speed + 0.5 + 0.5 * below(12)) / (1 - agent.reserve);
        if (std::isinf(agent.longest_flight())) agent.reserve = 0;
    }
    return made;
}

inline double objective_of(const Mission& mission, const Plan& plan) {
    return value(plan.after, mission.rules.objective).value_or(never);
}

}  // namespace waybreaker

// Agents that may not breach everything, and whose breaches take other times than the rules say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// For some agents. `below(n)` draws a number from 0 to n - 1.
template <class Below>
void give_abilities(const Map& map, Mission& mission, Below below) {
    const auto one_of = [&](const auto& values) { return values[std::size_t(below(int(values.size())))]; };
    for (Agent& agent : mission.agents) {
        if (below(2) == 0) agent.breach_time = one_of(std::array{0.0, 0.5, 2.0, 6.0});
        if (below(3) == 0) agent.breach_time_per_cell = one_of(std::array{0.0, 0.25, 1.0});
        if (agent.kind == AgentKind::ground && below(2) == 0) agent.reach = one_of(std::array{0.5, 1.0, 1.5, 3.0});
        if (below(2) == 0) continue;
        agent.can_breach.emplace();
        if (below(2) == 0) agent.can_breach->most_cells = std::uint32_t(1 + below(6));
        if (below(2) == 0) continue;
        std::vector<ObstacleId>& only = agent.can_breach->only.emplace();
        for (const Obstacle& obstacle : map.obstacles()) {
            if (below(3) > 0) only.push_back(obstacle.id);
        }
    }
}

}  // namespace waybreaker

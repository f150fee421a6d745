// Waits: where ground agents stand on their way, as pictures mark them.
#pragma once

#include <vector>

#include "model/timeline.hpp"

namespace waybreaker::render {

// In the order of the agents, and of their paths.
inline std::vector<Wait> waits(const Plan& plan) {
    std::vector<Wait> found;
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind != AgentKind::ground) continue;
        for (const Wait& wait : stands(agent)) found.push_back(wait);
    }
    return found;
}

}  // namespace waybreaker::render

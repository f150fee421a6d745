// Stops: where ground agents stand on their way, as pictures mark them.
#pragma once

#include <vector>

#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct Wait {
    waybreaker::Point at;
    double time;
};

// Of the ground agent, in the order of its path.
inline std::vector<Wait> waits(const Plan& plan) {
    std::vector<Wait> found;
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind != AgentKind::ground) continue;
        for (std::size_t i = 1; i < agent.path.size(); ++i) {
            const Waypoint& a = agent.path[i - 1];
            const Waypoint& b = agent.path[i];
            if (a.x == b.x && a.y == b.y && a.t < b.t) found.push_back({{a.x, a.y}, b.t - a.t});
        }
    }
    return found;
}

}  // namespace waybreaker::render

#pragma once

#include <string>

#include "waybreaker/mission.hpp"

namespace waybreaker {

inline Agent vehicle(const std::string& id, Cell start, Cell goal, double radius = 0.5) {
    Agent agent;
    agent.id = id;
    agent.start = start;
    agent.goal = goal;
    agent.body.radius = radius;
    return agent;
}

inline Agent aircraft(const std::string& id, Cell start, Cell goal, double speed = 1) {
    Agent agent = vehicle(id, start, goal);
    agent.kind = AgentKind::air;
    agent.speed = speed;
    return agent;
}

}  // namespace waybreaker

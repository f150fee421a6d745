// Makers of agents with one figure more than the library's.
#pragma once

#include <string>

#include "waybreaker/mission.hpp"

namespace waybreaker {

inline Agent vehicle(const std::string& id, Cell start, Cell goal, double radius) {
    Agent agent = vehicle(id, start, goal);
    agent.body.radius = radius;
    return agent;
}

inline Agent aircraft(const std::string& id, Cell start, Cell goal, double speed) {
    Agent agent = aircraft(id, start, goal);
    agent.speed = speed;
    return agent;
}

}  // namespace waybreaker

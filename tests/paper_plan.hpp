// The paper's plan: its method with so many removals.
#pragma once

#include "waybreaker/planner.hpp"

namespace waybreaker {

inline Plan paper_plan(const Map& map, Mission mission, int removals) {
    mission.rules.removals = removals;
    Method method;
    follow_paper(mission.rules, method);
    return Planner().plan(map, mission, method);
}

}  // namespace waybreaker

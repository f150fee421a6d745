// Small random teams with aircraft, for RapidCheck.
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// Random vehicles with room at their starts and goals, and aircraft.
inline Mission any_coalition(const PlainMap& plain, const Map& map) {
    Mission mission;
    Rules& rules = mission.rules;
    rules.objective = *rc::gen::element(Objective::flowtime, Objective::makespan, Objective::ground_makespan);
    rules.separation = *rc::gen::element(0.0, 0.0, 0.5);
    rules.at_goal = *rc::gen::element(AtGoal::stay, AtGoal::stay, AtGoal::leave);
    rules.timing = *rc::gen::element(Timing::enforce, Timing::enforce, Timing::enforce, Timing::ignore);
    rules.removals = *number(1, 4);
    rules.breach_time = {*rc::gen::element(0.0, 0.0, 2.0), *rc::gen::element(0.0, 0.5)};
    if (*number(0, 3) == 0) rules.budget = *number(0, 3);
    if (*number(0, 3) == 0) rules.protect = some_obstacles(map, 2);
    const int vehicles = *number(1, 5);
    const int flyers = *number(vehicles == 1 ? 2 : 1, 3);
    for (int i = 0; i < flyers; ++i) {
        mission.agents.push_back(
            aircraft("bird" + std::to_string(i), any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 3.0)));
        if (*number(0, 2) == 0) mission.agents.back().breaches = *number(1, 2);
    }
    for (int tries = 0; tries < 40 && int(mission.agents.size()) < vehicles + flyers; ++tries) {
        Agent agent = vehicle(std::to_string(tries), any_free_cell(plain), any_free_cell(plain),
                              *rc::gen::element(0.0, 0.2, 0.5, 0.5, 0.7, 1.1, 2.0));
        agent.speed = *rc::gen::element(1.0, 1.0, 0.5, 3.0);
        agent.ready_at = *rc::gen::element(0.0, 0.0, 2.5);
        if (*number(0, 7) == 0) agent.body = {.corners = *rc::gen::element(Corners::cut, Corners::squeeze)};
        mission.agents.push_back(agent);
        try {
            validate(map, mission);
        } catch (const InputError&) {
            mission.agents.pop_back();
        }
    }
    RC_PRE(int(mission.agents.size()) > flyers && mission.is_team());
    std::vector<ObstacleId> forced = some_obstacles(map, 1);
    if (*number(0, 3) == 0) rules.force = forced;
    return mission;
}

}  // namespace waybreaker

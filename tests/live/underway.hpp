// Random missions under way, for RapidCheck.
#pragma once

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker {

// Up to two aircraft.
inline Mission any_mission(const PlainMap& plain, int most_vehicles, int most_retries) {
    Mission mission;
    const int vehicles = *number(1, most_vehicles);
    for (int i = 0; i < vehicles; ++i) {
        Agent rover = vehicle("rover" + std::to_string(i), any_free_cell(plain), any_free_cell(plain));
        rover.speed = *rc::gen::element(0.5, 1.0, 2.0);
        rover.ready_at = *rc::gen::element(0.0, 0.0, 3.0);
        mission.agents.push_back(rover);
    }
    const int aircraft_count = *number(0, 2);
    for (int i = 0; i < aircraft_count; ++i) {
        mission.agents.push_back(
            aircraft("heli" + std::to_string(i), any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 4.0)));
    }
    Rules& rules = mission.rules;
    rules.removals = *number(0, 3);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time.per_obstacle = *rc::gen::element(0.0, 0.0, 2.5, 8.0);
    rules.retries = *number(0, most_retries);
    return mission;
}

struct Underway {
    Map map;
    Mission mission;
    Plan plan = {};
    State state = {};
};

// One that has a plan, before it begins.
inline Underway any_planned(int side, int most_vehicles, int most_retries) {
    const PlainMap plain = *random_map(side, side);
    Underway drawn{Map(plain.grid()), any_mission(plain, most_vehicles, most_retries)};
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("two stand too near");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// Some time after it began; nothing is reported but that.
inline Underway any_underway(int side) {
    Underway drawn = any_planned(side, 2, 1);
    double last = 0;
    for (const Itinerary& agent : drawn.plan.agents) last = std::max(last, agent.path.back().t);
    drawn.state.sequence = 1;
    drawn.state.now = last * *number(0, 100) / 100;
    return drawn;
}

}  // namespace waybreaker

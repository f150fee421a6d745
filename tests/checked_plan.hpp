// Every plan that a test makes goes before the checker:
//
//     EXPECT_TRUE(is_valid(map, mission, plan));             // GoogleTest
//     RC_ASSERT(plan_faults(map, mission, plan) == "");      // RapidCheck
//
// The test's program USES check.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

// A violation in one line, with place and time.
inline std::string line_of(const Violation& violation) {
    std::ostringstream line;
    line << to_string(violation.rule) << ": " << violation.message;
    if (violation.place) line << " (" << violation.place->x << "," << violation.place->y << ")";
    if (violation.time) line << " [t = " << *violation.time << "]";
    return line.str();
}

// What is wrong with the plan, one line each; empty if nothing is. Its agents are the mission's, in that order.
inline std::string plan_faults(const Map& map, const Mission& mission, const Plan& plan) {
    std::string faults;
    for (const Violation& violation : check(map, mission, plan)) faults += line_of(violation) + "\n";
    if (plan.status != PlanStatus::solved) return faults;
    const auto same = [](const Itinerary& planned, const Agent& agent) {
        return planned.id == agent.id && planned.kind == agent.kind && planned.speed == agent.speed &&
               planned.start == agent.start && planned.goal == agent.goal;
    };
    if (!std::equal(plan.agents.begin(), plan.agents.end(), mission.agents.begin(), mission.agents.end(), same)) {
        faults += "the agents are not the mission's\n";
    }
    return faults;
}

inline testing::AssertionResult is_valid(const Map& map, const Mission& mission, const Plan& plan) {
    const std::string faults = plan_faults(map, mission, plan);
    return faults.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << faults;
}

}  // namespace waybreaker

// Revise: the rest of a mission planned anew, from what has happened to its plan.
//
//     Revision next = revise(planner, map, mission, plan, state);
//     if (next.status == RevisionStatus::revised) send(next.plan);
//
// In the words of VDA 5050: what lies before an agent's decision point is its base and stays; what lies behind is its
// horizon and is free. Where that is, and what is left of a mission: docs/live.md.
#pragma once

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker {

struct Revision {
    RevisionStatus status = RevisionStatus::unchanged;
    Map map;               // as it is known now, what was found laid over
    Mission mission = {};  // what is left of it
    Plan plan = {};        // of that; its paths begin at State::now
};

// Pure: the same arguments, the same revision, time limits aside. `plan` is one of that mission on that map, or a
// revision. `reaction`: how long it takes until agents know of the new plan, 0 to most_breach_time; until then they
// keep to the old one. Never ends later than the rest of the old plan, where all of it is still possible. Throws
// InputError, naming what is wrong, if the state cannot be one of the plan.
[[nodiscard]] Revision revise(Planner& planner, const Map& map, const Mission& mission, const Plan& plan,
                              const State& state, double reaction = 0, const Method& method = {},
                              const Limits& limits = {});

// The plan with Breach::if_failed of all its breaches: for each, what comes of the revision at the moment at which it
// turns out to have failed. limits.seconds are those of all together; of what was not found out in that time, nothing
// is said. REQUIRES: the plan is one of that mission on that map, or a revision, it is solved, and timing is enforced.
[[nodiscard]] Plan with_plan_b(Planner& planner, const Map& map, const Mission& mission, Plan plan,
                               const Method& method = {}, const Limits& limits = {});

}  // namespace waybreaker

// Rehearsals of random missions: nobody ever meets anybody, nor what stands.
#include "waybreaker/rehearse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "input_error.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

struct Rehearsable {
    Map map;
    Mission mission;
    Plan plan = {};
};

Mission any_mission(const PlainMap& plain, int most_vehicles) {
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
    rules.retries = *number(0, 2);
    return mission;
}

Rehearsable any_rehearsable(int side, int most_vehicles) {
    const PlainMap plain = *random_map(side, side);
    Rehearsable drawn{Map(plain.grid()), any_mission(plain, most_vehicles)};
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("two stand too near");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

RehearsalOptions any_options() {
    RehearsalOptions options;
    options.fail = *rc::gen::element(0.0, 0.3, 0.7, 1.0);
    options.delay = {*rc::gen::element(DelayKind::fixed, DelayKind::exponential, DelayKind::poisson),
                     *rc::gen::element(0.0, 0.5, 2.0)};
    options.blocked = *rc::gen::element(0.0, 0.5, 1.0);
    options.sight = *rc::gen::element(3.0, 5.0);
    options.lost = *rc::gen::element(0.0, 0.3, 1.0);
    options.seed = *rc::gen::arbitrary<std::uint64_t>();
    options.runs = 10;
    options.threads = 1;
    return options;
}

std::string faults(const Rehearsal& rehearsal) {
    std::string faults;
    for (const Rehearsed& run : rehearsal.runs) {
        if (run.illegal > 0) faults += run.fault + "\n";
        if (run.ending == Ending::stuck) faults += "stuck\n";
    }
    return faults;
}

RC_GTEST_PROP(Rehearse, WithoutDrawsIsNoLaterThanPlanned, ()) {
    const Rehearsable drawn = any_rehearsable(14, 1);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    RC_ASSERT(rehearsal.makespan.worst <= rehearsal.planned * (1 + 1e-9) + 1e-6);
    RC_ASSERT(rehearsal.ground_makespan.worst <= rehearsal.ground_planned * (1 + 1e-9) + 1e-6);
}

RC_GTEST_PROP(Rehearse, NoRunIsIllegal, ()) {
    const Rehearsable drawn = any_rehearsable(14, 1);
    const RehearsalOptions options = any_options();
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, options);
    for (const Rehearsed& run : rehearsal.runs) {
        RC_CLASSIFY(run.ending == Ending::arrived, "arrived");
        RC_CLASSIFY(run.ending == Ending::no_way, "no way");
        RC_CLASSIFY(run.ending == Ending::not_found, "not found");
        RC_CLASSIFY(run.ending == Ending::broken, "broken");
        RC_CLASSIFY(run.revisions > 0, "revised");
    }
    RC_ASSERT(faults(rehearsal) == "");
}

}  // namespace
}  // namespace waybreaker

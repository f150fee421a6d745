// Executor: plays one mission to its end, event by event.
#pragma once

#include <cstdint>
#include <vector>

#include "rehearse/script.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/rehearse.hpp"

namespace waybreaker::rehearsal {

// What all runs have in common.
struct Scene {
    const Map& map;
    const Mission& mission;
    const Plan& plan;
    const std::vector<Script>& scripts;  // of the plan
    const RehearsalOptions& options;
    const Method& method;
    const Limits& limits;
};

// Run number `run`. Adds to `revise_ms` how long each revision took.
Rehearsed play(const Scene& scene, std::uint64_t run, Planner& planner, std::vector<double>& revise_ms);

}  // namespace waybreaker::rehearsal

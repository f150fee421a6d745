// A candidate as a plan.
#pragma once

#include <cstdint>
#include <span>

#include "select/candidate.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

Outcome outcome_of(const Mission& mission, const Candidate& candidate);

// Its status, breaches, agents and figures; nothing of other candidates. `hits`: as Selector::hits.
Plan plan_of(const Task& task, const Mission& mission, const Candidate& candidate, std::span<const std::uint32_t> hits);

}  // namespace waybreaker

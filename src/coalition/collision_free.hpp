// Collision-free paths for sets of obstacles that have been put in time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "coalition/coalition.hpp"

namespace waybreaker::coalition {

// What vehicles may lose on each other where nobody would do otherwise: of an objective, collisions aside, so much of
// which is not proven.
double tolerable_loss(double objective, double unproven);

// Plans the vehicles past each other for the best drafts, and puts the best plan into `plan`. With `most`: at most so
// many drafts beside that of nothing, none that costs more than a plan, and as many more as it takes to find one; else
// all, for among others a vehicle can find a shorter path than alone. `drafts`: the best first. REQUIRES: plan.closed
// and plan.bound.
void plan_collision_free(const Problem& problem, const team::Interrupts& interrupts, std::span<const Draft> drafts,
                         std::optional<std::size_t> most,
                         const std::function<void(double objective, double bound)>& improved, CoalitionPlan& plan);

// Each draft of another set than the plan's as a plan of its own, if it is above the plan by no more than that share;
// of several drafts of a set, the best.
std::vector<CoalitionPlan> plan_alternatives(const Problem& problem, const team::Interrupts& interrupts,
                                             std::vector<Draft> drafts, double share, const CoalitionPlan& plan);

}  // namespace waybreaker::coalition

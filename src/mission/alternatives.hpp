// Plans that are about as good as the best.
#pragma once

#include <vector>

#include "waybreaker/plan.hpp"

namespace waybreaker {

// What was evaluated on the way to a plan, for alternatives to it.
struct Evaluated {
    double share = 0;  // by which an alternative may be above it
    std::vector<Plan> plans = {};
};

// Appends to `plans`, which holds the best, those evaluated that remove other obstacles and are above it by no more
// than that share, the better first. What is proven of the best is of all of them.
void append_alternatives(const Evaluated& evaluated, Objective objective, std::vector<Plan>& plans);

}  // namespace waybreaker

// Plans that are about as good as the best.
#pragma once

#include <span>
#include <vector>

#include "waybreaker/plan.hpp"

namespace waybreaker {

// Appends to `plans`, which holds the best, those evaluated that remove other obstacles and are above it by no more
// than that share, the better first. What is proven of the best is of all of them.
void append_alternatives(std::span<const Plan> evaluated, double share, Objective objective, std::vector<Plan>& plans);

}  // namespace waybreaker

// A better plan, found under stricter rules.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "waybreaker/plan.hpp"

namespace waybreaker {

// A plan that keeps to more, for a mission whose own plan is worse; what is proven is of the latter.
inline Plan instead(const Plan& own, Plan better, Objective objective) {
    better.limit_reached = own.limit_reached;
    better.seconds = own.seconds;
    better.bound = own.bound;
    better.gap.reset();
    if (own.bound) {
        const double reached = value(better.after, objective).value_or(std::numeric_limits<double>::infinity());
        better.bound = std::min(*own.bound, reached);
        better.gap = *better.bound > 0 ? reached / *better.bound - 1 : 0;
    }
    return better;
}

}  // namespace waybreaker

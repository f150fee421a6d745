// Ranks of one ground and one air agent: what the air agent must keep to for a rank, and which of two is better.
#pragma once

#include <limits>

#include "model/objective.hpp"

namespace waybreaker {

// When the air agent must be done so that a rank's first figure can be `first`, the ground agent not finishing before
// `ground`.
inline double latest_air_finish(Objective objective, double first, double ground) {
    switch (objective) {
        case Objective::makespan:
            return first;
        case Objective::flowtime:
            return first - ground;
        case Objective::ground_makespan:
            break;
    }
    return std::numeric_limits<double>::infinity();
}

// Whether a is better by more than rounding, in time.
inline bool better(const Rank& a, const Rank& b, double rounding) {
    if (a.first < b.first - rounding) return true;
    return a.first <= b.first + rounding && a.second < b.second - rounding;
}

}  // namespace waybreaker

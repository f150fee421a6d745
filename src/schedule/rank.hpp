// Rank: how good it is to finish at certain times, for an objective. Ties of the flowtime go to the makespan, all
// others to the flowtime.
#pragma once

#include <limits>

#include "schedule/course.hpp"

namespace waybreaker {

struct Rank {
    double first = 0;
    double second = 0;
};

inline Rank rank(Objective objective, const Finish& finish) {
    switch (objective) {
        case Objective::makespan:
            return {finish.makespan(), finish.flowtime()};
        case Objective::flowtime:
            return {finish.flowtime(), finish.makespan()};
        case Objective::ground_makespan:
            break;
    }
    return {finish.ground, finish.flowtime()};
}

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

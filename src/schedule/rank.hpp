// Rank: how good it is to finish at certain times, for an objective; ties go to the other objective.
#pragma once

#include "schedule/course.hpp"

namespace waybreaker {

struct Rank {
    double first = 0;
    double second = 0;
};

inline Rank rank(Objective objective, const Finish& finish) {
    if (objective == Objective::makespan) return {finish.makespan(), finish.flowtime()};
    return {finish.flowtime(), finish.makespan()};
}

// Whether a is better by more than rounding, in time.
inline bool better(const Rank& a, const Rank& b, double rounding) {
    if (a.first < b.first - rounding) return true;
    return a.first <= b.first + rounding && a.second < b.second - rounding;
}

}  // namespace waybreaker

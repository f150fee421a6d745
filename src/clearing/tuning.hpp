// Tuning: every constant of this folder that was chosen by measurement. None changes what a plan or a bound means.
#pragma once

#include <cstddef>

namespace waybreaker::clearing::tuning {

// Share of the time for the relaxed mission, which says what is worth to be breached.
inline constexpr double share_of_relaxation = 0.3;
// The same is good enough then: what a vehicle drives longer than an aircraft flies is more.
inline constexpr double gap_of_relaxation = 0.005;
// Share of the time that is left, for each single plan of the others past a clearing.
inline constexpr double share_of_plan = 0.25;
// Obstacles that tours are made of.
inline constexpr std::size_t most_in_pool = 16;
// Crossings on the ways of single vehicles that the pool is filled with.
inline constexpr int most_crossings = 3;
// Of a vehicle that clears, where it would meet others: ever longer ones.
inline constexpr int most_delays = 4;
// Plans of the others; most searches end before. Where aircraft breach as well, each has a choice of its own to make.
inline constexpr std::size_t most_plans = 400;
inline constexpr std::size_t most_plans_with_aircraft = 40;

}  // namespace waybreaker::clearing::tuning

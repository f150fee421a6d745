// Local search over tours for the objective of a schedule: a good tour fast, without proof.
#pragma once

#include "core/stopwatch.hpp"
#include "flight/target.hpp"
#include "schedule/course.hpp"

namespace waybreaker {

// A tour, no worse than the given one, that neither a better cell for one stop nor moving one stop elsewhere improves.
// Deterministic, unless the deadline ends it. Time per round O(stops^3 + cells).
Tour improved_tour(const Course& course, Tour tour, double rounding, const Deadline& deadline);

}  // namespace waybreaker

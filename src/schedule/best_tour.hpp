// The best tour of one aircraft for a ground path.
#pragma once

#include "core/stopwatch.hpp"
#include "flight/target.hpp"
#include "schedule/course.hpp"

namespace waybreaker {

struct BestTour {
    Tour tour;
    bool proven = false;  // none is better
};
// By the course's objective, waits included; of equally good ones by the other objective. Proven for up to
// exact_flight_limit targets, unless the deadline comes first; then it is the best found by then.
BestTour best_tour(const Course& course, const Deadline& deadline);

}  // namespace waybreaker

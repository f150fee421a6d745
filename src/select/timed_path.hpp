// Timed path: the best ground path for a set of obstacles that open in time. Who has to wait anyway waits where the
// rest of the way is shortest, which is seldom on the shortest path.
#pragma once

#include <vector>

#include "select/candidate.hpp"

namespace waybreaker {

// Whether the ground agent stands somewhere before its goal.
bool waits(const Task& task, const Candidate& candidate);

// Puts openings in time.
class TimedPaths {
  public:
    // If the ground agent has to wait, other paths through the same obstacles are tried: each is the shortest for the
    // breaches of the schedule before it, until none is better, or one costs no more than `enough`, or one has been
    // tried before.
    Candidate candidate(const Task& task, const Searchers& searchers, Opening opening, double enough);

  private:
    bool is_new(const Opening& opening);

    struct Tried {
        std::vector<ObstacleId> removed;
        std::vector<Point> path;
        friend bool operator==(const Tried&, const Tried&) = default;
    };
    std::vector<Tried> tried_;
};

}  // namespace waybreaker

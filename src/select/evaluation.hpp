// Evaluation: what a set of obstacles is worth, E(X), and which sets have been evaluated.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "select/candidate.hpp"
#include "select/opening_times.hpp"

namespace waybreaker {

// Where the evaluation of a set may end early: its worth is right then only as far as the cutoff asks.
struct Cutoff {
    double reached = infinity;  // objective of the incumbent: a set that cannot beat it is not improved
    double enough = 0;          // no plan is below: nor is one that reaches that
};

// E(X): the best timetable found of the mission that removes these obstacles, whoever proposed them and whatever else
// was tried. Where nobody waits: the shortest path through them. Who has to wait does so where the rest of the way is
// shortest, which is seldom on the shortest path: then paths for the breaches of the schedule before are tried as well,
// until none is better: from the one for the earliest openings there are, then from the shortest path. What the path
// does without stands again, but for what the rules force.
// `found`: a crossing search whose best path is the shortest through this set, if there is one; it saves time only.
Candidate evaluate(const Task& task, const Searchers& searchers, OpeningTimes& opening_times,
                   std::vector<ObstacleId> removed, const Cutoff& cutoff = {}, const CrossingResult* found = nullptr,
                   double seconds = 0);

// Sets that have been evaluated, each once, and the incumbent among them.
class Evaluation {
  public:
    // All must outlive it. `start` removes nothing but what must be; `opening_times` are those with waits.
    Evaluation(const Task& task, const Searchers& searchers, OpeningTimes& opening_times, const Candidate& start);

    // Evaluates what must be removed and these. Returns the objective; infinity where it cannot beat the incumbent.
    double add(std::span<const ObstacleId> others, const CrossingResult* found = nullptr, double seconds = 0);

    // The objective of the incumbent.
    double least() const { return least_; }
    void raise_bound(double objective) { enough_ = std::max(enough_, objective); }

    // In the order in which they came.
    std::vector<Candidate> candidates() && { return std::move(candidates_); }

  private:
    const Task& task_;
    Searchers searchers_;
    OpeningTimes& opening_times_;
    double least_;
    double enough_ = 0;
    std::map<std::vector<ObstacleId>, double> objectives_;  // by set, sorted
    std::vector<Candidate> candidates_;
};

}  // namespace waybreaker

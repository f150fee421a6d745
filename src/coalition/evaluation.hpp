// Evaluation: what sets of obstacles are worth, each put in time for all vehicles and aircraft; collisions aside.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "coalition/sorties.hpp"
#include "select/candidate.hpp"

namespace waybreaker::coalition {

class Evaluation {
  public:
    // `closed`: the vehicles past all obstacles. All arguments must outlive it.
    Evaluation(const Problem& problem, std::span<const team::Vehicle> closed, Workers& workers)
        : problem_(problem), ways_(problem, closed), sorties_(problem, ways_, workers) {}

    // Evaluates a set beside what must be removed; once.
    void evaluate(const Set& set);
    // The same, and drops what is no better than a set evaluated before.
    void evaluate_growing(const Set& set);
    // Evaluates a set and drops nothing of it, though nobody drive through it.
    void evaluate_whole(const Set& set);
    // Evaluates what a vehicle's own mission removes again, as that mission has it.
    void evaluate_as_own(std::size_t vehicle, const Candidate& own);
    // Evaluates it again, with the care of SortiePlanner::plan until so much effort is spent.
    void evaluate_carefully(const Set& set, std::uint64_t enough);
    std::uint64_t effort() const { return ways_.effort(); }

    // Those that have a plan, the best first.
    std::span<const Draft> drafts() const { return drafts_; }
    std::vector<Draft> take_drafts() && { return std::move(drafts_); }
    // The objective of the best; infinity if there is none.
    double reached() const { return drafts_.empty() ? infinity : drafts_.front().cost.first; }

  private:
    Set with_forced(const Set& set) const { return united(problem_.forced(), set); }
    bool is_new(const Set& all);
    void add(Draft draft);

    const Problem& problem_;
    Ways ways_;
    SortiePlanner sorties_;
    std::vector<Set> evaluated_;
    std::vector<Draft> drafts_;
};

}  // namespace waybreaker::coalition

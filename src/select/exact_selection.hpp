// One exact selection: proposers give sets, each is evaluated once, a bound says when to stop. docs/exact.md has the
// proposers, their order and their budgets in one table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "select/bound.hpp"
#include "select/evaluation.hpp"
#include "select/opening_times.hpp"
#include "select/selector.hpp"

namespace waybreaker {

class ExactSelection {
  public:
    // `opening_times`: with waits, or as if nobody waited. What is found and proven goes to `evaluation` and
    // `selected`.
    ExactSelection(const Task& task, const Searchers& searchers, const Candidate& start, OpeningTimes& opening_times,
                   const Deadline& deadline, Evaluation& evaluation, Selected& selected)
        : task_(task),
          searchers_(searchers),
          start_(start),
          opening_times_(opening_times),
          deadline_(deadline),
          evaluation_(evaluation),
          selected_(selected),
          best_(evaluation.least()) {}

    void run();
    // The set that is best if nobody waits. Whether it is proven to be the best with waits.
    bool prove_at_once();
    // What may be better than the best, once a bound is proven.
    void select();

  private:
    // With fewer removals than `more`: sets that are better than `reached`.
    ExactSelection(const Task& task, const ExactSelection& more, double reached, Selected& selected);

    // The bound of the relaxed body, and the proposers that make its proof short, in that share of the time.
    void prove(double share);
    void prove_relaxed(double share, double expected, std::uint64_t expansions);
    void propose_sets();
    void propose_simple_sets();
    void propose_likely_sets();

    // Proposers, each with its set or sets. docs/exact.md says when and how long.
    void try_square_first();                       // the square's best set, before the bound
    CrossingResult try_square();                   // the same after it
    void try_for_square();                         // another planner: what opens the way for the square
    void try_relaxed();                            // the relaxed body's best set
    void try_priced();                             // openings late: each breach has a price, and nobody waits
    void try_weighted(double seconds);             // a set that is about as good as the best, soon
    void try_shortcuts();                          // what stands between the bends of the path without removal
    void try_most_hit();                           // the paper's
    void try_greedy();                             // one removal after the other
    void try_steps(double seconds);                // steps from cell to cell: a bound as well
    bool try_others(const CrossingResult& first);  // all sets in order; whether they came to their end
    void try_fewer();                              // the same selection with fewer removals
    void try_likely_of_fewer();                    // openings late: fewer removals, whose openings come sooner
    void try_all();                                // every set of so many that there are few

    // The best set of a few obstacles.
    void try_within(std::span<const ObstacleId> likely);
    // A path that a search has found, and what it crosses.
    void try_out(const CrossingPath& path, const CrossingResult& search);
    void add(std::span<const ObstacleId> others, const CrossingResult* found = nullptr, double seconds = 0);

    void raise_bound(double objective);
    // Where the relaxed body slips through what stops the disc, the square's shortest path proves more.
    void raise_bound_by_square(const CrossingResult& found);
    double bound() const { return selected_.bound.value_or(0); }

    // By enough.
    bool beats_best(const CrossingPath& path) const;
    // Whether the plan is so far above the bound.
    bool is_above_bound(double gap) const { return best_ > bound_.objective * (1 + gap); }
    bool is_good_enough() const;
    bool passes_more_than_square() const;
    bool has_little_time() const;
    std::uint64_t expansions_of_square() const;
    CrossingOptions options_of_square(double objective);

    const Task& task_;
    Searchers searchers_;
    const Candidate& start_;  // removes nothing but what must be
    OpeningTimes& opening_times_;
    Deadline deadline_;
    Evaluation& evaluation_;
    Selected& selected_;
    Bound bound_;                           // of the relaxed body
    std::optional<CrossingResult> square_;  // of try_square_first(), where it came to its end
    Stopwatch since_last_;                  // set
    double best_;                           // objective to be beaten
    bool of_fewer_ = false;                 // part of a selection with more removals
    bool simple_proposed_ = false;          // most hit and greedy
};

}  // namespace waybreaker

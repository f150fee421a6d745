// One exact selection: which sets are tried, in what order, and what is proven meanwhile.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "select/bound.hpp"
#include "select/candidate.hpp"
#include "select/opening_times.hpp"
#include "select/selector.hpp"
#include "select/task.hpp"
#include "select/timed_path.hpp"

namespace waybreaker {

// Of the time that is left: for the weighted search.
inline constexpr double share_of_weighted = 0.8;

// Whether so little time is given that a proof that takes long begins anew once a weighted search has found a good
// plan.
bool in_haste(const Task& task);

class ExactSelection {
  public:
    // `reached`: the objective of the best plan so far.
    ExactSelection(const Task& task, const Searchers& searchers, const Candidate& start, double reached,
                   const Bound& bound, const Deadline& deadline, OpeningTimes& opening_times)
        : task_(task),
          searchers_(searchers),
          start_(start),
          bound_(bound),
          deadline_(deadline),
          opening_times_(opening_times),
          reached_(reached),
          best_(reached),
          proven_(bound.objective) {}

    Selected run() &&;

    // The set whose shortest path is shortest, and nothing else. `best`: no other choice can be better than its plan.
    struct Tried {
        Selected selected;
        bool best = false;
    };
    Tried run_first() &&;

    // The set that is best for the square, and what its search found; none where that takes long.
    struct Square {
        Selected selected;
        std::optional<CrossingResult> found = {};
    };
    Square run_square() &&;

    // What steps from cell to cell tell: a bound, and a good plan.
    Selected run_by_steps() &&;

    // What a weighted search finds: a good plan, soon.
    Selected run_weighted() &&;

    // What run_square() has found.
    void know_square(std::optional<CrossingResult> found) { square_ = std::move(found); }

    // Candidates found before. Lets a plan be found that is as good as theirs: with waits at obstacles, not long before
    // them.
    void take_up(std::vector<Candidate> candidates) {
        earlier_ = std::move(candidates);
        if (reached_ < cost(task_, start_)) best_ *= 1 + 2 * rounding;
    }

  private:
    void try_sets();
    // The set whose shortest path is shortest.
    CrossingResult find_first();
    // All sets that could still be better, in order. Whether they came to their end.
    bool try_others(const CrossingResult& first);
    // What fewer removals reach, more must reach as well. Where the square's path tells how good a set is, only sets
    // that may be better than the best are looked for.
    void try_with_fewer_removals();

    // What is likely to be good.
    void try_within(std::span<const ObstacleId> likely);
    void try_weighted(double seconds);
    void try_by_steps();
    void try_most_hit();
    void try_what_is_likely();
    // In time: as if nobody waited but each removal cost what its breach does.
    void try_priced();
    // In time: with fewer removals, whose openings come sooner.
    void try_likely_of_fewer();
    // Another agent may not fit where a point slips through: what is in its way most often, and what opens the way for
    // the square.
    void try_for_other_planners();
    // A disc that the square does not stand for: what is in the way of Theta* most often, and what greedy selection
    // takes, while the plan is far from its bound.
    void try_for_wide_disc();

    // To force what the plan removes must not be better, nor must it be worse to force that.
    void try_as_if_forced();
    const Candidate& best_so_far() const;
    // The path in time through these; what must be removed stands until it opens, too.
    void try_in_time(const std::vector<ObstacleId>& removed);

    // Puts a path and what it crosses in time. `search` found it.
    void try_out(const CrossingPath& path, const CrossingResult& search);
    void add_candidate(Opening opening);
    // The shortest path through these, in time; once.
    void add_opened(const std::vector<ObstacleId>& removed);

    // Where the relaxed body slips through what stops the disc, the square's shortest path tells more.
    void raise_bound(const CrossingResult& of_square);
    void report() const { task_.report(std::min(best_, reached_), proven_); }

    // By enough.
    bool beats_best(const CrossingPath& path) const;
    bool is_near_bound() const;
    // A plan that costs no more is the best, but for what waits at places half a cell apart may differ by.
    double best_possible() const { return proven_ * (1 + 1e-6); }
    bool is_worth_more() const;
    bool passes_more_than_square() const;
    std::uint64_t patience_of_search() const;
    // In proportion to the search for the first set. Where obstacles open in time that one says little of the others.
    std::uint64_t patience_for_others(const CrossingResult& first) const;

    const Task& task_;
    Searchers searchers_;
    const Candidate& start_;
    const Bound& bound_;
    const Deadline& deadline_;
    OpeningTimes& opening_times_;
    CrossingOptions options_;
    std::optional<CrossingResult> square_;  // of the search for the first set, if it was made before
    Stopwatch since_last_;                  // candidate
    double reached_;                        // of the best plan before
    double best_;                           // to be beaten
    double proven_;                         // no plan costs less
    Selected selected_;
    std::vector<Candidate> earlier_;               // found before
    std::vector<std::vector<ObstacleId>> opened_;  // their shortest paths have been tried
    TimedPaths timed_paths_;
    bool improves_paths_ = true;  // for their timetables
    bool of_fewer_ = false;       // part of a selection with more removals
};

}  // namespace waybreaker

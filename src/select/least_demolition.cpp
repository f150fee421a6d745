#include "select/least_demolition.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "schedule/timetable.hpp"
#include "select/tuning.hpp"

namespace waybreaker {
namespace {

std::uint64_t cells_of(const Task& task, std::span<const ObstacleId> removed) {
    std::uint64_t cells = 0;
    for (const ObstacleId id : to_breach(task.rules, removed)) cells += task.map.obstacle(id).cells;
    return cells;
}

std::uint64_t cells_of(const Task& task, const Candidate& candidate) {
    return cells_of(task, candidate.opening.removed);
}

// Of all candidates within the limit the one that demolishes the least; of several the best.
const Candidate* most_frugal(const Task& task, const Candidate& start, const Selected& selected, const Candidate& best,
                             double limit) {
    const Candidate* frugal = &best;
    const auto consider = [&](const Candidate& candidate) {
        if (cost(task, candidate) > limit) return;
        const auto key = [&](const Candidate& c) { return std::pair(cells_of(task, c), cost(task, c)); };
        if (key(candidate) < key(*frugal)) frugal = &candidate;
    };
    consider(start);
    for (const Candidate& candidate : selected.candidates) consider(candidate);
    return frugal;
}

// Selections within budgets of cells.
class Budgets {
  public:
    Budgets(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline, double limit)
        : task_(task),
          searchers_(searchers),
          selector_(selector),
          baseline_(baseline),
          limit_(limit),
          weighed_(task.map.with_weights(cells_as_weights(task.map))) {}

    struct Outcome {
        std::optional<Candidate> candidate;  // the most frugal one within the limit
        bool proven = false;                 // that there is none
    };

    Outcome within(std::uint64_t cells) {
        Rules frugal = task_.rules;
        frugal.budget = double(cells);
        const Task task = task_.within(tuning::share_of_budget).under(frugal, weighed_);
        const Candidate start = start_of(task, searchers_, baseline_);
        const Selected found = selector_.select(task, start);
        const Candidate& best = best_of(task, start, found.candidates);
        if (cost(task, best) <= limit_) return {*most_frugal(task, start, found, best, limit_)};
        return {std::nullopt, found.bound && *found.bound > limit_};
    }

  private:
    const Task& task_;
    Searchers searchers_;
    Selector& selector_;
    const Candidate& baseline_;
    double limit_;
    Map weighed_;
};

}  // namespace

std::vector<double> cells_as_weights(const Map& map) {
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) weights.push_back(obstacle.cells);
    return weights;
}

LeastCells least_cells(std::uint64_t forced, std::uint64_t known, const Deadline& deadline,
                       const std::function<WithinBudget(std::uint64_t)>& within) {
    LeastCells result{forced};
    const auto middle = [](std::uint64_t low, std::uint64_t high) { return low + (high - 1 - low) / 2; };
    std::uint64_t too_few = result.least;  // no plan was found with fewer
    while (too_few < known && !deadline.passed()) {
        const std::uint64_t cells = middle(too_few, known);
        const WithinBudget found = within(cells);
        if (found.proven) result.least = cells + 1;
        if (found.cells) {
            known = *found.cells;
        } else {
            too_few = cells + 1;
        }
    }
    // A bound that is too weak near the least may do below.
    std::uint64_t unproven = std::min(too_few, known);
    while (result.least < unproven && !deadline.passed()) {
        const std::uint64_t cells = middle(result.least, unproven);
        if (within(cells).proven) {
            result.least = cells + 1;
        } else {
            unproven = cells;
        }
    }
    result.limited = deadline.passed();
    return result;
}

LeastDemolition demolish_least(const Task& task, const Searchers& searchers, Selector& selector,
                               const Candidate& baseline, const Candidate& start, const Selected& selected,
                               const Candidate& best) {
    const double limit = cost(task, best) * (1 + task.rules.minimise_demolition.value_or(0)) * (1 + rounding);
    LeastDemolition result{*most_frugal(task, start, selected, best, limit)};
    Budgets budgets(task, searchers, selector, baseline, limit);
    const auto within = [&](std::uint64_t cells) {
        Budgets::Outcome found = budgets.within(cells);
        if (!found.candidate) return WithinBudget{std::nullopt, found.proven};
        const std::uint64_t demolished = cells_of(task, *found.candidate);
        if (demolished < cells_of(task, result.candidate)) result.candidate = std::move(*found.candidate);
        return WithinBudget{demolished, found.proven};
    };
    const LeastCells found =
        least_cells(cells_of(task, task.rules.force), cells_of(task, result.candidate), task.deadline, within);
    result.least = found.least;
    result.limited = found.limited;
    return result;
}

}  // namespace waybreaker

#include "select/exact.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "select/by_steps.hpp"
#include "select/exact_selection.hpp"

namespace waybreaker {
namespace {

// Expansions: where little time is given, a proof that takes more begins anew once a weighted search has found a good
// plan.
constexpr std::uint64_t easy_expansions = 250;
// Expansions: a proof that takes more is left to steps from cell to cell first.
constexpr std::uint64_t hard_expansions = 5'000;
// Of the time that is left when selecting begins; the rest is for sets that are likely to be good, if the proof is not
// done by then.
constexpr double share_of_proof = 0.8;
// Of the proof's time: for the bound of the relaxed body. The square's comes after it.
constexpr double share_of_relaxed = 0.5;
// Likewise, where obstacles open in time: for what can be said as if they did not.
constexpr double share_of_waitless = 0.3;

// Whether the square's best set comes before the bound, which is found sooner then. With more removals paths are nearly
// straight, and it is the bound that makes the square's search short.
bool begins_with_square(const Task& task, const OpeningTimes& opening_times) {
    constexpr int few_removals = 2;
    return drives_by_steps(task, opening_times) && !opening_times.are_at_once() && !in_haste(task) &&
           task.spare_removals() > 0 && task.spare_removals() <= few_removals;
}

}  // namespace

Selected ExactSelector::select(const Task& task, const Candidate& start) {
    const Deadline deadline = task.deadline.share(share_of_proof);
    task.report(cost(task, start), 0);
    OpeningTimes opening_times(task);
    if (!opening_times.matter() || task.spare_removals() == 0) {
        return select(task, start, Selected(), deadline, opening_times);
    }
    // Often nobody has to wait; and what is proven as if nobody did makes the search in time short.
    OpeningTimes at_once = OpeningTimes::at_once(task);
    const Deadline soon = deadline.share(share_of_waitless);
    Begun begun = begin(task, start, cost(task, start), 0, soon, 1, at_once);
    auto [first, is_best] =
        ExactSelection(task, searchers_, start, begun.reached, begun.bound, soon, at_once).run_first();
    std::ranges::move(begun.likely.candidates, std::back_inserter(first.candidates));
    if (is_best) return std::move(first);
    const bool cut = begun.bound.limited || soon.passed();
    Selected selected = select(task, start, std::move(first), deadline, opening_times);
    selected.limited = selected.limited || cut;
    return selected;
}

Selected ExactSelector::select(const Task& task, const Candidate& start, Selected first, const Deadline& deadline,
                               OpeningTimes& opening_times) {
    const double reached = cost(task, best_of(task, start, first.candidates));
    Begun begun = begin(task, start, reached, first.bound.value_or(0), deadline, share_of_relaxed, opening_times);
    std::ranges::move(begun.likely.candidates, std::back_inserter(first.candidates));
    ExactSelection selection(task, searchers_, start, begun.reached, begun.bound, deadline, opening_times);
    selection.know_square(std::move(begun.square));
    selection.take_up(std::move(first.candidates));
    Selected selected = std::move(selection).run();
    selected.limited = selected.limited || begun.bound.limited;
    return selected;
}

ExactSelector::Begun ExactSelector::begin(const Task& task, const Candidate& start, double reached, double proven,
                                          const Deadline& deadline, double share_of_bound,
                                          OpeningTimes& opening_times) {
    Begun begun{.reached = reached};
    double expected = 0;
    if (begins_with_square(task, opening_times)) {
        ExactSelection selection(task, searchers_, start, reached, begun.bound, deadline, opening_times);
        auto [selected, square] = std::move(selection).run_square();
        begun.likely = std::move(selected);
        begun.square = std::move(square);
        begun.reached = std::min(reached, cost(task, best_of(task, start, begun.likely.candidates)));
        if (begun.square) expected = begun.square->best.length;
    }
    const auto prove = [&](std::uint64_t expansions) {
        begun.bound = prove_bound(task, searchers_.crossing, begun.reached, deadline.share(share_of_bound),
                                  opening_times, proven, expected, expansions);
        begun.bound.objective = std::max(begun.bound.objective, proven);
        task.report(begun.reached, begun.bound.objective);
    };
    const auto is_good_enough = [&] {
        return task.limits.gap > 0 && task.worth(begun.reached) <= begun.bound.objective;
    };
    const bool in_steps = has_time_for_steps(task, opening_times);
    const bool hastes = in_haste(task) && task.spare_removals() > 0 && !opening_times.matter();
    if (!in_steps && !hastes) {
        prove(UINT64_MAX);
        return begun;
    }
    prove(hastes ? easy_expansions : hard_expansions);
    if (is_good_enough()) begun.bound.limited = false;
    if (!begun.bound.limited || deadline.passed()) return begun;
    const Deadline soon = deadline.share(share_of_weighted);
    ExactSelection selection(task, searchers_, start, begun.reached, begun.bound, soon, opening_times);
    Selected likely = hastes ? std::move(selection).run_weighted() : std::move(selection).run_by_steps();
    begun.reached = std::min(begun.reached, cost(task, best_of(task, start, likely.candidates)));
    proven = std::max(begun.bound.objective, likely.bound.value_or(0));
    std::ranges::move(likely.candidates, std::back_inserter(begun.likely.candidates));
    begun.likely.limited = begun.likely.limited || likely.limited;
    begun.bound.objective = proven;
    if (!is_good_enough()) prove(UINT64_MAX);
    begun.bound.by_steps = !hastes;
    return begun;
}

}  // namespace waybreaker

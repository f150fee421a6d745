#include "select/exact_selection.hpp"

#include <algorithm>
#include <utility>

#include "crossing/access.hpp"
#include "map/gap.hpp"
#include "model/all_sets.hpp"
#include "select/by_steps.hpp"
#include "select/greedy.hpp"
#include "select/hits.hpp"
#include "select/shortcuts.hpp"
#include "select/tuning.hpp"

namespace waybreaker {
namespace {

// No path of the unit square that crosses as much is longer than this times a path of the disc (docs/exact.md, Theorem
// 2): a step to one of eight neighbours after the other is never longer.
constexpr double most_of_square = 1.0823922002923940;  // sqrt(4 - 2 sqrt(2))

// Whether there may be other sets than those that a search has told of.
bool is_cut(SearchStatus search) {
    return search == SearchStatus::limit_reached || search == SearchStatus::not_found;
}

}  // namespace

ExactSelection::ExactSelection(const Task& task, const ExactSelection& more, double reached, Selected& selected)
    : task_(task),
      searchers_(more.searchers_),
      start_(more.start_),
      opening_times_(more.opening_times_),
      deadline_(more.deadline_),
      evaluation_(more.evaluation_),
      selected_(selected),
      bound_(more.bound_),
      best_(reached),
      of_fewer_(true) {
    selected_.bound = bound_.objective;
}

bool ExactSelection::prove_at_once() {
    prove(1);
    try_relaxed();
    if (!is_above_bound(tuning::beaten_in_time)) {
        const CrossingResult first = try_square();
        raise_bound_by_square(first);
        const bool beaten = !first.best.path.empty() && beats_best(first.best);
        if (!is_cut(first.status) && !beaten) return true;
    }
    selected_.limited = selected_.limited || bound_.limited || deadline_.passed();
    return false;
}

void ExactSelection::run() {
    prove(tuning::share_of_relaxed);
    selected_.limited = selected_.limited || bound_.limited;
    select();
}

void ExactSelection::prove(double share) {
    const bool square_first = drives_by_steps(task_, opening_times_) && !opening_times_.are_at_once() &&
                              !has_little_time() && task_.spare_removals() > 0 &&
                              task_.spare_removals() <= tuning::few_removals_of_square;
    if (square_first) try_square_first();
    const double expected = square_ ? square_->best.length : 0;
    const bool by_steps = has_time_for_steps(task_, opening_times_);
    const bool by_weight = has_little_time() && task_.spare_removals() > 0 && !opening_times_.matter();
    if (!by_steps && !by_weight) return prove_relaxed(share, expected, UINT64_MAX);
    prove_relaxed(share, expected, by_weight ? tuning::easy_proof : tuning::hard_proof);
    const auto is_proven = [&] { return task_.limits.gap > 0 && task_.worth(best_) <= bound_.objective; };
    if (is_proven()) bound_.limited = false;
    if (!bound_.limited || deadline_.passed()) return;
    const double seconds = deadline_.share(tuning::share_of_weighted).left();
    if (by_weight) {
        try_weighted(seconds);
    } else {
        try_steps(seconds);
    }
    bound_.objective = std::max(bound_.objective, bound());
    if (!is_proven()) prove_relaxed(share, expected, UINT64_MAX);
    bound_.by_steps = !by_weight;
}

void ExactSelection::prove_relaxed(double share, double expected, std::uint64_t expansions) {
    bound_ = prove_bound(task_, searchers_.crossing, best_, deadline_.share(share), opening_times_, bound(), expected,
                         expansions);
    raise_bound(bound_.objective);
    bound_.objective = bound();
}

void ExactSelection::select() {
    if (task_.spare_removals() > 0) {
        propose_sets();
        if (passes_more_than_square()) propose_simple_sets();
        try_all();
    }
    if (best_ > bound() * (1 + tuning::worth_stepping) && !is_good_enough() && !bound_.by_steps) {
        try_steps(deadline_.left());
    }
}

void ExactSelection::propose_sets() {
    if (!drives_by_crossing(task_)) {
        // Another agent may not fit where a point slips through.
        try_most_hit();
        try_for_square();
    }
    if (task_.limits.gap > 0 && is_good_enough()) return;
    if (square_ && !beats_best(square_->best)) return raise_bound_by_square(*square_);
    // Most often the set that is best for a point cannot be beaten, and to know a good path makes the proof short.
    try_relaxed();
    if (is_good_enough()) return;
    // Where the proof does not end, the search for the square's best set hardly does: what is found soon comes first.
    if (bound_.limited && drives_by_crossing(task_)) propose_simple_sets();
    if (opening_times_.matter() && is_above_bound(tuning::worth_searching)) try_priced();
    const CrossingResult first = square_ ? *square_ : try_square();
    raise_bound_by_square(first);
    if (is_cut(first.status)) {
        const std::uint64_t own = expansions_of_square();
        const bool own_budget = opening_times_.matter() && first.expanded >= own && task_.limits.expansions >= own;
        selected_.may_miss = first.status == SearchStatus::not_found;
        selected_.limited = selected_.limited || (!own_budget && !selected_.may_miss);
        propose_likely_sets();
        if (own_budget && is_above_bound(tuning::worth_searching)) try_likely_of_fewer();
    }
    if (first.status != SearchStatus::found || !beats_best(first.best)) return;
    if (!try_others(first)) try_fewer();
}

void ExactSelection::propose_simple_sets() {
    const auto is_far = [&] { return best_ > bound() * (1 + tuning::worth_searching) && !deadline_.passed(); };
    if (of_fewer_ || simple_proposed_ || !is_far()) return;
    simple_proposed_ = true;
    try_most_hit();
    if (is_far()) try_greedy();
}

void ExactSelection::propose_likely_sets() {
    if (!has_little_time() && !opening_times_.matter()) try_weighted(task_.deadline.left() * tuning::share_of_weighted);
    try_shortcuts();
}

void ExactSelection::try_square_first() {
    CrossingOptions options =
        crossing_options(task_, false, task_.worth(best_) * (1 - rounding), deadline_.left(), opening_times_);
    options.limits.expansions = std::min(options.limits.expansions, tuning::square_first);
    CrossingResult found = find_path(task_, searchers_.crossing, options, opening_times_);
    if (is_cut(found.status) || found.status == SearchStatus::stopped) return;
    if (!found.best.path.empty()) try_out(found.best, found);
    square_ = std::move(found);
}

CrossingResult ExactSelection::try_square() {
    CrossingOptions options = options_of_square(task_.worth(best_) * (1 - rounding));
    options.limits.expansions = std::min(options.limits.expansions, expansions_of_square());
    CrossingResult found = find_path(task_, searchers_.crossing, options, opening_times_);
    if (!found.best.path.empty() && beats_best(found.best)) try_out(found.best, found);
    return found;
}

CrossingOptions ExactSelection::options_of_square(double objective) {
    CrossingOptions options =
        crossing_options(task_, !drives_by_crossing(task_), objective, deadline_.left(), opening_times_);
    options.expected = costliest_path(task_, bound_.objective, opening_times_);
    return options;
}

void ExactSelection::try_for_square() {
    const CrossingOptions options = crossing_options(task_, false, best_, deadline_.left(), opening_times_);
    const CrossingResult found = find_path(task_, searchers_.crossing, options, opening_times_);
    if (!found.best.path.empty()) try_out(found.best, found);
}

void ExactSelection::try_relaxed() {
    try_within(bound_.removed);
}

void ExactSelection::try_priced() {
    for (const double share : {1.0, 0.5, 0.25}) {
        try_within(find_priced(task_, searchers_.crossing, share, cost(task_, start_), deadline_.left()).best.crossed);
    }
    selected_.limited = selected_.limited || deadline_.passed();
}

void ExactSelection::try_weighted(double seconds) {
    try_within(find_good(task_, searchers_.crossing, best_, seconds, opening_times_).best.crossed);
}

void ExactSelection::try_shortcuts() {
    const std::vector<Point>& closed = start_.opening.ground.path;
    try_within(closed.empty() ? chosen_by_hits(task_, search_counting_hits(task_, searchers_.cells).hits)
                              : chosen_by_shortcuts(task_, closed));
}

void ExactSelection::try_most_hit() {
    const std::vector<ObstacleId> hit = chosen_by_hits(task_, search_counting_hits(task_, searchers_.cells).hits);
    for (std::size_t count = task_.given.size() + 1; count <= hit.size() && !deadline_.passed(); ++count) {
        add(std::span(hit).first(count));
    }
}

void ExactSelection::try_greedy() {
    const Task limited = task_.within(tuning::share_of_greedy);
    for (const GreedyStep& step : greedy_steps(limited, searchers_.crossing)) add(step.removed);
}

void ExactSelection::try_steps(double seconds) {
    if (!has_time_for_steps(task_, opening_times_)) return;
    const Bound steps = prove_by_steps(task_, best_, seconds, opening_times_);
    raise_bound(steps.objective);
    try_within(steps.removed);
}

bool ExactSelection::try_others(const CrossingResult& first) {
    CrossingOptions options = options_of_square(task_.worth(best_));
    std::uint64_t own = expansions_of_square();
    if (!opening_times_.matter()) {
        own = std::min(tuning::enumeration, std::max(tuning::least_enumeration, first.expanded / 2));
    }
    options.limits.expansions = std::min(options.limits.expansions, own);
    CrossingSearcher enumerator = crossing::Access::another(searchers_.crossing);
    int tried = 0;
    bool is_enough = false;
    const auto try_next = [&](const CrossingPath& path) {
        if (!beats_best(path)) return false;
        is_enough = tried == most_sets(task_);
        if (is_enough) return false;
        ++tried;
        try_out(path, first);
        return !deadline_.passed();
    };
    const CrossingResult rest = enumerate_paths(task_, enumerator, options, opening_times_, try_next);
    const bool cut = is_cut(rest.status);
    // A budget of its own is the method's; the limits are the caller's.
    selected_.limited = selected_.limited || deadline_.passed() || (cut && task_.limits.expansions < own);
    return !is_enough && !cut;
}

void ExactSelection::try_fewer() {
    if (deadline_.passed()) return;
    Rules fewer = task_.rules;
    --fewer.removals;
    const Task less = task_.under(fewer);
    // Where the square's path tells how good a set is, only what may be better than the best is looked for. Elsewhere
    // what fewer removals reach, more must reach as well.
    const bool tells = drives_by_crossing(task_) && !passes_more_than_square() && !opening_times_.matter();
    const double reached = tells ? best_ * (1 + tuning::most_shortened) : cost(task_, start_);
    Selected of_fewer;
    ExactSelection(less, *this, reached, of_fewer).select();
    selected_.limited = selected_.limited || of_fewer.limited;
}

void ExactSelection::try_likely_of_fewer() {
    Rules fewer = task_.rules;
    while (--fewer.removals > int(fewer.force.size()) && !deadline_.passed()) {
        const Task less = task_.under(fewer);
        Selected of_fewer;
        ExactSelection selection(less, *this, best_, of_fewer);
        selection.try_priced();
        selection.propose_likely_sets();
        best_ = selection.best_;
        selected_.limited = selected_.limited || of_fewer.limited || deadline_.passed();
    }
}

void ExactSelection::try_all() {
    if (of_fewer_ || !is_above_bound(std::max(task_.limits.gap, tuning::enough_in_time))) return;
    const auto may_gain = [&](const Obstacle& obstacle) {
        const auto is_named = [&](const std::vector<ObstacleId>& ids) {
            return std::ranges::find(ids, obstacle.id) != ids.end();
        };
        if (obstacle.gone() || !obstacle.destructible || is_named(task_.rules.protect) || is_named(task_.given))
            return false;
        const double near = task_.driver.body.reach() + 1;
        const double ends = gap(obstacle.bounds, task_.driver.start) + gap(obstacle.bounds, task_.driver.goal);
        return least_objective(task_, std::max(ends - 2 * near, 0.0), opening_times_) < task_.worth(best_);
    };
    std::vector<ObstacleId> obstacles;
    for (const Obstacle& obstacle : task_.map.obstacles()) {
        if (may_gain(obstacle)) obstacles.push_back(obstacle.id);
    }
    const auto allowed = [&](std::span<const ObstacleId> set) {
        double weight = 0;
        for (const ObstacleId id : set) weight += task_.map.obstacle(id).weight;
        return weight <= task_.spare_budget() * (1 + rounding);
    };
    // With one removal more there may be too many, but none of the smaller ones is left out then.
    std::vector<std::vector<ObstacleId>> sets;
    for (int largest = task_.spare_removals(); largest > 0 && sets.empty(); --largest)
        sets = all_sets(obstacles, largest, allowed, tuning::most_sets_evaluated);
    for (const std::vector<ObstacleId>& set : sets) {
        if (deadline_.passed()) return;
        if (!set.empty()) add(set);
    }
}

void ExactSelection::try_within(std::span<const ObstacleId> likely) {
    const CrossingResult found = find_within(task_, searchers_.crossing, likely, best_, opening_times_);
    const bool promises = !found.best.path.empty() && beats_best(found.best);
    if (promises) try_out(found.best, found);
    // The square crosses what it found; a wider disc may need all of them gone.
    if (passes_more_than_square() && !likely.empty()) add(likely);
}

void ExactSelection::try_out(const CrossingPath& path, const CrossingResult& search) {
    if (path.crossed.empty()) return;
    if (opening_times_.matter()) return add(path.crossed);
    CrossingResult found = search;
    found.best = path;
    add(path.crossed, &found, since_last_.seconds());
}

void ExactSelection::add(std::span<const ObstacleId> others, const CrossingResult* found, double seconds) {
    best_ = std::min(best_, evaluation_.add(others, found, seconds));
    since_last_ = {};
    task_.report(evaluation_.least(), bound());
}

void ExactSelection::raise_bound(double objective) {
    selected_.bound = std::max(bound(), objective);
    if (!of_fewer_) evaluation_.raise_bound(bound());
    task_.report(evaluation_.least(), bound());
}

void ExactSelection::raise_bound_by_square(const CrossingResult& found) {
    if (!drives_by_steps(task_, opening_times_)) return;
    raise_bound(std::min(least_objective(task_, found.lower_bound / most_of_square, opening_times_), best_));
}

bool ExactSelection::beats_best(const CrossingPath& path) const {
    return least_objective(task_, path.cost, opening_times_) < task_.worth(best_) * (1 - rounding);
}

bool ExactSelection::is_good_enough() const {
    const double enough = std::max(task_.limits.gap, opening_times_.matter() ? tuning::enough_in_time : 0);
    return enough > 0 && !is_above_bound(enough);
}

bool ExactSelection::passes_more_than_square() const {
    const Body& body = task_.driver.body;
    return drives_by_crossing(task_) && !body.is_point() && !square_stands_for(body);
}

bool ExactSelection::has_little_time() const {
    return task_.limits.seconds < tuning::short_time;
}

std::uint64_t ExactSelection::expansions_of_square() const {
    return opening_times_.matter() ? tuning::square_in_time : UINT64_MAX;
}

}  // namespace waybreaker

#include "select/exact_selection.hpp"

#include <iterator>
#include <utility>

#include "select/by_steps.hpp"
#include "select/greedy.hpp"
#include "select/hits.hpp"
#include "select/shortcuts.hpp"

namespace waybreaker {
namespace {

constexpr std::uint64_t patient_expansions = 10'000;
constexpr std::uint64_t quick_expansions = 5'000;  // for the square's first set, before the proof
constexpr std::uint64_t least_patience = 1'000;    // for further sets, however short the search for the first
constexpr double haste = 0.5;                      // seconds
// Where obstacles open in time.
constexpr std::uint64_t patient_expansions_in_time = 4'000;
// Relative: where obstacles open in time, a plan so near to its bound is good enough.
constexpr double close = 1e-3;
// Relative: where a set that is best without waits ends so much later than without them, others are best in time.
constexpr double most_above = 0.03;
// Relative: so far from its bound steps may prove more: seldom that a plan is within 3 % of its bound, often that it is
// within 5 %.
constexpr double far_from_bound = 0.05;
// Relative: so far from its bound a plan is worth further searches for what is likely, in time or for a disc, which may
// need gone what neither the point nor the square does.
constexpr double worth_more = 0.01;
// Relative: the disc's path is hardly ever so much shorter than the square's.
constexpr double most_shortened = 1e-4;

// No path of the unit square that crosses as much is longer than this times a path of the disc (docs/exact.md, Theorem
// 2): a step to one of eight neighbours after the other is never longer.
constexpr double most_of_square = 1.0823922002923940;  // sqrt(4 - 2 sqrt(2))

// Whether there may be other sets than those that a search has told of.
bool is_cut(SearchStatus search) {
    return search == SearchStatus::limit_reached || search == SearchStatus::not_found;
}

}  // namespace

bool in_haste(const Task& task) {
    return task.limits.seconds < haste;
}

Selected ExactSelection::run() && {
    if (task_.spare_removals() > 0) {
        try_sets();
        if (!of_fewer_ && passes_more_than_square()) try_for_wide_disc();
    }
    if (best_ > proven_ * (1 + far_from_bound) && !is_near_bound()) try_by_steps();
    if (opening_times_.matter()) try_as_if_forced();
    selected_.bound = proven_;
    std::ranges::move(earlier_, std::back_inserter(selected_.candidates));
    return std::move(selected_);
}

ExactSelection::Tried ExactSelection::run_first() && {
    improves_paths_ = false;
    try_within(bound_.removed);
    if (best_ > bound_.objective * (1 + most_above)) {
        selected_.bound = proven_;
        return {std::move(selected_)};
    }
    const CrossingResult first = find_first();
    raise_bound(first);
    selected_.bound = proven_;
    const bool beaten = !first.best.path.empty() && beats_best(first.best);
    return {std::move(selected_), !is_cut(first.status) && !beaten};
}

ExactSelection::Square ExactSelection::run_square() && {
    CrossingOptions options =
        crossing_options(task_, false, task_.worth(best_) * (1 - rounding), deadline_.left(), opening_times_);
    options.limits.expansions = std::min(options.limits.expansions, quick_expansions);
    CrossingResult found = searchers_.crossing.find(task_.map, task_.driver.start, task_.driver.goal, options);
    if (is_cut(found.status) || found.status == SearchStatus::stopped) return {};
    if (!found.best.path.empty()) try_out(found.best, found);
    return {std::move(selected_), std::move(found)};
}

Selected ExactSelection::run_by_steps() && {
    try_by_steps();
    selected_.bound = proven_;
    return std::move(selected_);
}

Selected ExactSelection::run_weighted() && {
    try_weighted(deadline_.left());
    return std::move(selected_);
}

void ExactSelection::try_sets() {
    if (!drives_by_crossing(task_)) try_for_other_planners();
    if (task_.limits.gap > 0 && is_near_bound()) return;
    if (square_ && !beats_best(square_->best)) return raise_bound(*square_);
    // Most often the set that is best for a point cannot be beaten, and to know a good path makes the proof short.
    try_within(bound_.removed);
    if (is_near_bound()) return;
    if (opening_times_.matter() && is_worth_more()) try_priced();
    const CrossingResult first = find_first();
    raise_bound(first);
    if (is_cut(first.status)) {
        const bool own_patience = opening_times_.matter() && first.expanded >= patience_of_search() &&
                                  task_.limits.expansions >= patience_of_search();
        selected_.may_miss = first.status == SearchStatus::not_found;
        selected_.limited = selected_.limited || (!own_patience && !selected_.may_miss);
        try_what_is_likely();
        if (own_patience && is_worth_more()) try_likely_of_fewer();
    }
    if (first.status != SearchStatus::found || !beats_best(first.best)) return;
    if (!try_others(first)) try_with_fewer_removals();
}

void ExactSelection::try_as_if_forced() {
    const std::vector<ObstacleId> removed = best_so_far().opening.removed;
    if (removed.empty() || best_ <= best_possible()) return;
    if (!selected_.candidates.empty() || !earlier_.empty()) add_opened(removed);
    if (!task_.rules.force.empty() || waits(task_, best_so_far())) try_in_time(removed);
    report();
}

// As it will be chosen: of equally good ones the one that was found here.
const Candidate& ExactSelection::best_so_far() const {
    const Candidate& last = best_of(task_, start_, selected_.candidates);
    const Candidate& earlier = best_of(task_, start_, earlier_);
    return cost(task_, earlier) < cost(task_, last) * (1 - rounding) ? earlier : last;
}

void ExactSelection::try_in_time(const std::vector<ObstacleId>& removed) {
    if (!drives_by_crossing(task_) || task_.driver.body.is_point()) return;
    // The disc has to wait less than its square.
    CrossingOptions options = crossing_options(task_, false, infinity, a_little_more(task_), opening_times_);
    options.only = removed;
    options.removed = {};
    options.crossings = int(removed.size());
    options.budget = infinity;
    const CrossingResult found = searchers_.crossing.find(task_.map, task_.driver.start, task_.driver.goal, options);
    if (found.best.path.empty()) return;
    Opening opening = drivable(task_.trip(), searchers_, found.best, removed);
    if (opening.status == SearchStatus::found) add_candidate(std::move(opening));
}

void ExactSelection::try_by_steps() {
    if (bound_.by_steps || !has_time_for_steps(task_, opening_times_)) return;
    const Bound steps = prove_by_steps(task_, best_, deadline_.left(), opening_times_);
    proven_ = std::max(proven_, steps.objective);
    try_within(steps.removed);
    report();
}

void ExactSelection::raise_bound(const CrossingResult& of_square) {
    if (!drives_by_steps(task_, opening_times_)) return;
    const double least = least_objective(task_, of_square.lower_bound / most_of_square, opening_times_);
    proven_ = std::max(proven_, std::min(least, best_));
    report();
}

bool ExactSelection::is_near_bound() const {
    const double enough = std::max(task_.limits.gap, opening_times_.matter() ? close : 0);
    return enough > 0 && best_ <= bound_.objective * (1 + enough);
}

bool ExactSelection::is_worth_more() const {
    return best_ > bound_.objective * (1 + worth_more);
}

bool ExactSelection::beats_best(const CrossingPath& path) const {
    return least_objective(task_, path.cost, opening_times_) < task_.worth(best_) * (1 - rounding);
}

void ExactSelection::try_out(const CrossingPath& path, const CrossingResult& search) {
    const std::vector<ObstacleId> removed = task_.with_forced(path.crossed);
    const auto known = [&](const Candidate& candidate) { return candidate.opening.removed == removed; };
    if (path.crossed.empty() || std::ranges::any_of(selected_.candidates, known)) return;
    CrossingResult found = search;
    found.best = path;
    if (!opening_times_.matter()) {
        add_candidate(open(task_.trip(), searchers_, removed, found, since_last_.seconds(),
                           dearest_path(task_, best_, opening_times_)));
    } else {
        if (drives_by_crossing(task_) && !task_.driver.body.is_point()) {
            Opening opening = drivable(task_.trip(), searchers_, path, removed);
            selected_.limited = selected_.limited || opening.limited;
            opening.ground.expanded += search.expanded;
            opening.ground.generated += search.generated;
            opening.ground.seconds = since_last_.seconds();
            if (opening.status == SearchStatus::found) add_candidate(std::move(opening));
        }
        if (beats_best(path)) add_opened(removed);
    }
    report();
    since_last_ = {};
}

std::uint64_t ExactSelection::patience_of_search() const {
    return opening_times_.matter() ? patient_expansions_in_time : patient_expansions;
}

std::uint64_t ExactSelection::patience_for_others(const CrossingResult& first) const {
    const std::uint64_t most = patience_of_search();
    return opening_times_.matter() ? most : std::min(most, std::max(least_patience, first.expanded / 2));
}

void ExactSelection::add_candidate(Opening opening) {
    // The path of a set is hardly shorter for its timetable.
    const bool promises =
        opening.ground.length && least_objective(task_, *opening.ground.length, opening_times_) < best_;
    selected_.candidates.push_back(improves_paths_ && promises
                                       ? timed_paths_.candidate(task_, searchers_, std::move(opening), best_possible())
                                       : candidate_of(task_, std::move(opening)));
    const double reached = cost(task_, selected_.candidates.back());
    if (reached < best_ * (1 - rounding)) best_ = reached;
}

void ExactSelection::add_opened(const std::vector<ObstacleId>& removed) {
    if (std::ranges::find(opened_, removed) != opened_.end()) return;
    opened_.push_back(removed);
    add_candidate(open(task_.trip(), searchers_, removed));
}

void ExactSelection::try_within(std::span<const ObstacleId> likely) {
    const CrossingResult found = find_within(task_, searchers_.crossing, likely, best_, opening_times_);
    const bool promises = !found.best.path.empty() && beats_best(found.best);
    if (promises) try_out(found.best, found);
    if (!passes_more_than_square() || likely.empty()) return;
    // The square crosses them all: its path and what fits the disc have been tried.
    if (promises && !opening_times_.matter() && found.best.crossed.size() == likely.size()) return;
    add_candidate(open(task_.trip(), searchers_, task_.with_forced(likely)));
    report();
}

bool ExactSelection::passes_more_than_square() const {
    const Body& body = task_.driver.body;
    return drives_by_crossing(task_) && !body.is_point() && !square_stands_for(body);
}

void ExactSelection::try_for_other_planners() {
    try_most_hit();
    const CrossingOptions options = crossing_options(task_, false, best_, deadline_.left(), opening_times_);
    const CrossingResult found = searchers_.crossing.find(task_.map, task_.driver.start, task_.driver.goal, options);
    if (!found.best.path.empty()) try_out(found.best, found);
}

void ExactSelection::try_for_wide_disc() {
    const auto is_far = [&] { return best_ > proven_ * (1 + worth_more) && !deadline_.passed(); };
    if (is_far()) try_most_hit();
    if (!is_far()) return;
    for (const GreedyStep& step : greedy_steps(task_, searchers_.crossing)) add_opened(step.removed);
    report();
}

void ExactSelection::try_most_hit() {
    const SearchResult search = search_counting_hits(task_, searchers_.cells);
    const std::vector<ObstacleId> hit = chosen_by_hits(task_, search.hits);
    for (std::size_t count = task_.rules.force.size() + 1; count <= hit.size() && !deadline_.passed(); ++count) {
        add_candidate(open(task_.trip(), searchers_, {hit.begin(), hit.begin() + std::ptrdiff_t(count)}));
    }
}

CrossingResult ExactSelection::find_first() {
    options_ = crossing_options(task_, !drives_by_crossing(task_), task_.worth(best_) * (1 - rounding),
                                deadline_.left(), opening_times_);
    options_.expected = dearest_path(task_, bound_.objective, opening_times_);
    if (opening_times_.matter()) {
        options_.limits.expansions = std::min(options_.limits.expansions, patience_of_search());
    }
    if (square_) return *square_;
    CrossingResult first = searchers_.crossing.find(task_.map, task_.driver.start, task_.driver.goal, options_);
    if (!first.best.path.empty() && beats_best(first.best)) try_out(first.best, first);
    return first;
}

void ExactSelection::try_priced() {
    for (const double share : {1.0, 0.5, 0.25}) {
        const CrossingResult found =
            find_priced(task_, searchers_.crossing, share, cost(task_, start_), deadline_.left());
        try_within(found.best.crossed);
    }
    selected_.limited = selected_.limited || deadline_.passed();
}

void ExactSelection::try_likely_of_fewer() {
    Rules fewer = task_.rules;
    while (--fewer.removals > int(fewer.force.size()) && !deadline_.passed()) {
        const Task less = task_.under(fewer);
        ExactSelection selection(less, searchers_, start_, best_, bound_, deadline_, opening_times_);
        selection.try_priced();
        selection.try_what_is_likely();
        best_ = selection.best_;
        std::ranges::move(selection.selected_.candidates, std::back_inserter(selected_.candidates));
        selected_.limited = selected_.limited || selection.selected_.limited || deadline_.passed();
    }
}

void ExactSelection::try_weighted(double seconds) {
    const CrossingResult found = find_good(task_, searchers_.crossing, best_, seconds, opening_times_);
    try_within(found.best.crossed);
}

void ExactSelection::try_what_is_likely() {
    if (!in_haste(task_) && !opening_times_.matter()) try_weighted(task_.deadline.left() * share_of_weighted);
    const std::vector<Point>& closed = start_.opening.ground.path;
    try_within(closed.empty() ? chosen_by_hits(task_, search_counting_hits(task_, searchers_.cells).hits)
                              : chosen_by_shortcuts(task_, closed));
}

bool ExactSelection::try_others(const CrossingResult& first) {
    options_.length_limit = dearest_path(task_, task_.worth(best_), opening_times_);
    options_.limits.seconds = deadline_.left();
    const std::uint64_t patient = patience_for_others(first);
    options_.limits.expansions = std::min(options_.limits.expansions, patient);
    CrossingSearcher enumerator = searchers_.crossing.another();
    int tried = 0;
    bool gave_up = false;
    const auto try_next = [&](const CrossingPath& path) {
        if (!beats_best(path)) return false;
        gave_up = tried == patience(task_);
        if (gave_up) return false;
        ++tried;
        try_out(path, first);
        return !deadline_.passed();
    };
    const CrossingResult rest =
        enumerator.enumerate(task_.map, task_.driver.start, task_.driver.goal, options_, try_next);
    const bool cut = is_cut(rest.status);
    // Patience is the method's own; the limits are the caller's.
    selected_.limited = selected_.limited || deadline_.passed() || (cut && task_.limits.expansions < patient);
    return !gave_up && !cut;
}

void ExactSelection::try_with_fewer_removals() {
    if (deadline_.passed()) return;
    Rules fewer = task_.rules;
    --fewer.removals;
    const Task less = task_.under(fewer);
    const bool tells = drives_by_crossing(task_) && !passes_more_than_square() && !opening_times_.matter();
    const double reached = tells ? best_ * (1 + most_shortened) : cost(less, start_);
    ExactSelection selection(less, searchers_, start_, reached, bound_, deadline_, opening_times_);
    selection.of_fewer_ = true;
    Selected selected = std::move(selection).run();
    std::ranges::move(selected.candidates, std::back_inserter(selected_.candidates));
    selected_.limited = selected_.limited || selected.limited;
}

}  // namespace waybreaker

#include "select/exact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "select/hits.hpp"
#include "select/shortcuts.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;  // relative: what is less is no gain

// Sets to try after the first, and expansions to look for them. A search for each takes long, and so do schedules of
// many obstacles; where breaching takes time, there are very many sets that could be better and hardly one that is.
int patience(const Task& task) {
    if (!drives_by_crossing(task)) return 8;
    return task.rules.removals <= 3 ? 256 : 16;
}
constexpr std::uint64_t patient_expansions = 10'000;
// Of the time that is left when selecting begins; the rest is for sets that are likely to be good, if the proof is not
// done by then.
constexpr double share_of_proof = 0.8;
// Seconds: a search among few obstacles is short, so that it may be a little late.
constexpr double grace = 0.01;

Body body_of(const Task& task) {
    return drives_by_crossing(task) ? task.driver.body : point_body;
}

double gap(Cell c, const Box& box) {
    const int x = std::max({box.min.x - c.x, c.x - box.max.x, 0});
    const int y = std::max({box.min.y - c.y, c.y - box.max.y, 0});
    return std::sqrt(double(x) * x + double(y) * y);
}

// The longest ground path, in cells, that could still lead to an objective.
double longest_path(const Task& task, double objective) {
    const double left = task.rules.objective == Objective::flowtime ? objective - task.least_flight : objective;
    return left * task.driver.speed;
}

// A path through an obstacle ends no earlier than its breach and the way from there to the goal take.
double least_cost(const Task& task, ObstacleId id) {
    const Obstacle& obstacle = task.map.obstacle(id);
    const double flight = std::max(gap(task.flyer.start, obstacle.bounds) - std::sqrt(2.0), 0.0);
    const double cleared = flight / task.flyer.speed + task.rules.breach_time.of(obstacle);
    const double drive = std::max(gap(task.driver.goal, obstacle.bounds) - 0.5 - task.driver.body.reach(), 0.0);
    return cleared * task.driver.speed + drive;
}

CrossingOptions crossing_options(const Task& task, const Body& body, double longest, double seconds) {
    const Rules& rules = task.rules;
    CrossingOptions crossing;
    crossing.body = body;
    crossing.crossings = task.spare_removals();
    crossing.removed = rules.force;
    crossing.protect = rules.protect;
    crossing.budget = task.spare_budget();
    crossing.length_limit = longest;
    crossing.limits = limits_of(task, seconds);
    if (rules.timing == Timing::enforce) {
        crossing.least_cost = [&task](ObstacleId id) { return least_cost(task, id); };
    }
    return crossing;
}

// The shortest path that crosses none but some obstacles: that is quickly found.
CrossingResult find_within(const Task& task, CrossingSearcher& crossing, std::span<const ObstacleId> obstacles,
                           double longest) {
    if (obstacles.empty()) return {};
    CrossingOptions options = crossing_options(task, body_of(task), longest, std::max(task.deadline.left(), grace));
    options.only = obstacles;
    return crossing.find(task.map, task.driver.start, task.driver.goal, options);
}

// One selection, in the order of its steps.
class ExactSelection {
  public:
    ExactSelection(const Task& task, const Searchers& searchers, const Candidate& start, const Bound& bound,
                   const Deadline& deadline)
        : task_(task),
          searchers_(searchers),
          start_(start),
          bound_(bound),
          deadline_(deadline),
          best_(cost(task, start)) {}

    Selected run() && {
        if (task_.spare_removals() == 0) return std::move(selected_);
        // Most often the set that is best for a point cannot be beaten, and to know a good path makes the proof short.
        try_within(bound_.removed);
        const CrossingResult first = find_first();
        if (first.status == SearchStatus::limit_reached) try_what_is_likely();
        if (first.status != SearchStatus::found || !beats_best(first.best)) return std::move(selected_);
        if (!try_others(first)) try_with_fewer_removals();
        return std::move(selected_);
    }

  private:
    bool beats_best(const CrossingPath& path) const {
        return task_.objective(path.cost / task_.driver.speed, task_.least_flight) < best_ * (1 - rounding);
    }

    // Puts a path and what it crosses in time. `search` found it.
    void try_out(const CrossingPath& path, const CrossingResult& search) {
        const std::vector<ObstacleId> removed = task_.with_forced(path.crossed);
        const auto known = [&](const Candidate& candidate) { return candidate.opening.removed == removed; };
        if (path.crossed.empty() || std::ranges::any_of(selected_.candidates, known)) return;
        CrossingResult found = search;
        found.best = path;
        Opening opening = drives_by_crossing(task_) ? opening_of(removed, found, since_last_.seconds())
                                                    : open(task_, searchers_, removed);
        selected_.candidates.push_back(candidate_of(task_, std::move(opening)));
        best_ = std::min(best_, cost(task_, selected_.candidates.back()));
        task_.report(best_, bound_.objective);
        since_last_ = {};
    }

    void try_within(std::span<const ObstacleId> likely) {
        const CrossingResult found = find_within(task_, searchers_.crossing, likely, longest_path(task_, best_));
        if (!found.best.path.empty() && beats_best(found.best)) try_out(found.best, found);
    }

    // The set whose shortest path is shortest.
    CrossingResult find_first() {
        options_ =
            crossing_options(task_, body_of(task_), longest_path(task_, best_) * (1 - rounding), deadline_.left());
        options_.expected = longest_path(task_, bound_.objective);
        CrossingResult first = searchers_.crossing.find(task_.map, task_.driver.start, task_.driver.goal, options_);
        if (!first.best.path.empty() && beats_best(first.best)) try_out(first.best, first);
        return first;
    }

    void try_what_is_likely() {
        selected_.limited = true;
        const std::vector<Point>& closed = start_.opening.ground.path;
        try_within(closed.empty() ? chosen_by_hits(task_, search_counting_hits(task_, searchers_.cells).hits)
                                  : chosen_by_shortcuts(task_, closed));
    }

    // All sets that could still be better, in order. Whether they came to their end.
    bool try_others(const CrossingResult& first) {
        options_.length_limit = longest_path(task_, best_);
        options_.limits.seconds = deadline_.left();
        options_.limits.expansions = std::min(options_.limits.expansions, patient_expansions);
        CrossingSearcher enumerator;
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
        const bool cut = rest.status == SearchStatus::limit_reached;
        // Patience is the method's own; the limits are the caller's.
        selected_.limited = deadline_.passed() || (cut && task_.limits.expansions < patient_expansions);
        return !gave_up && !cut;
    }

    // What fewer removals reach, more must reach as well.
    void try_with_fewer_removals() {
        if (deadline_.passed()) return;
        Rules fewer = task_.rules;
        --fewer.removals;
        const Task less = task_.under(fewer);
        Selected selected = ExactSelection(less, searchers_, start_, bound_, deadline_).run();
        std::ranges::move(selected.candidates, std::back_inserter(selected_.candidates));
        selected_.limited = selected_.limited || selected.limited;
    }

    const Task& task_;
    Searchers searchers_;
    const Candidate& start_;
    const Bound& bound_;
    const Deadline& deadline_;
    CrossingOptions options_;
    Stopwatch since_last_;  // candidate
    double best_;
    Selected selected_;
};

}  // namespace

Selected ExactSelector::select(const Task& task, const Candidate& start) {
    const Deadline deadline = task.deadline.share(share_of_proof);
    task.report(cost(task, start), 0);
    const Bound bound = prove_bound(task, searchers_.crossing, cost(task, start), deadline);
    task.report(cost(task, start), bound.objective);
    Selected selected = ExactSelection(task, searchers_, start, bound, deadline).run();
    selected.bound = bound.objective;
    selected.limited = selected.limited || bound.limited;
    return selected;
}

Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline) {
    const CrossingOptions options = crossing_options(task, point_body, longest_path(task, reached), deadline.left());
    const auto least = [&](double path, double flight) { return task.objective(path / task.driver.speed, flight); };
    if (task.rules.objective != Objective::flowtime) {
        CrossingResult found = crossing.find(task.map, task.driver.start, task.driver.goal, options);
        return {std::min(least(found.lower_bound, task.least_flight), reached), std::move(found.best.crossed),
                found.status == SearchStatus::limit_reached};
    }
    // The flight past the obstacles of a set counts as well.
    Bound best{infinity, {}};
    int tried = 0;
    const CrossingResult rest =
        crossing.enumerate(task.map, task.driver.start, task.driver.goal, options, [&](const CrossingPath& path) {
            if (least(path.cost, task.least_flight) >= std::min(best.objective, reached) || tried == patience(task))
                return false;
            ++tried;
            const std::vector<ObstacleId> removed = task.with_forced(path.crossed);
            const double objective = least(path.cost, least_flight_time(task, removed));
            if (objective < best.objective) best = {objective, path.crossed};
            return true;
        });
    best.objective = std::min({best.objective, least(rest.lower_bound, task.least_flight), reached});
    best.limited = rest.status == SearchStatus::limit_reached;
    return best;
}

}  // namespace waybreaker

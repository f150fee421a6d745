#include "mission/exact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "mission/hits.hpp"
#include "mission/shortcuts.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;  // relative: what is less is no gain

// The crossing search drives the ground path itself where its body is the agent.
bool drives_itself(const Task& task) {
    return task.planner() == Planner::optimal;
}

// Sets to try after the first, and expansions to look for them. A search for each takes long, and so do schedules of
// many obstacles; where breaching takes time, there are very many sets that could be better and hardly one that is.
int patience(const Task& task) {
    if (!drives_itself(task)) return 8;
    return task.rules.removals <= 3 ? 256 : 16;
}
constexpr std::uint64_t patient_expansions = 10'000;
// Of the time that is left: for the optimal ground path, before a quick search takes over.
constexpr double share_of_optimal_path = 0.5;
// Seconds: a search among few obstacles is short, so that it may be a little late.
constexpr double grace = 0.01;

Body body_of(const Task& task) {
    return drives_itself(task) ? task.driver.body : point_body;
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

// The task's limits, with so many seconds.
Limits limits_of(const Task& task, double seconds) {
    return {.seconds = seconds, .expansions = task.limits.expansions, .stop = task.limits.stop};
}

CrossingOptions crossing_options(const Task& task, const Body& body, double longest, double seconds) {
    const Rules& rules = task.rules;
    CrossingOptions crossing;
    crossing.body = body;
    crossing.crossings = task.spare_removals();
    crossing.removed = rules.force;
    crossing.protect = rules.protect;
    crossing.budget = rules.budget;
    for (const ObstacleId id : rules.force) crossing.budget -= task.map.obstacle(id).weight;
    crossing.length_limit = longest;
    crossing.limits = limits_of(task, seconds);
    if (rules.timing == Timing::enforce) {
        crossing.least_cost = [&task](ObstacleId id) { return least_cost(task, id); };
    }
    return crossing;
}

Candidate candidate_of(std::vector<ObstacleId> removed, const CrossingResult& result, double seconds) {
    Candidate candidate{std::move(removed), result.status, {}, result.status == SearchStatus::limit_reached};
    candidate.ground.expanded = result.expanded;
    candidate.ground.generated = result.generated;
    candidate.ground.seconds = seconds;
    if (result.best.path.empty()) return candidate;
    candidate.status = SearchStatus::found;  // even where a limit ended the search
    candidate.ground.length = result.best.length;
    candidate.ground.path = result.best.path;
    return candidate;
}

// The shortest path that crosses none but some obstacles: that is quickly found.
CrossingResult find_within(const Task& task, CrossingSearcher& crossing, std::span<const ObstacleId> obstacles,
                           double longest) {
    if (obstacles.empty()) return {};
    CrossingOptions options = crossing_options(task, body_of(task), longest, std::max(task.deadline.left(), grace));
    options.only = obstacles;
    return crossing.find(task.map, task.driver.start, task.driver.goal, options);
}

}  // namespace

Candidate ground_candidate(const Task& task, CrossingSearcher& crossing, Searcher& searcher,
                           std::vector<ObstacleId> removed) {
    const Stopwatch watch;
    if (drives_itself(task)) {
        CrossingOptions options;
        options.body = body_of(task);
        options.removed = removed;
        options.limits = limits_of(task, task.deadline.share(share_of_optimal_path).left());
        const CrossingResult found = crossing.find(task.map, task.driver.start, task.driver.goal, options);
        const bool out_of_time = found.status == SearchStatus::limit_reached && found.best.path.empty() &&
                                 found.expanded < options.limits.expansions;
        if (!out_of_time) return candidate_of(std::move(removed), found, watch.seconds());
    }
    const SearchResult found =
        searcher.find(OpenedMap(task.map, removed), task.driver.start, task.driver.goal, cell_search(task));
    Candidate candidate = candidate_of(std::move(removed), found, watch.seconds());
    candidate.limited = candidate.limited || drives_itself(task);
    return candidate;
}

Choice choice_by_proof(const Task& task, CrossingSearcher& crossing, Searcher& searcher, const Draft& least,
                       const Bound& bound, const Deadline& deadline) {
    if (task.spare_removals() == 0) return {};
    Stopwatch searching;  // since the last draft
    Choice choice;
    std::vector<Draft>& drafts = choice.drafts;
    double best = cost(task, least);
    const auto beats_best = [&](const CrossingPath& path) {
        return task.objective(path.cost / task.driver.speed, task.least_flight) < best * (1 - rounding);
    };
    const auto try_out = [&](const CrossingPath& path, const CrossingResult& search) {
        const std::vector<ObstacleId> removed = task.with_forced(path.crossed);
        const auto known = [&](const Draft& draft) { return draft.candidate.removed == removed; };
        if (path.crossed.empty() || std::ranges::any_of(drafts, known)) return;
        CrossingResult found = search;
        found.best = path;
        Candidate candidate = drives_itself(task) ? candidate_of(removed, found, searching.seconds())
                                                  : ground_candidate(task, crossing, searcher, removed);
        drafts.push_back(draft_of(task, std::move(candidate)));
        best = std::min(best, cost(task, drafts.back()));
        task.report(best, bound.objective);
        searching = {};
    };

    const auto try_within = [&](std::span<const ObstacleId> likely) {
        const CrossingResult found = find_within(task, crossing, likely, longest_path(task, best));
        if (!found.best.path.empty() && beats_best(found.best)) try_out(found.best, found);
    };

    // Most often the set that is best for a point cannot be beaten, and to know a good path makes the proof short.
    try_within(bound.removed);
    CrossingOptions options =
        crossing_options(task, body_of(task), longest_path(task, best) * (1 - rounding), deadline.left());
    options.expected = longest_path(task, bound.objective);
    const CrossingResult first = crossing.find(task.map, task.driver.start, task.driver.goal, options);
    if (!first.best.path.empty() && beats_best(first.best)) try_out(first.best, first);
    if (first.status == SearchStatus::limit_reached) {
        choice.limited = true;
        const std::vector<Point>& closed = least.candidate.ground.path;
        try_within(closed.empty() ? chosen_by_hits(task, search_counting_hits(task, searcher).hits)
                                  : chosen_by_shortcuts(task, closed));
    }
    if (first.status != SearchStatus::found || !beats_best(first.best)) return choice;

    options.length_limit = longest_path(task, best);
    options.limits.seconds = deadline.left();
    options.limits.expansions = std::min(options.limits.expansions, patient_expansions);
    CrossingSearcher enumerator;
    int tried = 0;
    bool gave_up = false;
    const auto try_next = [&](const CrossingPath& path) {
        if (!beats_best(path)) return false;
        gave_up = tried == patience(task);
        if (gave_up) return false;
        ++tried;
        try_out(path, first);
        return !deadline.passed();
    };
    const CrossingResult rest = enumerator.enumerate(task.map, task.driver.start, task.driver.goal, options, try_next);
    choice.limited = deadline.passed();
    const bool ended_early = gave_up || rest.status == SearchStatus::limit_reached;
    if (ended_early && !deadline.passed()) {  // what fewer removals reach, more must reach as well
        Rules fewer = task.rules;
        --fewer.removals;
        const Task less = task.under(fewer);
        Choice fewer_removals = choice_by_proof(less, crossing, searcher, least, bound, deadline);
        std::ranges::move(fewer_removals.drafts, std::back_inserter(drafts));
        choice.limited = choice.limited || fewer_removals.limited;
    }
    return choice;
}

Bound bound_of(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline) {
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

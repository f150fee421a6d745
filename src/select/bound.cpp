#include "select/bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drive/centres.hpp"
#include "model/opened.hpp"
#include "select/candidate.hpp"
#include "select/tuning.hpp"

namespace waybreaker {
namespace {

// Where nothing is crossed, the relaxed body slips past what the disc must go around; cell centres tell more.
double raised_through_centres(const Task& task, double proven, double reached, const OpeningTimes& opening_times) {
    const Body& body = task.driver.body;
    const bool bends_at_centres = body.corners == Corners::none && !body.is_point();
    if (task.spare_removals() > 0 || !bends_at_centres || std::isinf(reached)) return proven;
    if (task.worth(reached) <= worth_centres * proven) return proven;
    const double known = costliest_path(task, reached, opening_times);
    const double least = least_through_centres(OpenedMap(task.map, task.given), task.driver.start, task.driver.goal,
                                               body, known, most_sight_lines);
    return std::max(proven, std::min(least_objective(task, least, opening_times), reached));
}

Bound prove_by_search(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline,
                      OpeningTimes& opening_times, double proven, double expected, std::uint64_t expansions) {
    CrossingOptions options = crossing_options(task, true, task.worth(reached), deadline.left(), opening_times);
    options.limits.expansions = std::min(options.limits.expansions, expansions);
    options.expected = std::max(costliest_path(task, proven, opening_times), expected);
    const auto least = [&](double path, const Returns& home) { return task.objective(task.arrival(path), home); };
    if (opening_times.matter()) {
        options.limits.expansions = std::min(options.limits.expansions, tuning::proof_in_time);
        CrossingResult found = find_path(task, crossing, options, opening_times);
        const bool cut = found.status == SearchStatus::limit_reached;
        const bool own_budget = cut && found.expanded >= tuning::proof_in_time;
        return {std::min(least_objective(task, found.lower_bound, opening_times), reached),
                std::move(found.best.crossed), cut && !own_budget};
    }
    if (task.rules.objective != Objective::flowtime) {
        CrossingResult found = find_path(task, crossing, options, opening_times);
        return {std::min(least_objective(task, found.lower_bound, opening_times), reached),
                std::move(found.best.crossed), found.status == SearchStatus::limit_reached};
    }
    // The flight past the obstacles of a set counts as well.
    Bound best{infinity, {}};
    const int most_tried = opening_times.are_at_once() ? 1 : most_sets(task);  // the proof in time knows more
    int tried = 0;
    const CrossingResult rest = enumerate_paths(task, crossing, options, opening_times, [&](const CrossingPath& path) {
        const double useless = std::min(best.objective, task.worth(reached));
        if (least(path.cost, task.least_flight) >= useless || tried == most_tried) return false;
        ++tried;
        const std::vector<ObstacleId> removed = task.with_forced(path.crossed);
        const double objective = least(path.cost, least_return(task, removed));
        if (objective < best.objective) best = {objective, path.crossed};
        return true;
    });
    best.objective = std::min({best.objective, least(rest.lower_bound, task.least_flight), reached});
    best.limited = rest.status == SearchStatus::limit_reached;
    return best;
}

}  // namespace

crossing::Opener opener_of(const Task& task, OpeningTimes& opening_times) {
    crossing::Opener opener;
    if (!opening_times.matter()) return opener;
    if (task.rules.objective != Objective::ground_makespan) {
        opener.done_after = [&](std::span<const ObstacleId> obstacles) {
            return opening_times.flight_cells(obstacles);
        };
    }
    opener.adds_both = task.rules.objective == Objective::flowtime;
    return opener;
}

int most_sets(const Task& task) {
    if (!drives_by_crossing(task)) return tuning::most_sets_of_others;
    return task.rules.removals <= tuning::few_removals_to_enumerate ? tuning::most_sets : tuning::most_sets_of_many;
}

double a_little_more(const Task& task) {
    return std::max(task.deadline.left(), tuning::overtime);
}

double costliest_path(const Task& task, double objective, const OpeningTimes& opening_times) {
    const bool flight_apart = task.rules.objective == Objective::flowtime && !opening_times.matter();
    return task.cells_until(flight_apart ? objective - task.least_flight.sum : objective);
}

double least_objective(const Task& task, double path_cost, const OpeningTimes& opening_times) {
    const double time = task.arrival(path_cost);
    return opening_times.matter() ? time : task.objective(time, task.least_flight);
}

CrossingOptions crossing_options(const Task& task, bool relaxed, double objective, double seconds,
                                 OpeningTimes& opening_times) {
    const Rules& rules = task.rules;
    CrossingOptions crossing;
    if (task.driver.body.corners == Corners::none) crossing.body = task.driver.body;
    // Who cuts corners is a point.
    if (task.driver.body.corners != Corners::none && relaxed) crossing.body = point_body;
    crossing.relaxed = relaxed;
    crossing.crossings = task.spare_removals();
    crossing.removed = task.given;
    crossing.protect = rules.protect;
    crossing.budget = task.spare_budget();
    crossing.length_limit = costliest_path(task, objective, opening_times);
    crossing.limits = limits_of(task, seconds);
    if (opening_times.matter()) {
        crossing.opened_after = [&](std::span<const ObstacleId> obstacles) { return opening_times.cells(obstacles); };
    } else {
        crossing.prices = task.prices;
    }
    return crossing;
}

CrossingResult find_path(const Task& task, CrossingSearcher& crossing, const CrossingOptions& options,
                         OpeningTimes& opening_times) {
    return crossing::Access::find(crossing, task.map, task.driver.start, task.driver.goal, options,
                                  opener_of(task, opening_times));
}

CrossingResult enumerate_paths(const Task& task, CrossingSearcher& crossing, const CrossingOptions& options,
                               OpeningTimes& opening_times, const std::function<bool(const CrossingPath&)>& accept) {
    return crossing::Access::enumerate(crossing, task.map, task.driver.start, task.driver.goal, options,
                                       opener_of(task, opening_times), accept);
}

CrossingResult find_within(const Task& task, CrossingSearcher& crossing, std::span<const ObstacleId> obstacles,
                           double objective, OpeningTimes& opening_times) {
    if (obstacles.empty()) return {};
    CrossingOptions options =
        crossing_options(task, !drives_by_crossing(task), objective, a_little_more(task), opening_times);
    options.only = obstacles;
    return find_path(task, crossing, options, opening_times);
}

CrossingResult find_good(const Task& task, CrossingSearcher& crossing, double objective, double seconds,
                         OpeningTimes& opening_times) {
    CrossingOptions options = crossing_options(task, !drives_by_crossing(task), objective, seconds, opening_times);
    options.weight = tuning::weight;
    options.limits.expansions = std::min(options.limits.expansions, tuning::weighted);
    return find_path(task, crossing, options, opening_times);
}

CrossingResult find_priced(const Task& task, CrossingSearcher& crossing, double share, double objective,
                           double seconds) {
    OpeningTimes at_once = OpeningTimes::at_once(task);
    CrossingOptions options = crossing_options(task, !drives_by_crossing(task), objective, seconds, at_once);
    std::vector<double> prices{0};  // by id, from 1
    for (const Obstacle& obstacle : task.map.obstacles()) {
        const double breach = share * task.least_time_to_breach(obstacle);
        prices.push_back((breach + task.rules.rubble) * task.driver.speed);
    }
    if (std::ranges::max(prices) == 0) return {};
    options.prices = prices;
    options.limits.expansions = std::min(options.limits.expansions, tuning::priced);
    return find_path(task, crossing, options, at_once);
}

Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline) {
    OpeningTimes opening_times(task);
    return prove_bound(task, crossing, reached, deadline, opening_times, 0, 0);
}

Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline,
                  OpeningTimes& opening_times, double proven, double expected, std::uint64_t expansions) {
    if (task.worth(reached) <= proven) return {proven};
    if (opening_times.matter() && task.spare_removals() == 0) {
        // Nothing is crossed; the search in time knows less of corners.
        OpeningTimes at_once = OpeningTimes::at_once(task);
        return prove_bound(task, crossing, reached, deadline, at_once, proven, expected, expansions);
    }
    if (opening_times.matter() && task.rules.rubble > 0) {
        // A search in time knows the rubble of one obstacle only; one at once, of all that are crossed.
        OpeningTimes at_once = OpeningTimes::at_once(task);
        Bound priced = prove_by_search(task, crossing, reached, deadline, at_once, proven, expected, expansions);
        if (task.worth(reached) <= priced.objective) return priced;
        proven = std::max(proven, priced.objective);
    }
    Bound bound = prove_by_search(task, crossing, reached, deadline, opening_times, proven, expected, expansions);
    bound.objective = std::max(bound.objective, proven);
    bound.objective = raised_through_centres(task, bound.objective, reached, opening_times);
    return bound;
}

}  // namespace waybreaker

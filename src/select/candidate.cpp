#include "select/candidate.hpp"

#include <algorithm>

#include "core/stopwatch.hpp"
#include "map/line_of_sight.hpp"
#include "plan/timeline.hpp"
#include "select/fitted.hpp"
#include "select/shortened.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

// Of the time that is left: for the optimal ground path, before a quick search takes over.
constexpr double share_of_optimal_path = 0.5;
// Relative, above the path of the relaxed body: a path so short is good enough; so long, the disc may have another way.
constexpr double short_enough = 0.01;
constexpr double too_long = 0.05;

// As the disc drives it; a point drives the path as it is.
void drive(const Task& task, Opening& opening, const std::vector<Point>& path, double length) {
    opening.status = SearchStatus::found;  // even where a limit ended the search
    const Body& body = task.driver.body;
    opening.ground.path = body.is_point() ? path : shortened(OpenedMap(task.map, opening.removed), body, path);
    opening.ground.length = opening.ground.path == path ? length : path_length(opening.ground.path);
}

// The optimal path in half the time that is left.
CrossingOptions open_search(const Task& task, std::span<const ObstacleId> removed) {
    CrossingOptions options;
    options.body = task.driver.body;
    options.removed = removed;
    options.limits = limits_of(task, task.deadline.share(share_of_optimal_path).left());
    return options;
}

Opening open_by_cells(const Task& task, const Searchers& searchers, std::vector<ObstacleId> removed) {
    const Stopwatch watch;
    const SearchResult found =
        searchers.cells.find(OpenedMap(task.map, removed), task.driver.start, task.driver.goal, cell_search(task));
    return opening_of(std::move(removed), found, watch.seconds());
}

Schedule scheduled(const Task& task, const Opening& opening) {
    const std::vector<Point> nowhere{task.driver.start};
    const ScheduleTask asked{.ground_path = opening.ground.path.empty() ? nowhere : opening.ground.path,
                             .driver = task.driver,
                             .flyer = task.flyer,
                             .rules = task.rules,
                             .removed = opening.removed,
                             .time_limit = task.deadline.left()};
    return task.method.flight == FlightRule::optimal
               ? best_schedule(task.map, asked)
               : schedule_of(task.map, asked, fly_nearest(task.map, task.flyer.start, task.flyer.goal, asked.removed));
}

// Lets stand again what the ground path does without, but for what must be removed, which comes first. Whether it let
// any.
bool keep_needed(const Task& task, const Schedule& schedule, Opening& opening) {
    // The shortest path of a point needs all that it crosses.
    if (drives_by_crossing(task) && task.driver.body.is_point()) return false;
    const std::size_t before = opening.removed.size();
    for (std::size_t i = before; i-- > task.rules.force.size();) {
        const auto breach = std::ranges::find(schedule.flight.breaches, opening.removed[i], &BreachPoint::obstacle);
        if (schedule.entered_at[std::size_t(breach - schedule.flight.breaches.begin())]) continue;
        std::vector<ObstacleId> others = opening.removed;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const OpenedMap map(task.map, others);
        const LineOfSight sight(map, task.driver.body);
        const auto blocked = [&](Point a, Point b) { return !sight.clear(cell_of(a), cell_of(b)); };
        if (std::ranges::adjacent_find(opening.ground.path, blocked) == opening.ground.path.end()) {
            opening.removed = std::move(others);
        }
    }
    return opening.removed.size() < before;
}

}  // namespace

Opening opening_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds) {
    Opening opening{std::move(removed), search.status, {}, search.status == SearchStatus::limit_reached};
    Route& ground = opening.ground;
    if (search.status == SearchStatus::found) ground.length = search.length;
    ground.expanded = search.expanded;
    ground.generated = search.generated;
    ground.seconds = seconds;
    ground.path.assign(search.path.begin(), search.path.end());
    return opening;
}

Opening opening_of(const Task& task, std::vector<ObstacleId> removed, const CrossingResult& search, double seconds) {
    Opening opening{std::move(removed), search.status, {}, search.status == SearchStatus::limit_reached};
    Route& ground = opening.ground;
    ground.expanded = search.expanded;
    ground.generated = search.generated;
    ground.seconds = seconds;
    if (search.best.path.empty()) return opening;
    drive(task, opening, search.best.path, search.best.length);
    return opening;
}

void fit_to_disc(const Task& task, const Searchers& searchers, Opening& opening, double shorter_than) {
    const Body& body = task.driver.body;
    if (body.is_point() || square_stands_for(body)) return;
    const Stopwatch watch;
    CrossingOptions options = open_search(task, opening.removed);
    options.relaxed = true;
    options.length_limit = std::min(shorter_than, opening.ground.length.value_or(infinity));
    const CrossingResult guide = searchers.crossing.find(task.map, task.driver.start, task.driver.goal, options);
    if (guide.best.path.empty()) return;
    const auto is_within = [&](double gap) {
        return opening.ground.length && *opening.ground.length <= guide.lower_bound * (1 + gap);
    };
    if (is_within(short_enough)) return;
    const std::vector<Point> path =
        fitted(OpenedMap(task.map, opening.removed), body, guide.best.path, options.length_limit, !is_within(too_long));
    if (!path.empty()) drive(task, opening, path, path_length(path));
    options = open_search(task, opening.removed);
    if (!opening.ground.length &&
        searchers.crossing.has_steps(task.map, task.driver.start, task.driver.goal, options)) {
        const bool limited = opening.limited;
        opening = open_by_cells(task, searchers, std::move(opening.removed));
        opening.limited = opening.limited || limited;
    }
    opening.ground.seconds += watch.seconds();
}

bool square_stands_for(const Body& body) {
    return !body.is_point() && body.reach() >= 0.36 && body.reach() <= 0.5;
}

bool drives_by_crossing(const Task& task) {
    return task.planner() == Planner::optimal;
}

SearchOptions cell_search(const Task& task) {
    SearchOptions search = search_options(task.method, task.driver.body);
    if (search.planner == Planner::optimal) search.planner = Planner::theta;
    search.limits = limits_of(task, task.deadline.left());
    return search;
}

Opening open(const Task& task, const Searchers& searchers, std::vector<ObstacleId> removed) {
    const Stopwatch watch;
    if (!drives_by_crossing(task)) return open_by_cells(task, searchers, std::move(removed));
    const CrossingOptions options = open_search(task, removed);
    const CrossingResult found = searchers.crossing.find(task.map, task.driver.start, task.driver.goal, options);
    const bool out_of_time = found.status == SearchStatus::limit_reached && found.best.path.empty() &&
                             found.expanded < options.limits.expansions;
    if (out_of_time) {
        Opening opening = open_by_cells(task, searchers, std::move(removed));
        opening.limited = true;
        return opening;
    }
    Opening opening = opening_of(task, removed, found, watch.seconds());
    fit_to_disc(task, searchers, opening);
    return opening;
}

Candidate candidate_of(const Task& task, Opening opening) {
    const Stopwatch watch;
    Schedule schedule = scheduled(task, opening);
    if (task.rules.timing == Timing::enforce && opening.ground.length && keep_needed(task, schedule, opening)) {
        schedule = scheduled(task, opening);
    }
    return {std::move(opening), std::move(schedule), watch.seconds()};
}

double cost(const Task& task, const Candidate& candidate) {
    if (!candidate.opening.ground.length) return infinity;
    return task.objective(candidate.schedule.ground.back().t, candidate.schedule.air.back().t);
}

const Candidate& best_of(const Task& task, const Candidate& start, const std::vector<Candidate>& candidates) {
    if (candidates.empty()) return start;
    const bool as_paper = task.rules.timing == Timing::ignore && task.method.select == Selection::hits;
    const Candidate* best = as_paper ? &candidates.back() : &start;
    for (const Candidate& candidate : candidates) {
        if (cost(task, candidate) < cost(task, *best) * (1 - 1e-9)) best = &candidate;
    }
    return best->opening.ground.length ? *best : candidates.back();
}

}  // namespace waybreaker

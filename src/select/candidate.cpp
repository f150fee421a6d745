#include "select/candidate.hpp"

#include <algorithm>

#include "core/stopwatch.hpp"
#include "select/shortened.hpp"
#include "waybreaker/flight.hpp"

namespace waybreaker {
namespace {

// Of the time that is left: for the optimal ground path, before a quick search takes over.
constexpr double share_of_optimal_path = 0.5;

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
    opening.status = SearchStatus::found;  // even where a limit ended the search
    ground.length = search.best.length;
    ground.path = search.best.path;
    if (task.driver.body.is_point() || ground.path.size() < 3) return opening;
    ground.path = shortened(OpenedMap(task.map, opening.removed), task.driver.body, std::move(ground.path));
    if (ground.path == search.best.path) return opening;
    ground.length = 0;
    for (std::size_t i = 1; i < ground.path.size(); ++i) {
        *ground.length += distance(ground.path[i - 1], ground.path[i]);
    }
    return opening;
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
    bool limited = false;
    if (drives_by_crossing(task)) {
        CrossingOptions options;
        options.body = task.driver.body;
        options.removed = removed;
        options.limits = limits_of(task, task.deadline.share(share_of_optimal_path).left());
        const CrossingResult found = searchers.crossing.find(task.map, task.driver.start, task.driver.goal, options);
        const bool out_of_time = found.status == SearchStatus::limit_reached && found.best.path.empty() &&
                                 found.expanded < options.limits.expansions;
        // A wide disc may pass where its square does not.
        const bool squeezes_through =
            found.status == SearchStatus::no_path && task.driver.body.reach() > 0.5 &&
            searchers.crossing.has_steps(task.map, task.driver.start, task.driver.goal, options);
        if (!out_of_time && !squeezes_through) return opening_of(task, std::move(removed), found, watch.seconds());
        limited = out_of_time;
    }
    const SearchResult found =
        searchers.cells.find(OpenedMap(task.map, removed), task.driver.start, task.driver.goal, cell_search(task));
    Opening opening = opening_of(std::move(removed), found, watch.seconds());
    opening.limited = opening.limited || limited;
    return opening;
}

Candidate candidate_of(const Task& task, Opening opening) {
    const Stopwatch watch;
    const std::vector<Point> nowhere{task.driver.start};
    const ScheduleTask asked{.ground_path = opening.ground.path.empty() ? nowhere : opening.ground.path,
                             .driver = task.driver,
                             .flyer = task.flyer,
                             .rules = task.rules,
                             .removed = opening.removed,
                             .time_limit = task.deadline.left()};
    Schedule schedule =
        task.method.flight == FlightRule::optimal
            ? best_schedule(task.map, asked)
            : schedule_of(task.map, asked, fly_nearest(task.map, task.flyer.start, task.flyer.goal, asked.removed));
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

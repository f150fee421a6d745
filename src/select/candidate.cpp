#include "select/candidate.hpp"

#include <algorithm>
#include <cmath>

#include "core/stopwatch.hpp"
#include "drive/shortened.hpp"
#include "map/line_of_sight.hpp"
#include "model/opened.hpp"
#include "model/timeline.hpp"
#include "schedule/earliest_openings.hpp"
#include "schedule/own_schedule.hpp"

namespace waybreaker {
namespace {

JointSchedule scheduled(const Task& task, const Opening& opening) {
    const std::vector<Point> nowhere{task.driver.start};
    if (task.opens_own_way()) {
        return own_schedule(task.map, task.driver, task.rules,
                            opening.ground.path.empty() ? nowhere : opening.ground.path, opening.removed);
    }
    const JointTask asked{.ground_path = opening.ground.path.empty() ? nowhere : opening.ground.path,
                          .driver = task.driver,
                          .aircraft = task.aircraft,
                          .rules = task.rules,
                          .removed = opening.removed,
                          .time_limit = task.deadline.left()};
    const bool nearest =
        task.method.flight == FlightRule::nearest && task.aircraft.size() == 1 && !task.aircraft.front()->recharge;
    return nearest ? nearest_schedule(task.map, asked) : best_joint_schedule(task.map, asked);
}

// Lets stand again what the ground path does without, but for what must be removed. Whether it let any.
bool keep_needed(const Task& task, const JointSchedule& schedule, Opening& opening) {
    if (task.opens_own_way()) {
        // It breaches what it touches, and nothing else.
        const auto stays = [&](ObstacleId id) {
            return std::ranges::find(schedule.breaches, id, &TimedBreach::obstacle) == schedule.breaches.end() &&
                   std::ranges::find(task.given, id) == task.given.end();
        };
        return std::erase_if(opening.removed, stays) > 0;
    }
    // The shortest path of a point needs all that it crosses.
    if (drives_by_crossing(task) && task.driver.body.is_point()) return false;
    const std::size_t before = opening.removed.size();
    for (std::size_t i = before; i-- > 0;) {
        if (std::ranges::find(task.given, opening.removed[i]) != task.given.end()) continue;
        // Where the aircraft may not breach all of them, nothing is breached.
        const auto breach = std::ranges::find(schedule.breaches, opening.removed[i], &TimedBreach::obstacle);
        if (breach != schedule.breaches.end() && breach->entered_at) continue;
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

bool drives_by_crossing(const Task& task) {
    return task.planner() == Algorithm::optimal;
}

Candidate candidate_of(const Task& task, Opening opening) {
    const Stopwatch watch;
    JointSchedule schedule = scheduled(task, opening);
    if (task.rules.timing == Timing::enforce && opening.ground.length && keep_needed(task, schedule, opening)) {
        schedule = scheduled(task, opening);
    }
    if (std::isinf(schedule.home.last)) {
        // The aircraft do not get past all of these and home. That may be for want of better flights.
        const bool must = opening.removed.size() == task.given.size();
        const bool none =
            std::isinf(EarliestOpenings(task.map, task.rules, task.aircraft).of(opening.removed).home.last);
        opening.status = must && none ? SearchStatus::no_path : SearchStatus::not_found;
        opening.ground = Route{};
        schedule.breaches.clear();
    }
    return {std::move(opening), std::move(schedule), watch.seconds()};
}

Candidate candidate_of_needed(const Task& task, const Searchers& searchers, Opening opening) {
    const std::size_t asked = opening.removed.size();
    Candidate candidate = candidate_of(task, std::move(opening));
    const std::vector<ObstacleId> needed = candidate.opening.removed;
    if (needed.size() == asked) return candidate;
    return candidate_of_needed(task, searchers, open(task.trip(), searchers, needed));
}

Candidate around_late_openings(const Task& task, const Searchers& searchers, Candidate through) {
    if (task.rules.opened.empty() || task.rules.timing == Timing::ignore) return through;
    const std::vector<ObstacleId> removed = through.opening.removed;
    std::vector<ObstacleId> open_ones = removed;
    std::vector<Point> path = through.opening.ground.path;
    while (!path.empty() && !task.deadline.passed()) {
        const auto late = most_waited_for(task.map, task.driver, path, task.rules.opened);
        // A path may graze what stands already.
        if (!late || std::erase(open_ones, *late) == 0) break;
        Opening around = open(task.trip(), searchers, open_ones);
        path = around.ground.path;
        around.removed = removed;
        Candidate other = candidate_of(task, std::move(around));
        if (cost(task, other) < cost(task, through) * (1 - rounding)) through = std::move(other);
    }
    return through;
}

double cost(const Task& task, const Candidate& candidate) {
    if (!candidate.opening.ground.length) return infinity;
    return task.objective(candidate.schedule.arrival(), candidate.schedule.home);
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

#include "select/timed_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/stopwatch.hpp"
#include "drive/punctual.hpp"
#include "drive/shortened.hpp"
#include "plan/timeline.hpp"

namespace waybreaker {
namespace {

constexpr int most_rounds = 8;

CrossingOptions options_for(const Task& task) {
    CrossingOptions options;
    options.body = task.driver.body;
    options.limits = limits_of(task, task.deadline.left());
    return options;
}

// The best path for the breaches of a schedule; says of the known candidate if a limit ended the search for it.
std::optional<Opening> other_path(const Task& task, const Searchers& searchers, Candidate& known) {
    const Stopwatch watch;
    const JointSchedule& schedule = known.schedule;
    CrossingOptions options = options_for(task);
    options.crossings = int(known.opening.removed.size());
    options.only = known.opening.removed;
    options.length_limit = task.cells_until(schedule.arrival()) * (1 - rounding);
    options.opened_after = [&](std::span<const ObstacleId> obstacles) {
        double last = 0;
        for (const TimedBreach& breach : schedule.breaches) {
            const bool is_one_of_them = std::ranges::find(obstacles, breach.obstacle) != obstacles.end();
            if (is_one_of_them) last = std::max(last, breach.cleared_at);
        }
        return task.cells_until(last);
    };
    const CrossingResult found = searchers.crossing.find(task.map, task.driver.start, task.driver.goal, options);
    known.opening.limited = known.opening.limited || found.status == SearchStatus::limit_reached;
    if (found.best.path.empty()) return std::nullopt;
    Opening opening = drivable(task.trip(), searchers, found.best, known.opening.removed);
    known.opening.limited = known.opening.limited || opening.limited;
    if (opening.status != SearchStatus::found) return std::nullopt;
    opening.limited = known.opening.limited;
    opening.ground.expanded += found.expanded;
    opening.ground.generated += found.generated;
    opening.ground.seconds = watch.seconds();
    return opening;
}

// The path of a candidate, bent so that the agent comes when obstacles open.
std::vector<Point> bent_for(const Task& task, const Candidate& candidate) {
    std::vector<TimedOpening> openings;
    for (const TimedBreach& breach : candidate.schedule.breaches) {
        openings.push_back({breach.obstacle, breach.cleared_at});
    }
    std::vector<Cell> path;
    for (const Point p : candidate.opening.ground.path) path.push_back(cell_of(p));
    const OpenedMap opened(task.map, candidate.opening.removed);
    const std::vector<Cell> bent = punctual(opened, task.driver, std::move(path), std::move(openings)).path;
    return {bent.begin(), bent.end()};
}

}  // namespace

bool waits(const Task& task, const Candidate& candidate) {
    if (task.rules.timing == Timing::ignore || !candidate.opening.ground.length) return false;
    const double driven = task.arrival(*candidate.opening.ground.length);
    return candidate.schedule.arrival() > driven * (1 + rounding);
}

bool TimedPaths::is_new(const Opening& opening) {
    Tried tried{opening.removed, opening.ground.path};
    if (std::ranges::find(tried_, tried) != tried_.end()) return false;
    tried_.push_back(std::move(tried));
    return true;
}

Candidate TimedPaths::candidate(const Task& task, const Searchers& searchers, Opening opening, double enough) {
    const bool first = is_new(opening);
    Candidate best = candidate_of(task, std::move(opening));
    if (!first || !drives_by_crossing(task) || task.driver.body.is_point()) return best;
    const auto may_gain = [&] { return waits(task, best) && cost(task, best) > enough && !task.deadline.passed(); };
    for (int round = 0; round < most_rounds && may_gain(); ++round) {
        std::optional<Opening> other = other_path(task, searchers, best);
        if (!other || !is_new(*other)) break;
        Candidate next = candidate_of(task, std::move(*other));
        if (!(cost(task, next) < cost(task, best) * (1 - rounding))) break;
        best = std::move(next);
    }
    // The search moves a square, which touches obstacles before the disc does.
    while (may_gain()) {
        Opening other = best.opening;
        other.ground.path = bent_for(task, best);
        if (!is_new(other)) break;
        other.ground.length = path_length(other.ground.path);
        Candidate next = candidate_of(task, std::move(other));
        if (!(cost(task, next) < cost(task, best) * (1 - rounding))) break;
        best = std::move(next);
    }
    return best;
}

}  // namespace waybreaker

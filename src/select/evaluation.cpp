#include "select/evaluation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/stopwatch.hpp"
#include "drive/punctual.hpp"
#include "drive/shortened.hpp"
#include "model/timeline.hpp"
#include "select/bound.hpp"
#include "select/tuning.hpp"

namespace waybreaker {
namespace {

// So near to a bound, a plan differs from the best by where it waits, at places half a cell apart.
constexpr double near_bound = 1 + 1e-6;

// Whether the ground agent stands somewhere before its goal.
bool waits(const Task& task, const Candidate& candidate) {
    if (task.rules.timing == Timing::ignore || !candidate.opening.ground.length) return false;
    const double driven = task.arrival(cells_driven(task.trip(), candidate.opening));
    return candidate.schedule.arrival() > driven * (1 + rounding);
}

// The path of a candidate, bent so that the agent comes when obstacles open.
std::vector<Point> bent_for(const Task& task, const Candidate& candidate) {
    std::vector<TimedOpening> openings = task.rules.opened;
    for (const TimedBreach& breach : candidate.schedule.breaches) {
        openings.push_back({breach.obstacle, breach.cleared_at});
    }
    std::vector<Cell> path;
    for (const Point p : candidate.opening.ground.path) path.push_back(cell_of(p));
    const OpenedMap opened(task.map, candidate.opening.removed);
    const std::vector<Cell> bent =
        punctual(opened, task.driver, std::move(path), std::move(openings), task.rules.rubble).path;
    return {bent.begin(), bent.end()};
}

// Paths past one set of obstacles whose openings come late.
class PathsInTime {
  public:
    PathsInTime(const Task& task, const Searchers& searchers, OpeningTimes& opening_times,
                std::span<const ObstacleId> removed, const Cutoff& cutoff)
        : task_(task), searchers_(searchers), opening_times_(opening_times), removed_(removed), cutoff_(cutoff) {}

    // The best of a path and of those that come after it, each the best one for the breaches of the schedule before and
    // better than `known`.
    Candidate improved(const Candidate& start, double known = infinity) {
        Candidate last = start;
        for (int round = 0; round < tuning::most_rounds && may_gain(last); ++round) {
            const double arrival = std::min(last.schedule.arrival(), known);
            if (!improve(last, search(options_for(last.schedule, arrival), {}))) break;
        }
        // The search moves a square, which touches obstacles before the disc does.
        Candidate first = bent(start);
        last = bent(std::move(last));
        return cost(task_, first) < cost(task_, last) * (1 - rounding) ? first : last;
    }

    // The path that would be best if the obstacles opened as early as any set allows, and the least objective then. No
    // limit on its length: of equally good paths the same is found whatever the incumbent.
    struct Earliest {
        Opening opening;
        double objective;
    };
    std::optional<Earliest> for_earliest_openings() {
        CrossingOptions options = crossing_options(task_, false, infinity, a_little_more(task_), opening_times_);
        options.only = removed_;
        options.removed = {};
        options.crossings = int(removed_.size());
        options.budget = infinity;
        double cells = 0;
        std::optional<Opening> opening = search(options, opener_of(task_, opening_times_), &cells);
        if (!opening) return std::nullopt;
        return Earliest{*std::move(opening), least_objective(task_, cells, opening_times_)};
    }

    bool may_gain(const Candidate& best) const {
        return waits(task_, best) && cost(task_, best) > cutoff_.enough && !task_.deadline.passed();
    }
    bool limited() const { return limited_; }

  private:
    CrossingOptions options_for(const JointSchedule& schedule, double arrival) const {
        CrossingOptions options;
        options.body = task_.driver.body;
        options.limits = limits_of(task_, task_.deadline.left());
        options.crossings = int(removed_.size());
        options.only = removed_;
        options.length_limit = task_.cells_until(arrival) * (1 - rounding);
        options.opened_after = [&](std::span<const ObstacleId> obstacles) {
            double last = 0;
            for (const TimedBreach& breach : schedule.breaches) {
                const bool is_one_of_them = std::ranges::find(obstacles, breach.obstacle) != obstacles.end();
                // What the path does without is breached whenever it suits the flight: that says nothing yet.
                if (is_one_of_them && breach.entered_at) last = std::max(last, breach.cleared_at + task_.rules.rubble);
            }
            for (const TimedOpening& opening : task_.rules.opened) {
                const bool is_one_of_them = std::ranges::find(obstacles, opening.obstacle) != obstacles.end();
                if (is_one_of_them) last = std::max(last, opening.at + task_.rules.rubble);
            }
            return task_.cells_until(last);
        };
        return options;
    }

    // `least`: of all paths, in cells.
    std::optional<Opening> search(const CrossingOptions& options, const crossing::Opener& opener,
                                  double* least = nullptr) {
        const Stopwatch watch;
        const CrossingResult found = crossing::Access::find(searchers_.crossing, task_.map, task_.driver.start,
                                                            task_.driver.goal, options, opener);
        limited_ = limited_ || found.status == SearchStatus::limit_reached;
        if (found.best.path.empty()) return std::nullopt;
        if (least) *least = found.lower_bound;
        Opening opening = drivable(task_.trip(), searchers_, found.best, {removed_.begin(), removed_.end()});
        limited_ = limited_ || opening.limited;
        if (opening.status != SearchStatus::found) return std::nullopt;
        opening.ground.expanded += found.expanded;
        opening.ground.generated += found.generated;
        opening.ground.seconds = watch.seconds();
        return opening;
    }

    // Whether that path is better, by enough.
    bool improve(Candidate& best, std::optional<Opening> other) {
        if (!other || other->ground.path == best.opening.ground.path) return false;
        Candidate next = candidate_of(task_, std::move(*other));
        if (!(cost(task_, next) < cost(task_, best) * (1 - rounding))) return false;
        best = std::move(next);
        return true;
    }

    Candidate bent(Candidate best) {
        while (may_gain(best)) {
            Opening opening = best.opening;
            opening.ground.path = bent_for(task_, best);
            opening.ground.length = path_length(opening.ground.path);
            if (!improve(best, std::move(opening))) break;
        }
        return best;
    }

    const Task& task_;
    Searchers searchers_;
    OpeningTimes& opening_times_;
    std::span<const ObstacleId> removed_;
    Cutoff cutoff_;
    bool limited_ = false;
};

Candidate evaluated(const Task& task, const Searchers& searchers, OpeningTimes& opening_times,
                    std::vector<ObstacleId> removed, const Cutoff& cutoff, const CrossingResult* found,
                    double seconds) {
    std::ranges::sort(removed);
    const double costliest = costliest_path(task, cutoff.reached, opening_times);
    const bool is_known = found != nullptr && !opening_times.matter();
    Opening shortest = is_known ? open(task.trip(), searchers, removed, *found, seconds, costliest)
                                : open(task.trip(), searchers, removed, costliest);
    const double cells = cells_driven(task.trip(), shortest);
    Candidate start = candidate_of(task, std::move(shortest));
    const bool promises = least_objective(task, cells, opening_times) < cutoff.reached;
    if (!promises || task.opens_own_way() || !drives_by_crossing(task) || task.driver.body.is_point()) return start;
    PathsInTime paths(task, searchers, opening_times, removed, cutoff);
    Candidate best = start;
    const auto take_better = [&](Candidate other) {
        if (cost(task, other) < cost(task, best) * (1 - rounding)) best = std::move(other);
    };
    double known = infinity;
    if (opening_times.matter() && paths.may_gain(best)) {
        if (std::optional<PathsInTime::Earliest> earliest = paths.for_earliest_openings()) {
            // The disc is hardly shorter than the square, and less than a cell later at each obstacle.
            const double sooner = double(removed.size()) / task.driver.speed;
            const double least = earliest->objective * (1 - tuning::most_shortened) - sooner;
            if (square_stands_for(task.driver.body) && least >= cutoff.reached) return best;
            Candidate in_time = paths.improved(candidate_of(task, std::move(earliest->opening)));
            known = in_time.schedule.arrival();
            take_better(std::move(in_time));
        }
    }
    if (paths.may_gain(best)) take_better(paths.improved(start, known));
    best.opening.limited = best.opening.limited || paths.limited();
    return best;
}

}  // namespace

Candidate evaluate(const Task& task, const Searchers& searchers, OpeningTimes& opening_times,
                   std::vector<ObstacleId> removed, const Cutoff& cutoff, const CrossingResult* found, double seconds) {
    Candidate best = evaluated(task, searchers, opening_times, std::move(removed), cutoff, found, seconds);
    return around_late_openings(task, searchers, std::move(best));
}

Evaluation::Evaluation(const Task& task, const Searchers& searchers, OpeningTimes& opening_times,
                       const Candidate& start)
    : task_(task), searchers_(searchers), opening_times_(opening_times), least_(cost(task, start)) {}

double Evaluation::add(std::span<const ObstacleId> others, const CrossingResult* found, double seconds) {
    std::vector<ObstacleId> removed = task_.with_forced(others);
    std::ranges::sort(removed);
    if (const auto known = objectives_.find(removed); known != objectives_.end()) return known->second;
    Candidate candidate =
        evaluate(task_, searchers_, opening_times_, removed, {least_, enough_ * near_bound}, found, seconds);
    double objective = cost(task_, candidate);
    // What stands again leaves another set, which has a path of its own.
    const std::vector<ObstacleId> needed = candidate.opening.removed;
    const bool is_gain = objective < least_ * (1 - rounding);
    if (needed.size() < removed.size() && !candidate.opening.limited) {
        objective = is_gain ? add(needed) : infinity;
    } else {
        candidates_.push_back(std::move(candidate));
        if (is_gain) least_ = objective;
    }
    objectives_[removed] = objective;
    return objective;
}

}  // namespace waybreaker

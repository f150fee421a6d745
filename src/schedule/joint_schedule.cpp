#include "schedule/joint_schedule.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "core/stopwatch.hpp"
#include "schedule/best_tour.hpp"
#include "schedule/course.hpp"
#include "schedule/sorties.hpp"
#include "schedule/timetable.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker {
namespace {

// Shares of the obstacles that are flown at their best, over all aircraft; where there are more, local search.
constexpr std::size_t most_shares = 64;

constexpr double infinity = std::numeric_limits<double>::infinity();

ScheduleTask task_of(const JointTask& task, std::size_t aircraft, const Deadline& deadline) {
    return {.ground_path = task.ground_path,
            .driver = task.driver,
            .flyer = *task.aircraft[aircraft],
            .rules = task.rules,
            .removed = task.removed,
            .time_limit = deadline.left()};
}

// Of one aircraft.
Returns returns_of(const Agent& aircraft, double landed) {
    Finish finish;
    finish.add(aircraft, landed);
    return {finish.air, finish.air};
}

JointSchedule joint(const Map& map, const JointTask& task, Schedule alone) {
    JointSchedule schedule;
    schedule.home = returns_of(*task.aircraft.front(), alone.air.back().t);
    for (std::size_t i = 0; i < alone.flight.breaches.size(); ++i) {
        const auto& [obstacle, at] = alone.flight.breaches[i];
        const double stay = time_to_breach(*task.aircraft.front(), map.obstacle(obstacle), task.rules);
        const double cleared = alone.cleared_at[i];
        schedule.breaches.push_back({obstacle, 0, at, cleared - stay, cleared, alone.entered_at[i]});
    }
    schedule.ground = std::move(alone.ground);
    schedule.air.push_back(std::move(alone.air));
    return schedule;
}

bool recharges(const JointTask& task) {
    return std::ranges::any_of(task.aircraft, [](const Agent* agent) { return agent->recharge.has_value(); });
}

// By aircraft and target.
std::vector<std::vector<double>> stays_of(const Map& map, const JointTask& task, const Needs& needs) {
    std::vector<std::vector<double>> stays;
    for (const Agent* agent : task.aircraft) {
        std::vector<double>& its = stays.emplace_back();
        for (const Target& target : needs.targets)
            its.push_back(time_to_breach(*agent, map.obstacle(target.obstacle), task.rules));
    }
    return stays;
}

// Of several aircraft, or one that recharges.
class SharedOut {
  public:
    SharedOut(const Map& map, const JointTask& task)
        : task_(task),
          deadline_(task.time_limit),
          first_(task_of(task, 0, deadline_)),
          needs_(needs_of(map, first_)),
          stays_(stays_of(map, task, needs_)),
          precedence_(needs_.precedence({task.aircraft.begin(), task.aircraft.end()}, stays_)),
          due_([this] { return deadline_.passed(); }) {}

    JointSchedule best() const {
        const SortieSearch search(task_.aircraft, needs_.targets, precedence_, task_.rules.objective, due_);
        const std::size_t targets = needs_.targets.size();
        const bool few = !recharges(task_) && targets < 16 && (task_.aircraft.size() << targets) <= most_shares;
        Sorties sorties;
        if (few) sorties = best_shares(std::size_t{1} << targets);
        if (sorties.empty()) {
            std::optional<Sorties> found = search.find(in_order_of_need());
            if (!found) return none();
            sorties = std::move(*found);
        } else if (task_.rules.objective == Objective::flowtime) {
            search.improve(sorties);
        }
        return schedule_of(search.with_landings(std::move(sorties)));
    }

  private:
    // The best tour of one aircraft past its share, if it may breach so many.
    struct Share {
        bool possible = false;
        Finish finish = {};
        Tour tour = {};
    };
    // Of the aircraft so far: who breaches what, as sets of bits.
    struct Shares {
        bool possible = false;
        Finish finish = {};
        std::vector<std::uint32_t> of = {};
    };

    // By the objective; the ground agent counts once, when the last aircraft is known.
    Rank rank_of(Finish finish) const {
        finish.flowtime += finish.ground;
        return rank(task_.rules.objective, finish);
    }

    // Empty if time is over before.
    Sorties best_shares(std::size_t subsets) const {
        std::vector<std::vector<Share>> all;
        std::vector<Shares> best(subsets);  // by the subset that is breached
        best[0] = {true, {needs_.unhindered, 0, 0}, {}};
        for (std::size_t a = 0; a < task_.aircraft.size(); ++a) {
            all.push_back(shares_of(a, subsets));
            best = with(best, all.back());
        }
        if (deadline_.passed() || !best.back().possible) return {};
        Sorties sorties;
        for (std::size_t a = 0; a < all.size(); ++a) sorties.push_back(all[a][best.back().of[a]].tour);
        return sorties;
    }

    std::vector<Share> shares_of(std::size_t aircraft, std::size_t subsets) const {
        const ScheduleTask alone = task_of(task_, aircraft, deadline_);
        std::vector<Share> shares(subsets);
        for (std::uint32_t subset = 0; subset < subsets && !deadline_.passed(); ++subset) {
            if (std::popcount(subset) > alone.flyer.breaches || !may_breach(aircraft, subset)) continue;
            const Course course(alone, needs_.only(subset, stays_[aircraft]));
            Tour tour = best_tour(course, deadline_).tour;
            const Finish finish = course.finish(tour);
            shares[subset] = {std::isfinite(finish.air), finish, named(std::move(tour), subset)};
        }
        return shares;
    }

    bool may_breach(std::size_t aircraft, std::uint32_t subset) const {
        for (std::size_t target = 0; target < needs_.targets.size(); ++target) {
            if ((subset >> target & 1U) != 0 && !precedence_.may_breach(aircraft, target)) return false;
        }
        return true;
    }

    // One aircraft more. Of equals, the first one breaches the most.
    std::vector<Shares> with(const std::vector<Shares>& others, const std::vector<Share>& own) const {
        std::vector<Shares> best(others.size());
        for (std::uint32_t all = 0; all < others.size(); ++all) {
            for (std::uint32_t share = 0;; share = (share - all) & all) {
                add(others[all ^ share], own[share], share, best[all]);
                if (share == all) break;
            }
        }
        return best;
    }

    void add(const Shares& others, const Share& own, std::uint32_t share, Shares& best) const {
        if (!others.possible || !own.possible) return;
        const Finish both{std::max(others.finish.ground, own.finish.ground),
                          std::max(others.finish.air, own.finish.air), others.finish.flowtime + own.finish.air};
        if (best.possible && !is_better(rank_of(both), rank_of(best.finish))) return;
        best = {true, both, others.of};
        best.of.push_back(share);
    }

    // With the targets of all in place of those of the subset.
    static Tour named(Tour tour, std::uint32_t subset) {
        std::vector<std::size_t> targets;
        for (std::size_t target = 0; target < 32; ++target) {
            if ((subset >> target & 1U) != 0) targets.push_back(target);
        }
        for (Stop& stop : tour) stop.target = targets[stop.target];
        return tour;
    }

    // They may not breach all of them, however they share them out.
    JointSchedule none() const {
        JointSchedule schedule;
        schedule.ground = needs_.driven;
        schedule.home = {infinity, infinity};
        for (const Agent* agent : task_.aircraft)
            schedule.air.push_back(flown(*agent, Tour(), [](std::size_t) { return 0.0; }));
        return schedule;
    }

    std::vector<std::size_t> in_order_of_need() const {
        std::vector<std::size_t> order(needs_.targets.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [this](std::size_t target) { return needs_.breachings[target].needed_by; });
        return order;
    }

    JointSchedule schedule_of(const Sorties& sorties) const {
        JointSchedule schedule;
        std::vector<double> cleared(needs_.targets.size());
        for (std::size_t a = 0; a < sorties.size(); ++a) {
            const Agent& agent = *task_.aircraft[a];
            const auto stay = [&](std::size_t target) { return stays_[a][target]; };
            schedule.air.push_back(flown(agent, sorties[a], stay));
            const double landed = fly(agent, sorties[a], stay, [&](const Stop& stop, double begun, double gone) {
                cleared[stop.target] = gone;
                schedule.breaches.push_back({needs_.targets[stop.target].obstacle, a, stop.at, begun, gone});
            });
            const Returns home = returns_of(agent, landed);
            schedule.home = {std::max(schedule.home.last, home.last), schedule.home.sum + home.sum};
        }
        TimedDrive driven = drive_in_time(needs_.driven, first_.rules, needs_.breachings, cleared, needs_.given,
                                          1e-9 * (1 + schedule.home.last));
        schedule.ground = std::move(driven.path);
        for (TimedBreach& breach : schedule.breaches) {
            const auto is_it = [&](const Target& target) { return target.obstacle == breach.obstacle; };
            const auto target = std::ranges::find_if(needs_.targets, is_it) - needs_.targets.begin();
            breach.entered_at = driven.entered_at[std::size_t(target)];
        }
        std::ranges::stable_sort(schedule.breaches, {}, &TimedBreach::cleared_at);
        return schedule;
    }

    const JointTask& task_;
    Deadline deadline_;
    ScheduleTask first_;  // as if its first aircraft flew alone
    Needs needs_;
    std::vector<std::vector<double>> stays_;
    Precedence precedence_;
    std::function<bool()> due_;
};

// Past what opens by itself.
JointSchedule driven_alone(const Map& map, const JointTask& task) {
    const ScheduleTask alone{.ground_path = task.ground_path,
                             .driver = task.driver,
                             .flyer = task.driver,  // nobody flies
                             .rules = task.rules,
                             .removed = task.removed};
    const Needs needs = needs_of(map, alone);
    JointSchedule schedule;
    schedule.ground = drive_in_time(needs.driven, alone.rules, {}, {}, needs.given, 1e-9 * (1 + needs.unhindered)).path;
    return schedule;
}

}  // namespace

JointSchedule best_joint_schedule(const Map& map, const JointTask& task) {
    if (task.aircraft.empty()) return driven_alone(map, task);
    if (task.aircraft.size() > 1 || recharges(task)) return SharedOut(map, task).best();
    return joint(map, task, best_schedule(map, task_of(task, 0, Deadline(task.time_limit))));
}

JointSchedule nearest_schedule(const Map& map, const JointTask& task) {
    const Agent& flyer = *task.aircraft.front();
    const ScheduleTask alone = task_of(task, 0, Deadline());
    const std::vector<ObstacleId> targets = to_breach(task.rules, task.removed);
    return joint(map, task,
                 schedule_of(map, alone, fly_nearest(map, flyer.begin(), flyer.goal, targets, flyer.airspace)));
}

}  // namespace waybreaker

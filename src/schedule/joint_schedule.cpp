#include "schedule/joint_schedule.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
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

ScheduleTask task_of(const JointTask& task, std::size_t aircraft, const Deadline& deadline) {
    return {.ground_path = task.ground_path,
            .driver = task.driver,
            .flyer = *task.aircraft[aircraft],
            .rules = task.rules,
            .removed = task.removed,
            .time_limit = deadline.left()};
}

JointSchedule joint(const Map& map, const JointTask& task, Schedule alone) {
    JointSchedule schedule;
    const double home = alone.air.back().t;
    schedule.home = {home, home};
    for (std::size_t i = 0; i < alone.flight.breaches.size(); ++i) {
        const auto& [obstacle, at] = alone.flight.breaches[i];
        const double stay = task.rules.breach_time.of(map.obstacle(obstacle));
        const double cleared = alone.cleared_at[i];
        schedule.breaches.push_back({obstacle, 0, at, cleared - stay, cleared, alone.entered_at[i]});
    }
    schedule.ground = std::move(alone.ground);
    schedule.air.push_back(std::move(alone.air));
    return schedule;
}

class SeveralAircraft {
  public:
    SeveralAircraft(const Map& map, const JointTask& task)
        : task_(task),
          deadline_(task.time_limit),
          first_(task_of(task, 0, deadline_)),
          needs_(needs_of(map, first_)),
          due_([this] { return deadline_.passed(); }) {
        Drive drive{needs_.unhindered};
        std::vector<double> stays;
        for (std::size_t target = 0; target < needs_.targets.size(); ++target) {
            const Breaching& breaching = needs_.breachings[target];
            if (!std::isinf(breaching.needed_by)) drive.passages.push_back({target, breaching.needed_by});
            stays.push_back(breaching.stay);
        }
        precedence_ = Precedence({task.aircraft.begin(), task.aircraft.end()}, std::move(stays));
        precedence_.add_vehicle({std::move(drive)});
    }

    JointSchedule best() const {
        const SortieSearch search(task_.aircraft, needs_.targets, precedence_, task_.rules.objective, due_);
        const std::size_t targets = needs_.targets.size();
        const bool few = targets < 16 && (task_.aircraft.size() << targets) <= most_shares;
        std::optional<Sorties> sorties = few ? best_shares() : search.find(in_order_of_need());
        if (!sorties) sorties = search.find(in_order_of_need());
        if (few && task_.rules.objective == Objective::flowtime) search.improve(*sorties);
        return schedule_of(*sorties);
    }

  private:
    // Who breaches what: by aircraft, a set of bits.
    struct Shares {
        Finish finish;
        std::vector<std::uint32_t> of;
    };

    Rank rank_of(const Finish& finish) const { return rank(task_.rules.objective, finish); }

    // None if time is over before.
    std::optional<Sorties> best_shares() const {
        const std::size_t subsets = std::size_t{1} << needs_.targets.size();
        std::vector<std::vector<Tour>> tours(task_.aircraft.size(), std::vector<Tour>(subsets));
        // Of the aircraft so far, by the subset that they breach.
        std::vector<std::optional<Shares>> best(subsets);
        best[0] = Shares{{needs_.unhindered, 0, 0}, {}};
        for (std::size_t a = 0; a < task_.aircraft.size(); ++a) {
            const ScheduleTask alone = task_of(task_, a, deadline_);
            std::vector<std::optional<Finish>> own(subsets);
            for (std::uint32_t subset = 0; subset < subsets; ++subset) {
                if (std::popcount(subset) > task_.aircraft[a]->breaches) continue;
                if (deadline_.passed()) return std::nullopt;
                const Course course(alone, needs_.only(subset));
                Tour tour = best_tour(course, deadline_).tour;
                own[subset] = course.finish(tour);
                tours[a][subset] = named(std::move(tour), subset);
            }
            std::vector<std::optional<Shares>> more(subsets);
            for (std::uint32_t all = 0; all < subsets; ++all) {
                // Of equals, the first aircraft breaches the most.
                for (std::uint32_t share = 0;; share = (share - all) & all) {
                    if (best[all ^ share] && own[share]) consider(*best[all ^ share], *own[share], share, more[all]);
                    if (share == all) break;
                }
            }
            best = std::move(more);
        }
        if (!best.back()) return std::nullopt;
        Sorties sorties;
        for (std::size_t a = 0; a < tours.size(); ++a) sorties.push_back(tours[a][best.back()->of[a]]);
        return sorties;
    }

    void consider(const Shares& others, const Finish& own, std::uint32_t share, std::optional<Shares>& best) const {
        const Finish both{std::max(others.finish.ground, own.ground), std::max(others.finish.air, own.air),
                          others.finish.flowtime + own.air};
        // The ground agent counts once, when the last aircraft is known.
        const auto counted = [this](Finish finish) {
            finish.flowtime += finish.ground;
            return rank_of(finish);
        };
        if (best && !is_better(counted(both), counted(best->finish))) return;
        best = Shares{both, others.of};
        best->of.push_back(share);
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

    std::vector<std::size_t> in_order_of_need() const {
        std::vector<std::size_t> order(needs_.targets.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [this](std::size_t target) { return needs_.breachings[target].needed_by; });
        return order;
    }

    JointSchedule schedule_of(const Sorties& sorties) const {
        JointSchedule schedule;
        const auto stay = [this](std::size_t target) { return needs_.breachings[target].stay; };
        std::vector<double> cleared(needs_.targets.size());
        for (std::size_t a = 0; a < sorties.size(); ++a) {
            const Agent& agent = *task_.aircraft[a];
            schedule.air.push_back(flown(agent, sorties[a], stay));
            fly(agent, sorties[a], stay, [&](const Stop& stop, double begun, double gone) {
                cleared[stop.target] = gone;
                schedule.breaches.push_back({needs_.targets[stop.target].obstacle, a, stop.at, begun, gone});
            });
            const double home = schedule.air.back().back().t;
            schedule.home = {std::max(schedule.home.last, home), schedule.home.sum + home};
        }
        TimedDrive driven = drive_in_time(first_, needs_.breachings, cleared, 1e-9 * (1 + schedule.home.last));
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
    Precedence precedence_;
    std::function<bool()> due_;
};

}  // namespace

JointSchedule best_joint_schedule(const Map& map, const JointTask& task) {
    if (task.aircraft.size() > 1) return SeveralAircraft(map, task).best();
    return joint(map, task, best_schedule(map, task_of(task, 0, Deadline(task.time_limit))));
}

JointSchedule nearest_schedule(const Map& map, const JointTask& task) {
    const Agent& flyer = *task.aircraft.front();
    const ScheduleTask alone = task_of(task, 0, Deadline());
    return joint(map, task, schedule_of(map, alone, fly_nearest(map, flyer.start, flyer.goal, task.removed)));
}

}  // namespace waybreaker

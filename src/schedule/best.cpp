// The best flight for a ground path.
//
// Two numbers tell how good a flight is: when the ground agent finishes and when the air agent does. For the ground
// agent to finish by a time g every obstacle has a deadline, and the shortest flight that meets them (flight/exact.hpp)
// gives the earliest end of the air agent: f(g), a staircase that falls as g grows. Stretches of it are dropped when
// their lower corner is no better than the best flight known, else halved by asking for f in the middle.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "flight/local_search.hpp"
#include "flight/long_tour.hpp"
#include "schedule/best_tour.hpp"
#include "schedule/course.hpp"
#include "schedule/local_search.hpp"
#include "schedule/rank.hpp"
#include "schedule/timetable.hpp"

namespace waybreaker {
namespace {

class Best {
  public:
    // `shortest`: the flight with the earliest end of all, or a good one.
    Best(const Course& course, const Tour& shortest, const Deadline& deadline)
        : course_(course),
          deadline_(deadline),
          rounding_(1e-9 * (1 + course.finish(shortest).flowtime)),
          shortest_(course.finish(shortest)),
          tour_(shortest),
          rank_(rank_of(shortest_)) {
        if (shortest_.ground <= course_.unhindered() + rounding_) return;  // both agents finish as early as they can
        consider(improved_tour(course_, shortest, rounding_, deadline_));
        if (rank_.first <= rank_of(finish_of_two(course_.unhindered(), shortest_.air)).first + rounding_) return;
        consider(improved_tour(course_, in_order_of_entry(shortest), rounding_, deadline_));
    }

    // Looks at all flights. False if the deadline comes first. Precondition: `shortest` is the shortest.
    bool prove() {
        // Flights whose ground agent finishes after ground_low, before ground_high, and their air agent not before
        // air_low. Where local search has found the best already, a look just below ground_high ends it; else halving.
        struct Stretch {
            double ground_low;
            double ground_high;
            double air_low;
            bool halve;
        };
        const double first = course_.unhindered();
        if (promises(finish_of_two(first, shortest_.air))) fastest(first, first);
        std::vector<Stretch> open{{first, shortest_.ground, shortest_.air, false}};
        while (!open.empty()) {
            const Stretch stretch = open.back();
            open.pop_back();
            if (deadline_.passed()) return false;
            if (stretch.ground_high - stretch.ground_low <= 4 * rounding_) continue;
            if (!promises(finish_of_two(stretch.ground_low + 2 * rounding_, stretch.air_low))) continue;
            const bool sum = objective() == Objective::flowtime;
            const double last_useful = rank_.first - (sum ? stretch.air_low : 0);
            const double top = std::min(stretch.ground_high - 2 * rounding_, last_useful);
            const double split = stretch.halve ? (stretch.ground_low + top) / 2 : top;
            if (split < top) open.push_back({split, stretch.ground_high, stretch.air_low, false});
            if (const std::optional<Finish> found = fastest(split, stretch.ground_low)) {
                open.push_back({stretch.ground_low, found->ground, found->air, !stretch.halve});
            }
        }
        return true;
    }

    const Tour& tour() const { return tour_; }

    void consider(const Tour& tour) {
        const Finish finish = course_.finish(tour);
        if (!promises(finish)) return;
        tour_ = tour;
        rank_ = rank_of(finish);
    }

  private:
    Objective objective() const { return course_.task().rules.objective; }
    Rank rank_of(const Finish& finish) const { return rank(objective(), finish); }
    bool promises(const Finish& finish) const { return better(rank_of(finish), rank_, rounding_); }

    // The earliest end of the air agent with which the ground agent finishes by `ground`; none if it is too late for
    // the best, the ground agent not finishing before `ground_low`.
    std::optional<Finish> fastest(double ground, double ground_low) {
        double air = latest_air_finish(objective(), rank_.first, ground_low);
        const bool tie = objective() != Objective::flowtime && rank_.first <= ground_low + rounding_;
        if (tie) air = rank_.second - ground_low;
        const std::optional<Tour> tour =
            shortest_tour_in_time(course_.start(), course_.goal(), course_.targets(),
                                  course_.deadlines(ground + rounding_), course_.reach(air + rounding_), course_.air());
        if (!tour) return std::nullopt;
        const Finish finish = course_.finish(*tour);
        if (std::isinf(finish.air)) return std::nullopt;
        consider(*tour);
        return finish;
    }

    Tour in_order_of_entry(Tour tour) const {
        std::ranges::stable_sort(tour, {},
                                 [this](const Stop& stop) { return course_.breaching(stop.target).needed_by; });
        return tour;
    }

    const Course& course_;
    const Deadline& deadline_;
    double rounding_;  // in time
    Finish shortest_;
    Tour tour_;
    Rank rank_;
};

}  // namespace

BestTour best_tour(const Course& course, const Deadline& deadline) {
    const Point start = course.start();
    const Cell goal = course.goal();
    const bool few = course.targets().size() <= exact_flight_limit;
    const Tour nearest = nearest_tour(start, goal, course.targets());
    const Tour known = improved_tour(start, nearest, goal, course.targets(), course.air());
    const Tour shortest = few ? shortest_tour(start, goal, course.targets(), known, course.air())
                              : good_tour(start, goal, course.targets(), nearest, course.air(), deadline);
    if (std::isinf(course.finish(shortest).air)) return {shortest, few};  // all others are too long as well
    Best best(course, shortest, deadline);
    if (!few) best.consider(nearest);
    const bool proven = few && best.prove();
    return {best.tour(), proven};
}

Schedule best_schedule(const Map& map, const ScheduleTask& task) {
    validate(task);
    const Deadline deadline(task.time_limit);
    const Course course(task, needs_of(map, task));
    const auto [tour, proven] = best_tour(course, deadline);
    std::vector<Breaching> breachings;
    for (const Stop& stop : tour) breachings.push_back(course.breaching(stop.target));
    Schedule schedule =
        timetable(task, course.driven(), flight_of(course.start(), tour, course.goal(), course.targets(), course.air()),
                  breachings, course.given());
    schedule.optimal = proven;
    return schedule;
}

}  // namespace waybreaker

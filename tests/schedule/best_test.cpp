// The best schedule against all orders and all boundary cells, and its laws.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ascii_map.hpp"
#include "model/timeline.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/schedule.hpp"
#include "world.hpp"

namespace waybreaker {
namespace {

// Every order and every boundary cell.
class BruteForce {
  public:
    explicit BruteForce(const World& world) : map_(world.map), task_(world.task()) {
        const std::vector<Waypoint> driven = timed(task_.ground_path, task_.driver.speed);
        unhindered_ = driven.back().t;
        for (const ObstacleId id : task_.removed) {
            cells_.push_back(map_.boundary(id));
            entries_.push_back(first_touch(map_, id, driven, task_.driver.body.reach()));
            stays_.push_back(task_.rules.breach_time.of(map_.obstacle(id)));
        }
        visited_.assign(cells_.size(), false);
        go(task_.flyer.start, 0, unhindered_);
    }
    Pair best() const { return best_; }

  private:
    void go(Cell at, double t, double ground) {
        if (std::ranges::count(visited_, false) == 0) {
            const double air = t + distance(at, task_.flyer.goal) / task_.flyer.speed;
            const Pair found = rank(task_.rules.objective, ground, air);
            if (found.first < best_.first - 1e-9) best_ = found;
            if (found.first < best_.first + 1e-9) best_.second = std::min(best_.second, found.second);
        }
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (visited_[i]) continue;
            visited_[i] = true;
            for (const Cell c : cells_[i]) {
                const double cleared = t + distance(at, c) / task_.flyer.speed + stays_[i];
                const double wait = entries_[i] ? std::max(cleared - *entries_[i], 0.0) : 0;
                go(c, cleared, std::max(ground, unhindered_ + wait));
            }
            visited_[i] = false;
        }
    }

    const Map& map_;
    ScheduleTask task_;
    double unhindered_ = 0;
    std::vector<std::vector<Cell>> cells_;
    std::vector<std::optional<double>> entries_;
    std::vector<double> stays_;
    std::vector<bool> visited_;
    Pair best_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

// What any schedule promises: the path at its speed with waits at its turns, the flight with stays, nothing touched
// before it is cleared.
void expect_consistent(const World& world, const Schedule& schedule) {
    const ScheduleTask task = world.task();
    constexpr double hair = 1e-6;
    std::vector<Point> turns;
    for (std::size_t i = 0; i < schedule.ground.size(); ++i) {
        const Waypoint& b = schedule.ground[i];
        if (i == 0) {
            RC_ASSERT(b.t == 0);
        } else {
            const Waypoint& a = schedule.ground[i - 1];
            const double way = std::hypot(b.x - a.x, b.y - a.y);
            const bool at_speed = std::abs((b.t - a.t) * task.driver.speed - way) < hair;
            RC_ASSERT((way == 0 && b.t >= a.t) || at_speed);
        }
        const Point at{b.x, b.y};
        if (turns.size() < world.street.size() && at == world.street[turns.size()]) turns.push_back(at);
    }
    RC_ASSERT(turns == world.street);

    RC_ASSERT(schedule.flight.breaches.size() == world.removed.size());
    std::set<ObstacleId> breached;
    double flown = 0;
    double t = 0;
    Cell at = task.flyer.start;
    for (std::size_t i = 0; i < schedule.flight.breaches.size(); ++i) {
        const BreachPoint& breach = schedule.flight.breaches[i];
        breached.insert(breach.obstacle);
        const std::vector<Cell> boundary = world.map.boundary(breach.obstacle);
        RC_ASSERT(std::ranges::count(boundary, breach.at) == 1);
        flown += distance(at, breach.at);
        t +=
            distance(at, breach.at) / task.flyer.speed + task.rules.breach_time.of(world.map.obstacle(breach.obstacle));
        RC_ASSERT(std::abs(schedule.cleared_at[i] - t) < hair);
        const auto entered =
            first_touch(world.map, breach.obstacle, schedule.ground, std::max(task.driver.body.reach() - 1e-9, 0.0));
        if (entered) RC_ASSERT(*entered > t - hair);
        if (entered && task.driver.body.reach() > 0) RC_ASSERT(std::abs(*schedule.entered_at[i] - *entered) < 1e-4);
        at = breach.at;
    }
    RC_ASSERT(breached.size() == world.removed.size());
    flown += distance(at, task.flyer.goal);
    t += distance(at, task.flyer.goal) / task.flyer.speed;
    RC_ASSERT(std::abs(schedule.flight.length - flown) < hair);
    RC_ASSERT(std::abs(schedule.air.back().t - t) < hair);
    RC_ASSERT(schedule.makespan == std::max(schedule.air.back().t, schedule.ground.back().t));
    RC_ASSERT(schedule.flowtime == schedule.air.back().t + schedule.ground.back().t);
}

void show(const World& world, const Schedule& schedule) {
    RC_LOG() << plain(world.map) << "air " << world.flyer.start.x << ',' << world.flyer.start.y << " to "
             << world.flyer.goal.x << ',' << world.flyer.goal.y;
    RC_LOG() << "\nground";
    for (const Waypoint& p : schedule.ground) RC_LOG() << "  " << p.x << ',' << p.y << " at " << p.t;
    RC_LOG() << "\nair";
    for (const Waypoint& p : schedule.air) RC_LOG() << "  " << p.x << ',' << p.y << " at " << p.t;
    RC_LOG() << '\n';
}

void expect_best(const World& world) {
    const Schedule schedule = best_schedule(world.map, world.task());
    show(world, schedule);
    RC_ASSERT(schedule.optimal);
    expect_consistent(world, schedule);
    const Pair expected = BruteForce(world).best();
    const Pair found = rank(world.rules.objective, schedule);
    RC_LOG() << "found " << found.first << ' ' << found.second << ", best " << expected.first << ' ' << expected.second;
    RC_ASSERT(std::abs(found.first - expected.first) < 1e-6);
    RC_ASSERT(std::abs(found.second - expected.second) < 1e-6);
}

RC_GTEST_PROP(BestSchedule, IsTheBestForUpToThreeObstacles, ()) {
    expect_best(any_world(*number(4, 16), *number(2, 12), *number(0, 3), 5));
}
RC_GTEST_PROP(BestSchedule, IsTheBestForFourObstacles, ()) {
    expect_best(any_world(10, 6, 4, 2));
}
// In a single row a cell has two neighbours at most, so that brute force can try every order of many.
RC_GTEST_PROP(BestSchedule, IsTheBestForMoreTinyObstacles, ()) {
    expect_best(any_world(11, 1, *number(5, 7), 1));
}

double objective(const World& world) {
    const Schedule schedule = best_schedule(world.map, world.task());
    return rank(world.rules.objective, schedule).first;
}

World any_large_world() {
    return any_world(60, 60, *number(1, 8), 15);
}

RC_GTEST_PROP(BestSchedule, IsNeverEarlierWithASlowerAirAgent, ()) {
    World world = any_large_world();
    const double before = objective(world);
    world.flyer.speed *= *rc::gen::element(0.3, 0.9);
    RC_ASSERT(objective(world) >= before - 1e-6);
}

RC_GTEST_PROP(BestSchedule, IsNeverEarlierWithLongerBreaches, ()) {
    World world = any_large_world();
    const double before = objective(world);
    world.rules.breach_time.per_obstacle += *rc::gen::element(0.0, 2.0);
    world.rules.breach_time.per_cell += 0.3;
    RC_ASSERT(objective(world) >= before - 1e-6);
}

RC_GTEST_PROP(BestSchedule, IsNeverEarlierWithOneObstacleMore, ()) {
    World world = any_large_world();
    const double all = objective(world);
    if (!world.removed.empty()) world.removed.pop_back();
    RC_ASSERT(objective(world) <= all + 1e-6);
}

// No flight rule of the air agent alone is better, for few obstacles and for many.
RC_GTEST_PROP(BestSchedule, IsNoWorseThanFlightsMadeWithoutASchedule, ()) {
    const World world = any_world(60, 60, *number(1, 14), 12);
    const ScheduleTask task = world.task();
    const Schedule best = best_schedule(world.map, task);
    RC_ASSERT(best.optimal == (world.removed.size() <= exact_flight_limit));
    expect_consistent(world, best);
    for (const auto fly : {fly_nearest, fly_optimal}) {
        const Flight flight = fly(world.map, task.flyer.start, task.flyer.goal, task.removed, task.flyer.airspace);
        const Schedule other = schedule_of(world.map, task, flight);
        expect_consistent(world, other);
        if (task.rules.objective == Objective::makespan) RC_ASSERT(best.makespan <= other.makespan + 1e-6);
        if (task.rules.objective == Objective::flowtime) RC_ASSERT(best.flowtime <= other.flowtime + 1e-6);
        if (task.rules.objective == Objective::ground_makespan)
            RC_ASSERT(best.ground.back().t <= other.ground.back().t + 1e-6);
    }
}

TEST(BestSchedule, FliesAheadOfTheGroundAgent) {
    const Map map = map_from_ascii(R"(
        ....a....b....c....
        ....a....b....c....
        ....a....b....c....)");
    const std::vector<Point> street{{0, 1}, {18, 1}};
    const std::vector<ObstacleId> all{{1}, {2}, {3}};
    const Mission mission = ground_and_air({0, 1}, {18, 1});
    const Schedule schedule = best_schedule(map, {street, mission.agents[0], mission.agents[1], mission.rules, all});
    EXPECT_EQ(schedule.flight.breaches, (std::vector<BreachPoint>{{{1}, {3, 1}}, {{2}, {8, 1}}, {{3}, {13, 1}}}));
    EXPECT_DOUBLE_EQ(schedule.makespan, 18);
    EXPECT_EQ(schedule.ground.size(), 2U) << "no wait";
    EXPECT_TRUE(schedule.optimal);
}

// The shortest flight takes the near wall first, but the ground agent wants the other one open sooner.
TEST(BestSchedule, OpensFirstWhatIsNeededFirst) {
    const Map map = map_from_ascii(R"(
        a...........b
        a...........b
        a...........b)");
    const std::vector<Point> street{{9, 1}, {12, 1}, {0, 1}};
    const std::vector<ObstacleId> both{{1}, {2}};
    const Mission mission = ground_and_air({4, 1}, {6, 1});
    EXPECT_EQ(fly_optimal(map, {4, 1}, {6, 1}, both).breaches.front().obstacle, ObstacleId{1});
    const Schedule schedule = best_schedule(map, {street, mission.agents[0], mission.agents[1], mission.rules, both});
    EXPECT_EQ(schedule.flight.breaches.front().obstacle, ObstacleId{2});
    EXPECT_DOUBLE_EQ(schedule.makespan, 7 + 10 + 5);
}

}  // namespace
}  // namespace waybreaker

// The waits that a flight makes necessary.
#include <gtest/gtest.h>

#include <cmath>

#include "ascii_map.hpp"
#include "waybreaker/advanced/schedule.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

const Map& two_walls() {
    static const Map map = map_from_ascii(R"(
        ...a...b..
        ...a...b..)");
    return map;
}

const std::vector<Point> street{{0, 1}, {5, 1}, {9, 1}};
const std::vector<ObstacleId> both{{1}, {2}};

ScheduleTask task(const Mission& mission, std::span<const Point> path = street) {
    return {.ground_path = path,
            .driver = mission.agents[0],
            .flyer = mission.agents[1],
            .rules = mission.rules,
            .removed = both};
}

const Mission mission = ground_and_air({0, 0}, {9, 0});

const Flight in_order{{{{1}, {2, 0}}, {{2}, {6, 0}}}, 9};

TEST(Waits, AreNotNeededWhenTheAirAgentIsAhead) {
    const Schedule schedule = schedule_of(two_walls(), task(mission), in_order);
    EXPECT_EQ(schedule.ground, (std::vector<Waypoint>{{0, 1, 0}, {5, 1, 5}, {9, 1, 9}}));
    EXPECT_EQ(schedule.air, (std::vector<Waypoint>{{0, 0, 0}, {2, 0, 2}, {6, 0, 6}, {9, 0, 9}}));
    EXPECT_EQ(schedule.cleared_at, (std::vector<double>{2, 6}));
    EXPECT_EQ(schedule.entered_at, (std::vector<std::optional<double>>{2, 6}));
    EXPECT_EQ(schedule.makespan, 9);
    EXPECT_EQ(schedule.flowtime, 18);
}

TEST(Waits, NeedSpeedsAndTimesInRange) {
    for (const double speed : {0.0, 1e-320, 1e7, std::nan("")}) {
        Mission wrong = mission;
        wrong.agents[0].speed = speed;
        EXPECT_THROW(schedule_of(two_walls(), task(wrong), in_order), InputError) << speed;
        wrong = mission;
        wrong.agents[1].speed = speed;
        EXPECT_THROW(best_schedule(two_walls(), task(wrong)), InputError) << speed;
    }
    Mission wrong = mission;
    wrong.rules.breach_time.per_cell = 1e10;
    EXPECT_THROW(best_schedule(two_walls(), task(wrong)), InputError);
    for (const double ready_at : {-1.0, 1e10, std::nan("")}) {
        wrong = mission;
        wrong.agents[0].ready_at = ready_at;
        EXPECT_THROW(best_schedule(two_walls(), task(wrong)), InputError) << ready_at;
    }
}

TEST(Waits, NeedAPath) {
    const std::vector<Point> nowhere;
    EXPECT_THROW(best_schedule(two_walls(), task(mission, nowhere)), InputError);
    EXPECT_THROW(schedule_of(two_walls(), task(mission, nowhere), in_order), InputError);
}

TEST(Waits, AreAtTheLastTurnBeforeTheObstacle) {
    Mission slow = mission;
    slow.agents[1].speed = 0.5;
    slow.rules.breach_time = {.per_obstacle = 1, .per_cell = 0.25};
    const Schedule schedule = schedule_of(two_walls(), task(slow), in_order);
    EXPECT_EQ(schedule.air,
              (std::vector<Waypoint>{{0, 0, 0}, {2, 0, 4}, {2, 0, 5.5}, {6, 0, 13.5}, {6, 0, 15}, {9, 0, 21}}));
    EXPECT_EQ(schedule.cleared_at, (std::vector<double>{5.5, 15}));
    EXPECT_EQ(schedule.ground, (std::vector<Waypoint>{{0, 1, 0}, {0, 1, 3.5}, {5, 1, 8.5}, {5, 1, 14}, {9, 1, 18}}));
    EXPECT_EQ(schedule.entered_at, (std::vector<std::optional<double>>{5.5, 15}));
    EXPECT_EQ(schedule.makespan, 21);
    EXPECT_EQ(schedule.flowtime, 39);
}

TEST(Waits, ForOneObstacleServeTheNext) {
    const Flight reversed{{{{2}, {6, 0}}, {{1}, {4, 0}}}, 6 + 2 + 5};
    const Schedule schedule = schedule_of(two_walls(), task(mission), reversed);
    EXPECT_EQ(schedule.ground, (std::vector<Waypoint>{{0, 1, 0}, {0, 1, 6}, {5, 1, 11}, {9, 1, 15}}));
    EXPECT_EQ(schedule.cleared_at, (std::vector<double>{6, 8}));
    EXPECT_EQ(schedule.entered_at, (std::vector<std::optional<double>>{12, 8}));
}

TEST(Waits, IgnoreWhatTheGroundAgentNeverTouches) {
    const std::vector<Point> short_street{{0, 1}, {5, 1}};
    Mission first = mission;
    first.rules.breach_time = {.per_obstacle = 3};
    const Schedule schedule = schedule_of(two_walls(), task(first, short_street), in_order);
    EXPECT_EQ(schedule.entered_at, (std::vector<std::optional<double>>{5, std::nullopt}));
    EXPECT_EQ(schedule.ground.back(), (Waypoint{5, 1, 8}));
    EXPECT_EQ(schedule.makespan, 15);
}

TEST(Waits, TakeNoFlightAndNoDrive) {
    const std::vector<Point> place{{4, 1}};
    ScheduleTask still = task(mission, place);
    still.removed = {};
    const Schedule schedule = schedule_of(two_walls(), still, {{}, 9});
    EXPECT_EQ(schedule.ground, (std::vector<Waypoint>{{4, 1, 0}}));
    EXPECT_EQ(schedule.air, (std::vector<Waypoint>{{0, 0, 0}, {9, 0, 9}}));
    EXPECT_EQ(schedule.flowtime, 9);
}

}  // namespace
}  // namespace waybreaker

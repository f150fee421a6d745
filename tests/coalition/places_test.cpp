// Many places: vehicles that do not collide, count for their weight, and may be left where they are. Against every plan
// there is on small maps, and laws.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "coalition/every_plan.hpp"
#include "plain_map.hpp"
#include "random_map.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

struct Places {
    Map map;
    Mission mission;
};

// Vehicles that leave one hospital for places anywhere, some behind walls that nobody may open.
Places any_places(std::mt19937& random) {
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    PlainMap plain{5 + below(4), 3 + below(3), {}};
    plain.obstacles.assign(std::size_t(plain.width) * std::size_t(plain.height), 0);
    const int walls = 2 + below(3);
    for (int wall = 0; wall < walls; ++wall) {
        const bool upright = below(2) == 0;
        Cell c{below(plain.width), below(plain.height)};
        for (int length = 1 + below(4); length > 0 && !plain.blocked(c); --length) {
            plain.obstacles[plain.index(c)] = std::uint32_t(wall) + 1;
            ++(upright ? c.y : c.x);
        }
    }
    std::vector<ObstacleAttributes> attributes(std::size_t(walls) + 1);
    attributes[1].destructible = below(3) > 0;
    Places made{Map::from_labels(plain.width, plain.height, plain.obstacles, attributes), {}};
    Rules& rules = made.mission.rules;
    rules.removals = 1 + below(2);
    rules.objective = std::array{Objective::flowtime, Objective::flowtime, Objective::makespan,
                                 Objective::ground_makespan}[std::size_t(below(4))];
    rules.breach_time.per_obstacle = below(3);
    rules.collisions = false;
    rules.unreached = std::array{4.0, 9.0, 40.0}[std::size_t(below(3))];
    const std::vector<Cell> free = plain.free_cells();
    const auto any_free = [&] { return free[std::size_t(below(int(free.size())))]; };
    const Cell hospital = any_free();
    for (int i = 1 + below(4); i > 0; --i) {
        Agent& agent = made.mission.agents.emplace_back(vehicle(std::to_string(i), hospital, any_free()));
        agent.weight = std::array{0.0, 1.0, 1.0, 2.5, 40.0}[std::size_t(below(5))];
        agent.speed = std::array{1.0, 1.0, 2.0, 0.5}[std::size_t(below(4))];
        agent.ready_at = std::array{0.0, 0.0, 2.5}[std::size_t(below(3))];
    }
    for (int i = 1 + below(2); i > 0; --i) {
        Agent& agent = made.mission.agents.emplace_back(aircraft("air" + std::to_string(i), any_free()));
        agent.weight = std::array{0.0, 0.0, 1.0, 3.0}[std::size_t(below(4))];
        agent.speed = std::array{1.0, 3.0}[std::size_t(below(2))];
    }
    return made;
}

double figure_of(const Mission& mission, const Plan& plan) {
    return value(plan.after, mission.rules.objective).value_or(never);
}

TEST(Places, AgreeWithEverySetOrderAndCell) {
    std::mt19937 random(21);
    int as_good = 0;
    int removing = 0;
    int leaving = 0;
    constexpr int rounds = 600;
    for (int round = 0; round < rounds; ++round) {
        const auto [map, mission] = any_places(random);
        const double best = EveryPlan(map, mission).best();
        const Plan plan = Planner().plan(map, mission);
        EXPECT_TRUE(is_valid(map, mission, plan)) << round;
        ASSERT_EQ(plan.status, PlanStatus::solved) << round;
        EXPECT_LE(*plan.bound, best + 1e-6) << round;
        EXPECT_GE(figure_of(mission, plan), best - 1e-6) << round;
        as_good += figure_of(mission, plan) <= best + 1e-6 ? 1 : 0;
        removing += plan.breaches.empty() ? 0 : 1;
        leaving += std::ranges::count(plan.agents, false, &Itinerary::reached) > 0 ? 1 : 0;
    }
    EXPECT_GT(removing, rounds / 10);
    EXPECT_GT(leaving, rounds / 10);
    EXPECT_GE(as_good, rounds * 99 / 100);
}

// Who must arrive, and cannot, leaves no plan; who may be left leaves one, and counts so much.
TEST(Places, LeaveWhoCannotBeReached) {
    const char* const picture = R"(
        S..b.
        ...b.
        ...bG)";
    const Map map = map_from_ascii(picture);
    Mission mission;
    mission.rules = {.removals = 0, .objective = Objective::flowtime, .collisions = false};
    const Cell start = mark_in_ascii(picture, 'S');
    mission.agents = {vehicle("near", start, {2, 0}), vehicle("far", start, mark_in_ascii(picture, 'G')),
                      aircraft("air", start)};
    mission.agents[1].weight = 3;
    mission.agents[2].weight = 0;
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
    mission.rules.unreached = 50;
    const Plan left = Planner().plan(map, mission);
    ASSERT_EQ(left.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, left));
    EXPECT_TRUE(left.agents[0].reached);
    EXPECT_FALSE(left.agents[1].reached);
    EXPECT_EQ(left.agents[1].path, (std::vector<Waypoint>{{0, 0, 0}, {0, 0, 50}}));
    EXPECT_DOUBLE_EQ(*left.after.flowtime, 2 + 3 * 50);
    EXPECT_DOUBLE_EQ(*left.bound, 2 + 3 * 50);
    mission.rules.removals = 1;
    const Plan opened = Planner().plan(map, mission);
    EXPECT_TRUE(opened.agents[1].reached);
    EXPECT_EQ(opened.breaches.size(), 1U);
    EXPECT_NEAR(*opened.after.flowtime, 2 + 3 * std::hypot(4, 2), 1e-9);
}

TEST(Places, HaveNoFiguresWhereALimitCameFirst) {
    const Map map = map_from_ascii(R"(
        ..b..
        ..b..
        .....)");
    Mission mission{{vehicle("near", {0, 0}, {0, 0}), vehicle("far", {0, 0}, {4, 0}), vehicle("last", {0, 0}, {3, 0})}};
    mission.rules.collisions = false;
    mission.rules.unreached = 40;
    Limits limits;
    limits.expansions = 1;
    const Plan plan = Planner().plan(map, mission, {}, limits);
    EXPECT_EQ(plan.status, PlanStatus::limit_reached);
    EXPECT_TRUE(plan.limit_reached);
    EXPECT_FALSE(plan.before.makespan);
    EXPECT_FALSE(plan.bound);
}

// The opening goes to those who count for more, though the others are more.
TEST(Places, OpenForTheWeight) {
    const char* const picture = R"(
        aaa.bbb
        a.a.b.b
        aaaSbbb
        a.a.b.b
        aaa.bbb)";
    const Map map = map_from_ascii(picture);
    Mission mission;
    mission.rules = {.removals = 1, .objective = Objective::flowtime, .collisions = false, .unreached = 100};
    const Cell start = mark_in_ascii(picture, 'S');
    mission.agents = {vehicle("1", start, {1, 1}), vehicle("2", start, {1, 3}), vehicle("3", start, {5, 1}),
                      aircraft("air", start)};
    mission.agents[2].weight = 3;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches.front().obstacle, map.obstacle_at({4, 0}));
    EXPECT_FALSE(plan.agents[0].reached);
    EXPECT_TRUE(plan.agents[2].reached);
}

// Weights that are all twice as large make everything twice as large, and change nothing else.
TEST(Places, KeepTheirChoiceUnderAnotherScale) {
    std::mt19937 random(22);
    for (int round = 0; round < 100; ++round) {
        const auto [map, mission] = any_places(random);
        Mission twice = mission;
        for (Agent& agent : twice.agents) agent.weight *= 2;
        const Plan plan = Planner().plan(map, mission);
        const Plan other = Planner().plan(map, twice);
        EXPECT_NEAR(*other.after.flowtime, 2 * *plan.after.flowtime, 1e-6 * *plan.after.flowtime) << round;
    }
}

TEST(Places, AreNoBetterForFewerRemovals) {
    std::mt19937 random(23);
    for (int round = 0; round < 100; ++round) {
        auto [map, mission] = any_places(random);
        double least = never;
        for (int removals = 0; removals <= 3; ++removals) {
            mission.rules.removals = removals;
            const double now = figure_of(mission, Planner().plan(map, mission));
            EXPECT_LE(now, least * (1 + 1e-9)) << round << ": " << removals;
            least = now;
        }
    }
}

// Whoever counts for nothing changes no figure.
TEST(Places, PassByWhoCountsForNothing) {
    std::mt19937 random(24);
    for (int round = 0; round < 100; ++round) {
        auto [map, mission] = any_places(random);
        mission.rules.objective = Objective::flowtime;
        const double alone = figure_of(mission, Planner().plan(map, mission));
        const std::vector<Cell> free = plain(map, {}).free_cells();
        Agent idle = vehicle("idle", free[random() % free.size()], free[random() % free.size()]);
        idle.weight = 0;
        mission.agents.insert(mission.agents.begin(), idle);
        EXPECT_NEAR(figure_of(mission, Planner().plan(map, mission)), alone, 1e-9 * (1 + alone)) << round;
    }
}

// Where vehicles pass through each other they are never later.
TEST(Places, AreReachedNoLaterWithoutCollisions) {
    std::mt19937 random(25);
    int solved = 0;
    for (int round = 0; round < 200; ++round) {
        auto [map, mission] = any_places(random);
        mission.rules.unreached.reset();
        mission.rules.collisions = true;
        const std::vector<Cell> free = plain(map, {}).free_cells();
        for (Agent& agent : mission.agents) agent.start = free[random() % free.size()];
        Plan apart;
        try {
            apart = Planner().plan(map, mission);
        } catch (const InputError&) {
            continue;  // no room
        }
        if (apart.status != PlanStatus::solved) continue;
        ++solved;
        mission.rules.collisions = false;
        const Plan plan = Planner().plan(map, mission);
        ASSERT_EQ(plan.status, PlanStatus::solved) << round;
        EXPECT_TRUE(is_valid(map, mission, plan)) << round;
        EXPECT_LE(figure_of(mission, plan), figure_of(mission, apart) * (1 + 1e-9)) << round;
    }
    EXPECT_GT(solved, 50);
}

}  // namespace
}  // namespace waybreaker

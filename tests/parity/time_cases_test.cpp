// Missions for which a better plan was found from outside (reference/time_cases in the shared folder): each ends no
// later than that.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "checked_plan.hpp"
#include "shared_data.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double rounding = 1e-3;  // of the figures here

class TimeCases : public testing::Test {
  protected:
    void SetUp() override {
        if (!shared_folder()) GTEST_SKIP() << no_shared_folder;
    }
    static Map map(const std::string& path) {
        std::ifstream in(path);
        return Map(read_movingai_map(in, path));
    }
    static std::string folder() { return (*shared_folder() / "reference/time_cases/").string(); }
    static double makespan(const Map& map, const Mission& mission, const Method& method = {}) {
        const Plan plan = Planner().plan(map, mission, method);
        EXPECT_EQ(plan_faults(map, mission, plan), "");
        return value(plan.after, mission.rules.objective).value_or(std::numeric_limits<double>::infinity());
    }
};

TEST_F(TimeCases, AnAgentTooWideForWhatAPointSlipsThrough) {
    for (const char* name : {"gate.map", "gate2.map"}) {
        const Map gate = map(folder() + name);
        for (const double radius : {0.6, 1.0, 1.5, 2.0}) {
            Mission mission = ground_and_air({4, 7}, {25, 7});
            mission.agents[0].body.radius = radius;
            mission.rules.removals = 1;
            EXPECT_LE(makespan(gate, mission), 23) << name << ", radius " << radius;
        }
    }
}

TEST_F(TimeCases, OtherPlannersFindAPlanWhereTheOptimalOneDoes) {
    const Map planners = map(folder() + "planners_1219.map");
    Mission mission = ground_and_air({1, 1}, {4, 4});
    mission.rules.removals = 1;
    for (const Algorithm planner : {Algorithm::theta, Algorithm::astar, Algorithm::jps}) {
        EXPECT_LE(makespan(planners, mission, {.planner = planner}), 5);
    }
}

// Cut along a lattice, as maps of sections are: thousands of obstacles.
TEST_F(TimeCases, BreachesThatNobodyWaitsForCostNothing) {
    const Map boston = map((*shared_folder() / "data/cities/Boston_0_512.map").string());
    std::vector<std::uint32_t> squares(boston.grid().cell_count());
    constexpr int side = 8;
    std::size_t cell = 0;
    for (Cell c; c.y < boston.height(); ++c.y) {
        for (c.x = 0; c.x < boston.width(); ++c.x, ++cell) {
            const auto square = std::uint32_t(c.y / side * boston.width() + c.x / side + 1);
            if (boston.grid().blocked(c)) squares[cell] = square;
        }
    }
    const Map sections = Map::from_labels(boston.width(), boston.height(), squares);
    Mission mission = ground_and_air({79, 503}, {264, 13});
    mission.agents[1].speed = 5;
    mission.rules.removals = 2;
    const double instant = makespan(sections, mission);
    mission.rules.breach_time.per_obstacle = 2;
    EXPECT_NEAR(makespan(sections, mission), instant, rounding);
}

TEST_F(TimeCases, TheGroundAgentWaitsWhereTheRestIsShortest) {
    const Map boston = map((*shared_folder() / "data/cities/Boston_0_512.map").string());
    Mission mission = ground_and_air({262, 23}, {30, 457});
    mission.agents[1].speed = 5;
    mission.rules.breach_time.per_obstacle = 50;
    double before = 540.550 + rounding;
    for (const int removals : {1, 3, 5}) {
        mission.rules.removals = removals;
        const double now = makespan(boston, mission);
        EXPECT_LE(now, before) << removals;
        before = now;
    }
    EXPECT_LE(before, 530);
}

TEST_F(TimeCases, MoreRemovalsCostNoMore) {
    const Map mono = map(folder() + "mono_1659.map");
    Mission mission = ground_and_air({9, 9}, {3, 7});
    mission.agents[0].speed = 1.5;
    mission.agents[1] = {"air", AgentKind::air, {6, 0}, {1, 3}, 1.5};
    mission.rules.breach_time.per_obstacle = 1.5;
    for (const int removals : {1, 2, 3}) {
        mission.rules.removals = removals;
        EXPECT_LE(makespan(mono, mission), 11.728 + rounding) << removals;
    }
}

// It comes to the border just when the obstacle opens, and bends there though nothing is in its way.
TEST_F(TimeCases, TheGroundAgentComesJustInTime) {
    Mission mission = ground_and_air({1, 3}, {3, 2});
    mission.agents[1] = {"air", AgentKind::air, {4, 2}, {4, 3}, 1};
    mission.rules.removals = 1;
    EXPECT_LE(makespan(map(folder() + "general_704789.map"), mission), 2.4143);
    mission = ground_and_air({1, 9}, {6, 1});
    mission.agents[1] = {"air", AgentKind::air, {5, 4}, {2, 8}, 1};
    mission.rules.removals = 1;
    mission.rules.breach_time.per_obstacle = 2.5;
    EXPECT_LE(makespan(map(folder() + "general_100061.map"), mission), 11.6056);
}

TEST_F(TimeCases, NothingIsRemovedWhereThatIsBestThoughTimingIsIgnored) {
    const Map ignore = map(folder() + "ignore_2129.map");
    Mission mission = ground_and_air({1, 3}, {3, 0});
    mission.agents[1] = {"air", AgentKind::air, {1, 6}, {3, 4}, 1};
    mission.rules.removals = 1;
    mission.rules.timing = Timing::ignore;
    EXPECT_LE(makespan(ignore, mission), 3.828 + rounding);
}

}  // namespace
}  // namespace waybreaker

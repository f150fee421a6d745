// Paths for ROS, read by a YAML library as a robot's program reads them.
#include "io/plan_ros_path.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "ascii_map.hpp"
#include "input_error.hpp"

namespace waybreaker::io {
namespace {

MapFile floor_map() {
    return {.map = map_from_ascii("..... ..... ....."), .cell_size = 0.5, .origin = std::array{-10.0, 20.0}};
}

// East, a wait of 4 s, then north-east.
Plan plan_with_a_wait() {
    Plan plan;
    plan.status = PlanStatus::solved;
    plan.agents = {{.id = "air", .kind = AgentKind::air, .path = {{0, 2, 0}, {0, 2, 1e-6}, {0, 2, 2147483647}}},
                   {.id = "ground", .path = {{0, 2, 0}, {2, 2, 2}, {2, 2, 6}, {4, 0, 6 + std::sqrt(8.0)}}}};
    return plan;
}

struct Read {
    double x, y, yaw, t;
};

std::vector<Read> poses(const YAML::Node& path) {
    EXPECT_EQ(path["header"]["frame_id"].as<std::string>(), "map");
    std::vector<Read> result;
    for (const YAML::Node& stamped : path["poses"]) {
        EXPECT_EQ(stamped["header"]["frame_id"].as<std::string>(), "map");
        const YAML::Node stamp = stamped["header"]["stamp"];
        EXPECT_LT(stamp["nanosec"].as<int>(), 1000000000);
        const YAML::Node position = stamped["pose"]["position"];
        const YAML::Node turn = stamped["pose"]["orientation"];
        const double z = turn["z"].as<double>();
        const double w = turn["w"].as<double>();
        EXPECT_NEAR(z * z + w * w, 1, 1e-8);
        EXPECT_EQ(position["z"].as<double>() + turn["x"].as<double>() + turn["y"].as<double>(), 0);
        result.push_back({position["x"].as<double>(), position["y"].as<double>(), 2 * std::atan2(z, w),
                          stamp["sec"].as<int>() + stamp["nanosec"].as<int>() * 1e-9});
    }
    return result;
}

void expect_poses(const std::vector<Read>& found, const std::vector<Read>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_NEAR(found[i].x, expected[i].x, 1e-6);
        EXPECT_NEAR(found[i].y, expected[i].y, 1e-6);
        EXPECT_NEAR(found[i].yaw, expected[i].yaw, 1e-8);
        EXPECT_NEAR(found[i].t, expected[i].t, 1e-9);
    }
}

TEST(RosPaths, AreOneDocument) {
    const std::vector<YAML::Node> documents = YAML::LoadAll(plan_ros_path(plan_with_a_wait(), floor_map()));
    ASSERT_EQ(documents.size(), 1U);
    std::vector<std::string> agents;
    for (const auto& entry : documents[0]) agents.push_back(entry.first.as<std::string>());
    EXPECT_EQ(agents, (std::vector<std::string>{"ground", "air"}));
}

TEST(RosPaths, HaveAPoseEveryCell) {
    const double north_east = std::acos(-1) / 4;
    const double length = std::sqrt(8.0);
    const YAML::Node all = YAML::Load(plan_ros_path(plan_with_a_wait(), floor_map()));
    expect_poses(poses(all["ground"]), {{-9.75, 20.25, 0, 0},
                                        {-9.25, 20.25, 0, 1},
                                        {-8.75, 20.25, north_east, 2},
                                        {-8.75, 20.25, north_east, 6},
                                        {-8.75 + 1.0 / 3, 20.25 + 1.0 / 3, north_east, 6 + length / 3},
                                        {-8.75 + 2.0 / 3, 20.25 + 2.0 / 3, north_east, 6 + 2 * length / 3},
                                        {-7.75, 21.25, north_east, 6 + length}});
    // An agent that never moves faces along x; its poses give the times.
    expect_poses(poses(all["air"]), {{-9.75, 20.25, 0, 0}, {-9.75, 20.25, 0, 1e-6}, {-9.75, 20.25, 0, 2147483647}});
}

// An aircraft that breaches where it starts and ends, in no time.
TEST(RosPaths, HaveOnePoseAtOnePlaceAndTime) {
    Plan plan = plan_with_a_wait();
    plan.agents[0].path = {{0, 2, 0}, {0, 2, 0}, {1, 2, 1}, {1, 2, 1 + 1e-12}};
    const YAML::Node all = YAML::Load(plan_ros_path(plan, floor_map()));
    expect_poses(poses(all["air"]), {{-9.75, 20.25, 0, 0}, {-9.25, 20.25, 0, 1}});
}

TEST(RosPaths, HaveAPoseEveryStep) {
    const auto count = [](double step) {
        return poses(YAML::Load(plan_ros_path(plan_with_a_wait(), floor_map(), step))["ground"]).size();
    };
    EXPECT_EQ(count(100), 4U);  // corners alone
    EXPECT_EQ(count(1), 5U);
    EXPECT_EQ(count(0.25), 4U + 1 + 2 + 5);
    EXPECT_EQ(count(0.1), 4U + 9 + 14);
    EXPECT_NE(input_error([&] { count(1e-9); }).find("give a larger step"), std::string::npos);
}

// YAML 1.1, which most of ROS reads, takes 1e-06 for a text and 1 for a whole number.
TEST(RosPaths, WriteRealNumbersAsRealNumbers) {
    MapFile map = floor_map();
    map.origin = std::array{-0.249999, 1e-6 - 0.25};
    const std::string text = plan_ros_path(plan_with_a_wait(), map);
    EXPECT_NE(text.find("{x: 0.000001, y: 0.000001, z: 0.0}"), std::string::npos) << text;
    map.origin = std::array{4999999.75, -0.25 - 1e-8};
    EXPECT_NE(plan_ros_path(plan_with_a_wait(), map).find("{x: 5000000.0, y: 0.0, z: 0.0}"), std::string::npos);
}

TEST(RosPaths, RefuseWhatRosCannotSay) {
    Plan plan = plan_with_a_wait();
    plan.agents[0].path.back().t = 2147483648.0;
    EXPECT_NE(input_error([&] { plan_ros_path(plan, floor_map()); }).find("2^31 s"), std::string::npos);
    plan = plan_with_a_wait();
    plan.agents[0].id = "ground";
    EXPECT_NE(input_error([&] { plan_ros_path(plan, floor_map()); }).find("the same id"), std::string::npos);
    plan.agents[0].id = "yes: \"no\"\n\xff";
    EXPECT_EQ(YAML::Load(plan_ros_path(plan, floor_map())).size(), 2U);
    EXPECT_EQ(YAML::Load(plan_ros_path({}, floor_map())).size(), 0U);
}

// A crate, C, bars the corridor; the robot drives up to it, round a bend, and meets nobody on its way.
class RosParts : public testing::Test {
  protected:
    MapFile map{
        .map = map_from_ascii("....... ....#.. ....#.. ......."), .cell_size = 0.5, .origin = std::array{0.0, 0.0}};
    Mission mission{.agents = {{.id = "ground", .start = {0, 0}, .goal = {6, 2}}, aircraft("air", {0, 3})}};
    Plan plan;

    RosParts() {
        plan.status = PlanStatus::solved;
        plan.breaches = {{.obstacle = map.map.obstacle_at({4, 1}), .at = {4, 3}, .cleared_at = 9}};
        plan.agents = {{.id = "ground", .path = {{0, 0, 0}, {2, 0, 2}, {2, 2, 4}, {2, 2, 9}, {6, 2, 13}}},
                       {.id = "air", .kind = AgentKind::air, .path = {{0, 3, 0}, {4, 3, 4}, {4, 3, 9}, {0, 3, 13}}}};
    }

    YAML::Node parts(const char* agent) { return YAML::Load(plan_ros_parts(plan, map, mission))[agent]; }

    static std::vector<int> openings(const YAML::Node& part) { return part["openings"].as<std::vector<int>>(); }
};

TEST_F(RosParts, EndWhereTheAgentWaits) {
    const YAML::Node ground = parts("ground");
    ASSERT_EQ(ground.size(), 2U);
    EXPECT_TRUE(openings(ground[0]).empty());
    EXPECT_EQ(openings(ground[1]), std::vector<int>{1});
    const auto first = poses(ground[0]);
    EXPECT_EQ(first.size(), 5U);
    EXPECT_EQ(first.back().t, 4);
    const auto second = poses(ground[1]);
    EXPECT_EQ(second.front().t, 9);
    EXPECT_EQ(ground[1]["header"]["stamp"]["sec"].as<int>(), 9);
    EXPECT_EQ(second.front().x, first.back().x);
    EXPECT_EQ(second.front().y, first.back().y);
    // An aircraft opens and does not wait for an opening.
    const YAML::Node air = parts("air");
    ASSERT_EQ(air.size(), 2U);
    EXPECT_TRUE(openings(air[0]).empty() && openings(air[1]).empty());
}

// Late enough that it need not wait: the last bend before the crate ends a part all the same.
TEST_F(RosParts, EndBeforeAnOpeningWithoutAWait) {
    plan.agents[0].path = {{0, 0, 6}, {2, 0, 8}, {2, 2, 10}, {6, 2, 14}};
    const YAML::Node ground = parts("ground");
    ASSERT_EQ(ground.size(), 2U);
    EXPECT_EQ(poses(ground[0]).back().t, 10);
    EXPECT_EQ(openings(ground[1]), std::vector<int>{1});
}

// Such as a breach that had begun when the plan was revised.
TEST_F(RosParts, EndBeforeWhatOpensByItself) {
    mission.rules.opened = {{plan.breaches[0].obstacle, 9}};
    plan.breaches.clear();
    plan.agents[0].path = {{0, 0, 6}, {2, 0, 8}, {2, 2, 10}, {6, 2, 14}};
    ASSERT_EQ(parts("ground").size(), 2U);
    EXPECT_EQ(openings(parts("ground")[1]), std::vector<int>{1});
    plan.revised = Revised{.now = 9};  // open by then
    EXPECT_EQ(parts("ground").size(), 1U);
}

// What the robot is bound to do ends at its decision point.
TEST_F(RosParts, EndWhereARevisionLetsTheRobotDecide) {
    plan.revised = Revised{.decisions = {{"air", 1, 4}, {"ground", 1, 2}}};
    const YAML::Node ground = parts("ground");
    ASSERT_EQ(ground.size(), 3U);
    EXPECT_EQ(poses(ground[0]).back().t, 2);
    EXPECT_EQ(poses(ground[1]).back().t, 4);
    EXPECT_EQ(openings(ground[2]), std::vector<int>{1});
    EXPECT_EQ(parts("air").size(), 2U);
}

// Beside the crate a narrow robot touches nothing, and a wide one does.
TEST_F(RosParts, KnowTheRobotsSize) {
    plan.agents[0].path = {{0, 0, 0}, {2, 0, 2}, {6, 0, 6}};
    mission.agents[0].body = {.radius = 0.5};
    EXPECT_EQ(parts("ground").size(), 1U);
    mission.agents[0].body = {.radius = 0.501};
    ASSERT_EQ(parts("ground").size(), 2U);
    EXPECT_EQ(openings(parts("ground")[1]), std::vector<int>{1});
}

TEST_F(RosParts, LeaveOutWhatLeadsNowhere) {
    plan.agents[0].path = {{0, 0, 0}, {0, 0, 3}, {0, 0, 5}, {2, 0, 7}, {2, 0, 7}, {2, 0, 9}};
    ASSERT_EQ(parts("ground").size(), 1U);
    EXPECT_EQ(poses(parts("ground")[0]).front().t, 5);
    plan.agents[0].path = {{0, 0, 0}};
    EXPECT_EQ(parts("ground").size(), 0U);
}

}  // namespace
}  // namespace waybreaker::io

// Missions that cannot be put on the map: each refusal says what is wrong and what to do.
#include <gtest/gtest.h>

#include <cmath>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {
namespace {

const Map& small_map() {
    static const Map map = map_from_ascii(R"(
        ....
        .aa.
        ....)");
    return map;
}

std::string refusal(const Mission& mission, const MissionOptions& options = {}, const Map& map = small_map()) {
    const std::string said = input_error([&] { validate(map, mission, options); });
    EXPECT_EQ(said, input_error([&] { MissionPlanner().plan(map, mission, options); })) << "a plan validates first";
    return said;
}

void expect_words(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << '"' << message << "\" does not say \"" << word << '"';
    }
}

TEST(ValidateMission, AcceptsWhatCanBePlanned) {
    EXPECT_EQ(refusal(ground_and_air({0, 0}, {3, 2})), "");
    EXPECT_EQ(refusal(ground_and_air({0, 0}, {0, 0}), paper_options(0)), "");
}

TEST(ValidateMission, RefusesPlacesOffTheMap) {
    expect_words(refusal(ground_and_air({-1, 0}, {3, 2})), {"ground", "start", "-1,0", "off the map", "0 to 3"});
    expect_words(refusal(ground_and_air({0, 0}, {3, 3})), {"ground", "goal", "3,3", "off the map", "0 to 2"});
    Mission far_flyer = ground_and_air({0, 0}, {3, 2});
    far_flyer.agents[1].goal = {2147483647, -2147483647};
    expect_words(refusal(far_flyer), {"air", "goal", "off the map"});
}

TEST(ValidateMission, RefusesToStartInAWallAndNamesAFreeCell) {
    expect_words(refusal(ground_and_air({1, 1}, {3, 2})), {"ground", "start", "1,1", "obstacle 1", "free cell"});
    expect_words(refusal(ground_and_air({0, 0}, {2, 1})), {"ground", "goal", "2,1", "obstacle 1", "free cell"});
    MissionOptions wide;
    wide.search.motion.radius = 0.75;
    expect_words(refusal(ground_and_air({0, 0}, {3, 2}), wide), {"ground", "0,0", "0.75", "no free cell"});
    const Map full = map_from_ascii("###");
    expect_words(refusal(ground_and_air({0, 0}, {2, 0}), {}, full), {"obstacle 1", "no free cell"});
}

TEST(ValidateMission, LetsTheAirAgentStartOverAWall) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    mission.agents[1].start = {1, 1};
    EXPECT_EQ(refusal(mission), "");
}

TEST(ValidateMission, RefusesWrongOptions) {
    const Mission mission = ground_and_air({0, 0}, {3, 2});
    expect_words(refusal(mission, paper_options(-1)), {"removals", "negative"});
    MissionOptions options;
    for (const double weight : {0.5, 1e7, HUGE_VAL, std::nan("")}) {
        options.search.weight = weight;
        expect_words(refusal(mission, options), {"weight", "from 1 to 1e+06"});
    }
    options = {};
    options.search = {.planner = Planner::jps, .motion = {.diagonal = false}};
    expect_words(refusal(mission, options), {"jps", "astar"});
    options.search = {.motion = {.radius = 33}};
    expect_words(refusal(mission, options), {"radius", "0.5 to 32"});
    options.search = {.motion = {.radius = 1e300}};
    expect_words(refusal(mission, options), {"not 1e+300"});
}

TEST(ValidateMission, RefusesImpossibleRemovals) {
    const Mission mission = ground_and_air({0, 0}, {3, 2});
    for (const double time : {-1.0, 2e9, std::nan(""), HUGE_VAL}) {
        MissionOptions options;
        options.breach_time.per_obstacle = time;
        expect_words(refusal(mission, options), {"breach", "time"});
        options.breach_time = {0, time};
        expect_words(refusal(mission, options), {"breach", "time"});
    }
    MissionOptions options;
    options.protect = {{1}, {2}};
    expect_words(refusal(mission, options), {"no obstacle 2", "has 1"});
    options.protect = {{0}};
    expect_words(refusal(mission, options), {"no obstacle 0"});
    options.protect = {{1}};
    EXPECT_EQ(refusal(mission, options), "");
    options.weights = {0};
    expect_words(refusal(mission, options), {"weights", "all 1 obstacles", "not for 0"});
    for (const double weight : {0.0, 1e-300, 1e13, std::nan("")}) {
        options.weights = {0, weight};
        expect_words(refusal(mission, options), {"weight of obstacle 1", "from 1e-09 to 1e+12"});
    }
    options.weights = {0, 2};
    options.budget = -1;
    expect_words(refusal(mission, options), {"budget", "-1"});
    options.budget = 3;
    options.time_limit = 0;
    expect_words(refusal(mission, options), {"time limit"});
}

TEST(ValidateMission, RefusesToForceWhatCannotBe) {
    const Mission mission = ground_and_air({0, 0}, {3, 2});
    MissionOptions options;
    options.force = {{2}};
    expect_words(refusal(mission, options), {"no obstacle 2 to force", "has 1"});
    options.force = {{1}};
    EXPECT_EQ(refusal(mission, options), "");
    options.protect = {{1}};
    expect_words(refusal(mission, options), {"obstacle 1", "protected"});
    options.protect = {};
    options.removals = 0;
    expect_words(refusal(mission, options), {"at most 0 obstacles", "1 are"});
    options.removals = 3;
    options.budget = 0.5;
    expect_words(refusal(mission, options), {"weigh 1", "budget of 0.5"});
    options.force = {{1}, {1}};
    expect_words(refusal(mission, options), {"obstacle 1", "twice"});
}

TEST(ValidateMission, RefusesImpossibleAgents) {
    for (const double speed : {0.0, -1.0, 1e-320, 1e-7, 1e7, std::nan(""), HUGE_VAL}) {
        Mission mission = ground_and_air({0, 0}, {3, 2});
        mission.agents[1].speed = speed;
        expect_words(refusal(mission), {"air", "speed", "from 1e-06 to 1e+06"});
    }
    Mission alone = ground_and_air({0, 0}, {3, 2});
    alone.agents.pop_back();
    expect_words(refusal(alone), {"one ground agent and one air agent", "1 and 0"});
    Mission crowd = ground_and_air({0, 0}, {3, 2});
    crowd.agents.push_back(crowd.agents[0]);
    expect_words(refusal(crowd), {"2 and 1"});
    expect_words(refusal({}), {"0 and 0"});
}

}  // namespace
}  // namespace waybreaker

// Missions that cannot be put on the map: each refusal says what is wrong and what to do.
#include <gtest/gtest.h>

#include <cmath>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "waybreaker/place_error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

const Map& small_map() {
    static const Map map = map_from_ascii(R"(
        ....
        .aa.
        ....)");
    return map;
}

std::string refusal(const Mission& mission, const Method& method = {}, const Map& map = small_map()) {
    const std::string said = input_error([&] { validate(map, mission, method); });
    EXPECT_EQ(said, input_error([&] { Planner().plan(map, mission, method); })) << "a plan validates first";
    return said;
}

void expect_words(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << '"' << message << "\" does not say \"" << word << '"';
    }
}

TEST(ValidateMission, AcceptsWhatCanBePlanned) {
    EXPECT_EQ(refusal(ground_and_air({0, 0}, {3, 2})), "");
    EXPECT_EQ(refusal(ground_and_air({0, 0}, {0, 0}), {.select = Selection::hits}), "");
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
    Mission wide = ground_and_air({0, 0}, {3, 2});
    wide.agents[0].body.radius = 0.75;
    expect_words(refusal(wide), {"ground", "0,0", "0.75", "the map has no cell with room for the agent"});
    const Map full = map_from_ascii("###");
    expect_words(refusal(ground_and_air({0, 0}, {2, 0}), {}, full), {"obstacle 1", "no free cell"});
}

// The parts of that refusal, for programs that know places by other words.
TEST(ValidateMission, SaysInPartsWhoHasNoRoom) {
    const auto misplaced = [](const Map& map, const Mission& mission) -> Misplaced {
        try {
            validate(map, mission);
        } catch (const PlaceError& error) {
            const Misplaced& agent = error.misplaced;
            expect_words(error.what(), {agent.what_for, agent.reason, agent.remedy});
            return agent;
        }
        ADD_FAILURE() << "it has room";
        return {};
    };
    const Misplaced in_wall = misplaced(small_map(), ground_and_air({0, 0}, {2, 1}));
    EXPECT_EQ(in_wall.what_for, "the ground agent's goal");
    EXPECT_EQ(in_wall.at, (Cell{2, 1}));
    EXPECT_EQ(in_wall.obstacle, ObstacleId{1});
    EXPECT_EQ(in_wall.nearest, (Cell{2, 0}));
    Mission wide = ground_and_air({0, 0}, {3, 2});
    wide.agents[0].body.radius = 0.75;
    const Misplaced too_wide = misplaced(small_map(), wide);
    EXPECT_EQ(too_wide.obstacle, ObstacleId{});
    EXPECT_EQ(too_wide.nearest, std::nullopt);
}

// Which a program can make of any number.
TEST(ValidateMission, RefusesWordsThatThereAreNot) {
    const Mission good = ground_and_air({0, 0}, {3, 2});
    Mission mission = good;
    mission.rules.objective = Objective(99);
    expect_words(refusal(mission), {"objective"});
    mission = good;
    mission.rules.timing = Timing(2);
    expect_words(refusal(mission), {"timing"});
    mission = good;
    mission.rules.at_goal = AtGoal(-1);
    expect_words(refusal(mission), {"goals"});
    mission = good;
    mission.agents[1].kind = AgentKind(2);
    expect_words(refusal(mission), {"kind"});
    mission = good;
    mission.agents[0].body.corners = Corners(3);
    expect_words(refusal(mission), {"corners"});
    expect_words(refusal(good, {.select = Selection(4)}), {"select"});
    expect_words(refusal(good, {.flight = FlightRule(2)}), {"fly"});
    expect_words(refusal(good, {.planner = Algorithm(99)}), {"planner"});
    expect_words(refusal(good, {.planner = Algorithm::astar, .heuristic = Heuristic(5)}), {"heuristic"});
    expect_words(refusal(good, {.planner = Algorithm::astar, .tie_break = TieBreak(2)}), {"tie"});
}

TEST(ValidateMission, LetsTheAirAgentStartOverAWall) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    mission.agents[1].start = {1, 1};
    EXPECT_EQ(refusal(mission), "");
}

TEST(ValidateMission, RefusesAMethodThatCannotPlanIt) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    for (const double weight : {0.5, 1e7, HUGE_VAL, std::nan("")}) {
        expect_words(refusal(mission, {.weight = weight}), {"weight", "from 1 to 1e+06"});
    }
    expect_words(refusal(mission, {.planner = Algorithm::jps, .diagonal = false}), {"jps", "astar"});
    mission.agents[0].body.radius = 1;
    expect_words(refusal(mission, {.planner = Algorithm::jps}), {"jps", "radius of at most 0.5"});
    const std::string no_time = input_error([&] {
        Planner().plan(small_map(), ground_and_air({0, 0}, {3, 2}), {}, {.seconds = 0});
    });
    expect_words(no_time, {"time limit"});
}

TEST(ValidateMission, RefusesImpossibleBodies) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    for (const double radius : {-1.0, 0.0001, 33.0, 1e300, std::nan("")}) {
        mission.agents[0].body.radius = radius;
        expect_words(refusal(mission), {"radius", "0.001 to 32"});
    }
    mission.agents[0].body = {.radius = 1, .corners = Corners::cut};
    expect_words(refusal(mission), {"point", "0.5"});
    mission.agents[0].body = point_body;
    EXPECT_EQ(refusal(mission), "");
    EXPECT_EQ(refusal(mission, {.select = Selection::hits}), "");
}

TEST(ValidateMission, RefusesImpossibleRemovals) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    Rules& rules = mission.rules;
    rules.removals = -1;
    expect_words(refusal(mission), {"removals", "negative"});
    rules = {};
    for (const double time : {-1.0, 2e9, std::nan(""), HUGE_VAL}) {
        rules.breach_time = {time, 0};
        expect_words(refusal(mission), {"breach", "time"});
        rules.breach_time = {0, time};
        expect_words(refusal(mission), {"breach", "time"});
    }
    rules = {.protect = {{1}, {2}}};
    expect_words(refusal(mission), {"no obstacle 2", "has 1"});
    rules.protect = {{0}};
    expect_words(refusal(mission), {"no obstacle 0"});
    rules.protect = {{1}};
    EXPECT_EQ(refusal(mission), "");
    rules.budget = -1;
    expect_words(refusal(mission), {"budget", "-1"});
}

TEST(ValidateMission, RefusesToForceWhatCannotBe) {
    Mission mission = ground_and_air({0, 0}, {3, 2});
    Rules& rules = mission.rules;
    rules.force = {{2}};
    expect_words(refusal(mission), {"no obstacle 2 to force", "has 1"});
    rules.force = {{1}};
    EXPECT_EQ(refusal(mission), "");
    rules.protect = {{1}};
    expect_words(refusal(mission), {"obstacle 1", "protected"});
    rules.protect = {};
    rules.removals = 0;
    expect_words(refusal(mission), {"at most 0 obstacles", "1 must be"});
    rules.removals = 3;
    rules.budget = 0.5;
    expect_words(refusal(mission), {"weigh 1", "budget of 0.5"});
    rules.force = {{1}, {1}};
    expect_words(refusal(mission), {"obstacle 1", "twice"});
}

TEST(ValidateMission, RefusesImpossibleAgents) {
    for (const double speed : {0.0, -1.0, 1e-320, 1e-7, 1e7, std::nan(""), HUGE_VAL}) {
        Mission mission = ground_and_air({0, 0}, {3, 2});
        mission.agents[1].speed = speed;
        expect_words(refusal(mission), {"air", "speed", "from 1e-06 to 1e+06"});
    }
    Mission alone = ground_and_air({0, 0}, {3, 2});
    alone.agents.pop_back();
    EXPECT_EQ(refusal(alone), "");
    alone.agents[0].kind = AgentKind::air;
    expect_words(refusal(alone), {"no ground agent"});
    Mission crowd = ground_and_air({0, 0}, {3, 2});
    crowd.agents.push_back(crowd.agents[0]);
    expect_words(refusal(crowd), {"two agents", "'ground'"});
    expect_words(refusal({}), {"no ground agent"});
}

}  // namespace
}  // namespace waybreaker

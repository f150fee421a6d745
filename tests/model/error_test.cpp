// Errors say to a program what is wrong, and with whom.
#include "waybreaker/error.hpp"

#include <gtest/gtest.h>

#include "waybreaker/expected.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Map level() {
    return Map::from_rows({
        "....A....",
        "....A....",
        "....A....",
    });
}

Mission mission() {
    return {.agents = {vehicle("rover", {0, 1}, {8, 1}), aircraft("drone", {0, 1})}};
}

Error error_of(const Mission& wrong, const Method& method = {}, const Limits& limits = {}) {
    Planner planner;
    const Expected<Plan> plan = planner.try_plan(level(), wrong, method, limits);
    return plan ? Error{.detail = "there is a plan"} : plan.error();
}

TEST(Error, TryPlanGivesThePlan) {
    Planner planner;
    const Expected<Plan> plan = planner.try_plan(level(), mission());
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->status, PlanStatus::solved);
    EXPECT_EQ((*plan).breaches.size(), 1U);
}

TEST(Error, TryPlanGivesTheErrorThatPlanThrows) {
    Mission wrong = mission();
    wrong.agents[0].goal = {9, 1};
    try {
        Planner().plan(level(), wrong);
        FAIL();
    } catch (const InputError& thrown) {
        const Error error = error_of(wrong);
        EXPECT_EQ(error.code, thrown.error().code);
        EXPECT_EQ(error.subject, thrown.error().subject);
        EXPECT_EQ(error.detail, thrown.what());
    }
}

TEST(Error, CodeAndSubjectSayWhatIsWrongWithWhom) {
    const auto expect = [](const Error& error, ErrorCode code, const std::string& subject) {
        EXPECT_EQ(to_string(error.code), to_string(code)) << error.detail;
        EXPECT_EQ(error.subject, subject) << error.detail;
    };
    Mission wrong = mission();
    wrong.agents[1].goal = {0, -1};
    expect(error_of(wrong), ErrorCode::off_map, "drone");
    wrong = mission();
    wrong.agents[0].start = {4, 1};
    expect(error_of(wrong), ErrorCode::no_room, "rover");
    wrong = mission();
    wrong.rules.force = {ObstacleId{2}};
    expect(error_of(wrong), ErrorCode::unknown_obstacle, "2");
    wrong.rules.force = wrong.rules.protect = {ObstacleId{1}};
    expect(error_of(wrong), ErrorCode::contradiction, "1");
    wrong = mission();
    wrong.agents[1].id = "rover";
    expect(error_of(wrong), ErrorCode::contradiction, "rover");
    wrong = mission();
    wrong.agents[0].speed = 0;
    expect(error_of(wrong), ErrorCode::out_of_range, "the rover agent's speed");
    expect(error_of(mission(), {}, {.seconds = 0}), ErrorCode::out_of_range, "the time limit");
    expect(error_of(mission(), {.select = Selection::hits, .planner = Algorithm::jps, .diagonal = false}),
           ErrorCode::contradiction, "");
}

TEST(Error, FilesAndOptionsStandBeforeTheDetail) {
    const InputError file("a--b.geojson", 3, "is no number");
    EXPECT_STREQ(file.what(), "a--b.geojson:3: is no number");
    EXPECT_EQ(file.error().code, ErrorCode::file);
    EXPECT_EQ(file.error().subject, "a--b.geojson:3");
    EXPECT_EQ(file.error().detail, "is no number");
    const OptionError option("wall-width", "0: expected more");
    EXPECT_STREQ(option.what(), "wall-width 0: expected more");
    EXPECT_EQ(option.error().code, ErrorCode::option);
    EXPECT_EQ(option.error().subject, "wall-width");
    EXPECT_EQ(option.error().detail, "0: expected more");
    EXPECT_EQ(SizeError("the image is too large").error().code, ErrorCode::too_large);
}

}  // namespace
}  // namespace waybreaker

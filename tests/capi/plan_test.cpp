// Planning and checking by the C interface. That its plans are those of the command: command_test.cpp.
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "capi/owned.hpp"
#include "waybreaker/version.hpp"

namespace waybreaker::capi {
namespace {

using Json = nlohmann::json;

// A wall that the vehicle has to drive around, two cells from the end.
std::string walled_yard() {
    std::string map = "type octile\nheight 9\nwidth 20\nmap\n";
    for (int y = 0; y < 9; ++y) map += y < 8 ? "..........@.........\n" : "....................\n";
    return map;
}

const std::string through_the_wall = R"({"format": "waybreaker-mission/1",
    "agents": [{"id": "rover", "kind": "ground", "start": [2, 1], "goal": [17, 1]},
               {"id": "drone", "kind": "air", "start": [2, 1], "goal": [17, 1], "speed": 4}],
    "rules": {"removals": 1}})";

std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

class CPlan : public testing::Test {
  protected:
    OwnedMap map = from_movingai(walled_yard());
    OwnedPlanner planner = new_planner();
};

TEST(CVersion, IsThatOfTheHeader) {
    EXPECT_STREQ(waybreaker_version(), WAYBREAKER_VERSION_STRING);
}

TEST_F(CPlan, BreachesTheWall) {
    const Answer plan = capi::plan(planner, map, through_the_wall);
    ASSERT_EQ(plan.status, WAYBREAKER_OK) << plan.error;
    EXPECT_EQ(plan.error, "");
    const Json document = Json::parse(plan.text);
    EXPECT_EQ(document["status"], "solved");
    EXPECT_EQ(document["map"]["source"], "yard.map");
    EXPECT_EQ(document["map"]["digest"], waybreaker_map_digest(map.get()));
    EXPECT_EQ(document["removed"].size(), 1U);
    EXPECT_EQ(document["after"]["makespan"], 15.0);
    EXPECT_FALSE(document.contains("seconds"));
}

TEST_F(CPlan, MeasuresSecondsWhereAsked) {
    waybreaker_text* plan = nullptr;
    ASSERT_EQ(waybreaker_plan(planner.get(), map.get(), through_the_wall.data(), through_the_wall.size(), true, &plan,
                              nullptr),
              WAYBREAKER_OK);
    EXPECT_TRUE(Json::parse(taken(plan)).contains("seconds"));
}

TEST_F(CPlan, IsTheSameFromAPlannerThatHasPlannedBefore) {
    const std::string first = capi::plan(new_planner(), map, through_the_wall).text;
    const OwnedMap other = from_movingai("type octile\nheight 2\nwidth 30\nmap\n" + std::string(30, '.') + "\n" +
                                         std::string(30, '.') + "\n");
    const std::string there = with(with(through_the_wall, "[17, 1]", "[29, 1]"), "[17, 1]", "[29, 1]");
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(capi::plan(planner, map, through_the_wall).text, first) << i;
        ASSERT_EQ(capi::plan(planner, other, there).status, WAYBREAKER_OK) << i;
        ASSERT_EQ(capi::plan(planner, map, "nonsense").status, WAYBREAKER_INPUT_ERROR) << i;
    }
}

TEST_F(CPlan, OfATeam) {
    const std::string team = R"({"format": "waybreaker-mission/1",
        "agents": [{"id": "a", "kind": "ground", "start": [2, 1], "goal": [17, 1]},
                   {"id": "b", "kind": "ground", "start": [2, 4], "goal": [17, 4]},
                   {"id": "drone", "kind": "air", "start": [2, 1], "goal": [17, 1], "speed": 4}],
        "rules": {"removals": 1}})";
    const Answer plan = capi::plan(planner, map, team);
    ASSERT_EQ(plan.status, WAYBREAKER_OK) << plan.error;
    EXPECT_EQ(Json::parse(plan.text)["agents"].size(), 3U);
    bool valid = false;
    EXPECT_EQ(check(map, plan.text, &valid).status, WAYBREAKER_OK);
    EXPECT_TRUE(valid);
}

TEST_F(CPlan, FrontSaysWhatEachRemovalGains) {
    const Answer front = capi::front(planner, map, with(through_the_wall, R"("removals": 1)", R"("removals": 5)"));
    ASSERT_EQ(front.status, WAYBREAKER_OK) << front.error;
    const Json document = Json::parse(front.text);
    ASSERT_EQ(document["front"].size(), 2U) << "there is but one wall";
    EXPECT_GT(document["front"][0]["makespan"], document["front"][1]["makespan"]);
    EXPECT_EQ(document["options"]["removals"], 1);
    EXPECT_EQ(document["mission"]["rules"]["removals"], 1);
}

TEST_F(CPlan, WithABudgetOfSquareMetresWeighsAreas) {
    const OwnedMap in_metres = from_movingai(walled_yard(), "yard.map", 4, 2);
    const std::string cheap = with(through_the_wall, R"("removals": 1)", R"("removals": 1, "budget_m2": 31)");
    EXPECT_TRUE(Json::parse(capi::plan(planner, in_metres, cheap).text)["removed"].empty());
    const Answer enough = capi::plan(planner, in_metres, with(cheap, "31", "32"));
    EXPECT_EQ(Json::parse(enough.text)["removed"][0]["weight"], 32);
    bool valid = false;
    EXPECT_EQ(check(in_metres, enough.text, &valid).status, WAYBREAKER_OK);
    EXPECT_TRUE(valid);
    EXPECT_NE(capi::plan(planner, map, cheap).error.find("needs the size of a cell"), std::string::npos)
        << capi::plan(planner, map, cheap).error;
}

TEST_F(CPlan, ThatThereIsNoneIsNoError) {
    const OwnedMap parted = from_movingai("type octile\nheight 2\nwidth 5\nmap\n..@..\n..@..\n");
    const std::string shut = R"({"format": "waybreaker-mission/1",
        "agents": [{"id": "rover", "kind": "ground", "start": [0, 0], "goal": [4, 0]},
                   {"id": "drone", "kind": "air", "start": [0, 0], "goal": [4, 0]}],
        "rules": {"removals": 0}})";
    const Answer plan = capi::plan(planner, parted, shut);
    EXPECT_EQ(plan.status, WAYBREAKER_OK);
    EXPECT_EQ(Json::parse(plan.text)["status"], "no_plan");
    EXPECT_EQ(svg(parted, plan.text).error, "the plan has no agents to draw");
}

TEST_F(CPlan, RefusesBadMissions) {
    const auto why = [&](const std::string& text) {
        const Answer plan = capi::plan(planner, map, text);
        EXPECT_EQ(plan.status, WAYBREAKER_INPUT_ERROR) << text;
        EXPECT_EQ(plan.text, "");
        EXPECT_EQ(capi::front(planner, map, text).error, plan.error);
        return plan.error;
    };
    EXPECT_EQ(why("").substr(0, 12), "the mission:");
    EXPECT_EQ(why("{").substr(0, 12), "the mission:");
    EXPECT_EQ(why(std::string(1000, '[')).substr(0, 12), "the mission:");
    EXPECT_EQ(why(std::string("{\0}", 3)).substr(0, 12), "the mission:");
    EXPECT_NE(why(with(through_the_wall, "rover", "drone")), "");
    EXPECT_EQ(why(with(through_the_wall, "[17, 1]", "[10, 1]")).substr(0, 62),
              "the rover agent's goal 10,1 lies inside obstacle 1; a free cel");
    EXPECT_NE(why(with(through_the_wall, "[2, 1]", "[-2, 1]")), "");
    EXPECT_NE(why(with(through_the_wall, R"("removals": 1)", R"("removals": -1)")), "");
    EXPECT_NE(why(with(through_the_wall, R"("removals": 1)", R"("removals": 1, "protect": [2])")), "");
    EXPECT_NE(why(with(through_the_wall, R"("removals": 1)", R"("removals": 1, "protect": ["amenity=school"])")), "");
}

TEST_F(CPlan, TakesNullAsAnError) {
    const OwnedMap none;
    EXPECT_EQ(capi::plan(OwnedPlanner(), map, through_the_wall).error, "the planner is NULL");
    EXPECT_EQ(capi::plan(planner, none, through_the_wall).error, "the map is NULL");
    EXPECT_EQ(capi::front(planner, none, through_the_wall).error, "the map is NULL");
    EXPECT_EQ(check(none, "{}").error, "the map is NULL");
    EXPECT_EQ(svg(none, "{}").error, "the map is NULL");
    waybreaker_text* text = nullptr;
    EXPECT_EQ(waybreaker_plan(planner.get(), map.get(), nullptr, 7, false, &text, nullptr), WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(text, nullptr);
    EXPECT_EQ(waybreaker_plan(planner.get(), map.get(), nullptr, 0, false, &text, nullptr), WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(waybreaker_plan(planner.get(), map.get(), through_the_wall.data(), through_the_wall.size(), false,
                              nullptr, nullptr),
              WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(waybreaker_check(map.get(), nullptr, 3, nullptr, &text, nullptr), WAYBREAKER_INPUT_ERROR);
    waybreaker_text_free(nullptr);
    waybreaker_planner_free(nullptr);
    waybreaker_planner_stop(nullptr);
    EXPECT_STREQ(waybreaker_text_data(nullptr), "");
    EXPECT_EQ(waybreaker_text_size(nullptr), 0U);
}

TEST_F(CPlan, IsJudgedByTheMap) {
    const std::string plan = capi::plan(planner, map, through_the_wall).text;
    bool valid = false;
    const Answer good = check(map, plan, &valid);
    EXPECT_EQ(good.status, WAYBREAKER_OK);
    EXPECT_TRUE(valid);
    EXPECT_EQ(Json::parse(good.text)["format"], "waybreaker-check/1");

    const Answer faster = check(map, with(plan, R"("makespan": 15)", R"("makespan": 14)"), &valid);
    EXPECT_EQ(faster.status, WAYBREAKER_OK) << "a plan that is not valid is no error";
    EXPECT_FALSE(valid);
    EXPECT_FALSE(Json::parse(faster.text)["valid"]);

    const OwnedMap other = from_movingai(with(walled_yard(), "....................\n", "...................@\n"));
    check(other, plan, &valid);
    EXPECT_FALSE(valid) << "it is for another map";
    EXPECT_EQ(svg(other, plan).status, WAYBREAKER_INPUT_ERROR);

    valid = true;
    const Answer unread = check(map, "{}", &valid);
    EXPECT_EQ(unread.status, WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(unread.error.substr(0, 9), "the plan:");
    EXPECT_FALSE(valid);

    const OwnedMap by_corners = from_movingai(walled_yard(), "yard.map", 8);
    EXPECT_EQ(check(by_corners, plan).error, "the plan is for a map of connectivity 4: make the map with it");
}

TEST_F(CPlan, IsDrawn) {
    const std::string picture = svg(map, capi::plan(planner, map, through_the_wall).text).text;
    EXPECT_EQ(picture.substr(0, 4), "<svg");
    EXPECT_NE(picture.find("yard.map"), std::string::npos);
}

// 256 x 256 cells, a third of them blocked, most of these alone: to prove the best 40 of them takes hours.
std::string rubble() {
    std::string map = "type octile\nheight 256\nwidth 256\nmap\n";
    std::uint32_t state = 1;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            state = state * 1664525 + 1013904223;
            const bool corner = (x < 3 || x > 252) && (y < 3 || y > 252);
            map += !corner && state >> 16 < 22000 ? '@' : '.';
        }
        map += '\n';
    }
    return map;
}

TEST_F(CPlan, StopsForAnotherThread) {
    const OwnedMap large = from_movingai(rubble());
    const std::string long_mission = R"({"format": "waybreaker-mission/1",
        "agents": [{"id": "rover", "kind": "ground", "start": [1, 1], "goal": [254, 254]},
                   {"id": "drone", "kind": "air", "start": [1, 1], "goal": [254, 254], "speed": 1.5}],
        "rules": {"removals": 40, "breach_time": 1}, "limits": {"seconds": null}})";
    std::atomic<bool> done = false;
    std::thread other([&] {
        // Until it has begun there is nothing to stop.
        while (!done) waybreaker_planner_stop(planner.get());
    });
    const Answer plan = capi::plan(planner, large, long_mission);
    done = true;
    other.join();
    ASSERT_EQ(plan.status, WAYBREAKER_OK) << plan.error;
    const Json document = Json::parse(plan.text);
    EXPECT_TRUE(document["status"] == "stopped" || document.contains("limit_reached")) << document["status"];

    const Answer next = capi::plan(planner, map, through_the_wall);
    EXPECT_EQ(Json::parse(next.text)["status"], "solved") << "later calls are not stopped";
}

TEST_F(CPlan, OfOneMapByManyThreads) {
    const std::string expected = capi::plan(planner, map, through_the_wall).text;
    std::vector<std::thread> threads;
    std::atomic<int> equal = 0;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            const OwnedPlanner own = new_planner();
            for (int j = 0; j < 20; ++j) equal += capi::plan(own, map, through_the_wall).text == expected ? 1 : 0;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(equal, 80);
}

}  // namespace
}  // namespace waybreaker::capi

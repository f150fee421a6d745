// Revisions and their check by the C interface. That they are those of the command: command_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "capi/owned.hpp"
#include "io/sha256.hpp"

namespace waybreaker::capi {
namespace {

using Json = nlohmann::json;

constexpr std::string_view one_wall =
    "type octile\nheight 4\nwidth 9\nmap\n....@....\n....@....\n....@....\n.........\n";

const std::string breach_the_wall = R"({"format": "waybreaker-mission/1",
    "agents": [{"id": "rover", "kind": "ground", "start": [0, 1], "goal": [8, 1]},
               {"id": "drone", "kind": "air", "start": [0, 1], "goal": [0, 1]}],
    "rules": {"removals": 1, "breach_time": 1}})";

std::string reported(const std::string& more, int sequence = 1, const std::string& now = "4") {
    return R"({"format": "waybreaker-state/1", "sequence": )" + std::to_string(sequence) + R"(, "now": )" + now + more +
           "}";
}

const std::string failure = reported(R"(, "failed": [{"obstacle": 1, "at": 4}])");

class CRevise : public testing::Test {
  protected:
    OwnedMap map = from_movingai(one_wall);
    OwnedPlanner planner = new_planner();
    std::string plan = capi::plan(planner, map, breach_the_wall).text;
};

TEST_F(CRevise, PlansAroundWhatCouldNotBeBreached) {
    const Answer next = revise(planner, map, plan, failure);
    ASSERT_EQ(next.status, WAYBREAKER_OK) << next.error;
    const Json document = Json::parse(next.text);
    EXPECT_EQ(document["status"], "solved");
    EXPECT_TRUE(document["removed"].empty());
    EXPECT_EQ(document["revision"]["status"], "revised");
    EXPECT_EQ(document["revision"]["number"], 1);
    EXPECT_EQ(document["revision"]["supersedes"], io::sha256_digest(plan));
    EXPECT_EQ(document["map"]["digest"], waybreaker_map_digest(map.get()));
    bool valid = false;
    EXPECT_EQ(check_after(map, next.text, plan, failure, &valid).status, WAYBREAKER_OK);
    EXPECT_TRUE(valid);
    EXPECT_EQ(revise(planner, map, next.text, failure).text, next.text) << "a report twice is a report once";
}

TEST_F(CRevise, KeepsWhatIsNoWorse) {
    EXPECT_EQ(Json::parse(revise(planner, map, plan, reported("", 1, "2")).text)["revision"]["status"], "kept");
}

TEST_F(CRevise, SaysWhyThereIsNoPlan) {
    const Answer none =
        revise(planner, map, plan, reported(R"(, "agents": [{"id": "rover", "passed": 0, "doing": "lost"}])"));
    ASSERT_EQ(none.status, WAYBREAKER_OK) << "that there is none is no error";
    const Json document = Json::parse(none.text);
    EXPECT_EQ(document["status"], "no_plan");
    EXPECT_EQ(document["revision"]["status"], "no_plan");
    EXPECT_EQ(document["revision"]["reason"], "no vehicle is left to drive");
    EXPECT_FALSE(document["revision"].contains("halts"));
}

TEST_F(CRevise, SaysWhoMustStop) {
    const Answer broken = revise(planner, map, plan, reported(R"(, "found": [{"cells": [[2, 1]]}])", 1, "1"), 3);
    ASSERT_EQ(broken.status, WAYBREAKER_OK) << broken.error;
    const Json document = Json::parse(broken.text);
    EXPECT_EQ(document["status"], "no_plan");
    EXPECT_EQ(document["revision"]["status"], "broken");
    ASSERT_EQ(document["revision"]["halts"].size(), 1U);
    const Json& halt = document["revision"]["halts"][0];
    EXPECT_EQ(halt["agent"], "rover");
    EXPECT_GT(halt["by"], 1);
    EXPECT_LT(halt["by"], 3) << "it leaves at 1, and touches the cell one cell further on";
}

TEST_F(CRevise, KnowsWhatWasFoundFromThePlanAlone) {
    const std::string report = reported(R"(, "found": [{"cells": [[6, 1]]}])", 1, "1");
    const std::string first = revise(planner, map, plan, report).text;
    bool valid = false;
    EXPECT_EQ(check(map, first, &valid).error, "");
    EXPECT_TRUE(valid);
    EXPECT_EQ(svg(map, first).status, WAYBREAKER_OK);
    const std::string later = reported("", 2, "2");
    const std::string second = revise(planner, map, first, later).text;
    EXPECT_EQ(Json::parse(second)["revision"]["found"].size(), 1U);
    EXPECT_EQ(Json::parse(second)["revision"]["number"], 2);
    EXPECT_EQ(check_after(map, second, first, later, &valid).status, WAYBREAKER_OK);
    EXPECT_TRUE(valid);
}

TEST_F(CRevise, ANewPlanDoesNotGoOn) {
    bool valid = true;
    const Answer report = check_after(map, plan, plan, failure, &valid);
    EXPECT_EQ(report.status, WAYBREAKER_OK);
    EXPECT_FALSE(valid);
    EXPECT_NE(report.text.find(R"("rule": "continuity")"), std::string::npos) << report.text;
}

TEST_F(CRevise, RefusesWhatDoesNotFit) {
    const auto why = [&](const std::string& plan_document, const std::string& report, double reaction = 0,
                         double seconds = 1) {
        const Answer answer = revise(planner, map, plan_document, report, reaction, seconds);
        EXPECT_EQ(answer.status, WAYBREAKER_INPUT_ERROR) << answer.text;
        EXPECT_EQ(answer.text, "");
        return answer.error;
    };
    EXPECT_EQ(why("{}", failure).substr(0, 9), "the plan:");
    EXPECT_EQ(why(plan, "").substr(0, 10), "the state:");
    EXPECT_EQ(why(plan, reported(R"(, "opened": [{"obstacle": 2, "at": 3}])")),
              "the state: opened obstacle 2: the map has none of that id");
    EXPECT_EQ(why(plan, failure, -1), "the time of reaction must be from 0 to 1e+09, not -1");
    EXPECT_EQ(why(plan, failure, 0, 0), "the time limit must be above 0 seconds");
    EXPECT_EQ(why(plan, failure, 0, std::nan("")), "the time limit must be above 0 seconds");
    const OwnedMap other = from_movingai("type octile\nheight 1\nwidth 2\nmap\n..\n");
    EXPECT_EQ(revise(planner, other, plan, failure).error,
              "the plan: the plan is for a map of 9 x 4 cells, this one has 2 x 1");
    EXPECT_EQ(revise(planner, from_movingai(one_wall, "yard.map", 8), plan, failure).error,
              "the plan is for a map of connectivity 4: make the map with it");
    EXPECT_EQ(check_after(map, plan, "{}", failure).error.substr(0, 16), "the plan before:");
    EXPECT_EQ(check_after(map, plan, plan, "{}").error.substr(0, 10), "the state:");
    EXPECT_EQ(revise(planner, map, plan, failure).status, WAYBREAKER_OK) << "the planner is as before";
}

TEST_F(CRevise, TakesNullAsAnError) {
    EXPECT_EQ(revise(OwnedPlanner(), map, plan, failure).error, "the planner is NULL");
    EXPECT_EQ(revise(planner, OwnedMap(), plan, failure).error, "the map is NULL");
    EXPECT_EQ(check_after(OwnedMap(), plan, plan, failure).error, "the map is NULL");
    waybreaker_text* text = nullptr;
    EXPECT_EQ(waybreaker_revise(planner.get(), map.get(), nullptr, 3, failure.data(), failure.size(), 0, 1, false,
                                &text, nullptr),
              WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(
        waybreaker_revise(planner.get(), map.get(), plan.data(), plan.size(), nullptr, 3, 0, 1, false, &text, nullptr),
        WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(text, nullptr);
}

}  // namespace
}  // namespace waybreaker::capi

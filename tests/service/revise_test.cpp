// Revisions without a live mission: the answer is that of a report to one, and depends on the request alone.
#include "io/plan_file.hpp"
#include "io/state_json.hpp"
#include "live_mission.hpp"
#include "waybreaker/check.hpp"

namespace waybreaker::service {
namespace {

const std::string revise = maps + "/house.map/revise";

const Json through_the_wall{{"format", "waybreaker-mission/1"},
                            {"map", "house.map"},
                            {"agents",
                             {{{"id", "rover"}, {"kind", "ground"}, {"start", {1, 3}}, {"goal", {9, 3}}},
                              {{"id", "drone"}, {"kind", "air"}, {"start", {1, 3}}, {"goal", {9, 3}}}}},
                            {"rules", {{"removals", 1}}}};

class ReviseTest : public LiveMissionServer {
  protected:
    Json plan_of(const Json& mission) const {
        return post_json(maps + "/house.map/plan", {{"mission", mission}, {"no_timing", true}});
    }
};

TEST_F(ReviseTest, AnswersAsToAReport) {
    begin();
    const Json plan = plan_of(through_the_wall);
    ASSERT_EQ(plan["removed"].size(), 1);
    const double time = plan["removed"][0]["cleared_at"];
    const Json news = state(1, time, {{"failed", {{{"obstacle", plan["removed"][0]["obstacle"]}, {"at", time}}}}});
    const Json answer = post_json(revise, {{"plan", plan}, {"state", news}, {"no_timing", true}});
    EXPECT_EQ(answer["status"], "revised");
    EXPECT_GT(answer["makespan"], plan["after"]["makespan"]);
    EXPECT_EQ(post_json(revise, {{"plan", plan}, {"state", news}, {"no_timing", true}}), answer);

    Json reported = post_json(begun(through_the_wall) + "/reports", news);
    for (Json* one : {&reported, &reported["plan"]}) one->erase("seconds");
    reported["plan"]["revision"].erase("supersedes");
    Json left = answer;
    left["plan"].erase("seconds");
    for (Json* outcome : {&reported["plan"]["before"], &reported["plan"]["after"]})
        (*outcome)["ground"].erase("seconds");
    EXPECT_EQ(left, reported);

    const io::PlanFile old = io::parse_plan(plan.dump(), "old");
    const io::PlanFile next = io::parse_plan(answer["plan"].dump(), "new");
    const State said = io::parse_state(news.dump(), "state");
    for (const Violation& violation :
         check_continuity(old.asked.mission, old.plan, said, next.asked.mission, next.plan)) {
        ADD_FAILURE() << violation.message;
    }
}

TEST_F(ReviseTest, RevisionsCanBeRevised) {
    begin();
    const Json first = post_json(revise, {{"plan", plan_of(rover_mission)}, {"state", state(1, 1)}});
    EXPECT_EQ(first["status"], "kept");
    const Json late = state(2, 2, {{"agents", {{{"id", "rover"}, {"passed", 0}, {"at", {1.5, 3.5}}}}}});
    const Json second = post_json(revise, {{"plan", first["plan"]}, {"state", late}, {"reaction", 0.5}});
    EXPECT_EQ(second["revision"], 2);
    EXPECT_EQ(second["changed"], Json::array({"rover"}));
    EXPECT_GE(second["plan"]["revision"]["decided"][0]["time"], 2.5);
    EXPECT_EQ(post_json(maps + "/house.map/check", second["plan"])["valid"], true);
    const Json none = post_json(revise, {{"plan", second["plan"]}, {"state", state(3, 3, gap_blocked)}});
    EXPECT_EQ(none["status"], "no_plan");
    EXPECT_EQ(none["plan"], Json());
    EXPECT_EQ(none["revision"], 2);
}

TEST_F(ReviseTest, SaysWhatIsWrong) {
    begin();
    const Json plan = plan_of(rover_mission);
    const auto detail = [&](const Json& request, int status) {
        return post_json(revise, request, status)["detail"].get<std::string>();
    };
    EXPECT_EQ(detail({{"plan", plan}}, 400), "request:1:1: the document has no member state");
    EXPECT_EQ(detail({{"state", state(1, 1)}}, 400), "request:1:1: the document has no member plan");
    EXPECT_NE(
        detail({{"plan", plan}, {"state", {{"format", "x"}}}}, 400).find("state.format is not waybreaker-state/1"),
        std::string::npos);
    EXPECT_NE(detail({{"plan", plan}, {"state", state(1, 1)}, {"reaction", -1}}, 400).find("reaction"),
              std::string::npos);
    EXPECT_NE(detail({{"plan", plan}, {"state", state(1, 1)}, {"time_limit", 0}}, 400).find("is not above 0"),
              std::string::npos);
    const Json known = post_json(revise, {{"plan", plan}, {"state", state(4, 1)}})["plan"];
    EXPECT_EQ(detail({{"plan", known}, {"state", state(4, 2)}}, 422),
              "the plan knows report 4 already: number the next one upwards");
    EXPECT_EQ(kind(post_json(revise, {{"plan", known}, {"state", state(5, 0.5)}}, 422)), "/problems/report-unfit");
    const Json edits = Json::parse(R"({"free": [[5, 0, 1]]})");
    const std::string edited = post_json(maps + "/house.map/edits", edits, 201)["id"].get<std::string>();
    for (const std::string& other : {edited, std::string("wall.map")}) {
        const Json problem = post_json(maps + "/" + other + "/revise", {{"plan", plan}, {"state", state(1, 1)}}, 422);
        EXPECT_EQ(kind(problem), "/problems/plan-invalid") << other;
    }
}

}  // namespace
}  // namespace waybreaker::service

// Live missions over HTTP: their whole life, reports twice and out of turn, limits, and what bad input gives.
#include <thread>

#include "io/plan_file.hpp"
#include "io/sha256.hpp"
#include "live_mission.hpp"
#include "mapfile/map_reader.hpp"
#include "service/mission_revision.hpp"
#include "waybreaker/check.hpp"

namespace waybreaker::service {
namespace {

class MissionsTest : public LiveMissionServer {};

TEST_F(MissionsTest, BeginGoOnAndEnd) {
    begin();
    const auto begun = post(missions, rover_mission.dump());
    ASSERT_EQ(begun.status, 201) << begun.body;
    const Json mission = Json::parse(begun.body);
    const std::string path = missions + "/" + mission["id"].get<std::string>();
    EXPECT_EQ(begun.get_header_value("Location"), path);
    EXPECT_EQ(mission["revision"], 0);
    EXPECT_EQ(mission["status"], "planned");
    const Json planned = post_json(maps + "/house.map/plan", {{"mission", rover_mission}, {"no_timing", true}});
    EXPECT_EQ(mission["plan"]["agents"], planned["agents"]);
    EXPECT_EQ(get_json(path + "/plan"), mission["plan"]);

    const Json first = post_json(path + "/reports", state(1, 1));
    EXPECT_EQ(first["status"], "kept");
    EXPECT_EQ(first["revision"], 1);
    EXPECT_EQ(first["changed"], Json::array());
    EXPECT_EQ(first["plan"]["revision"]["number"], 1);
    const Json late = state(5, 2, {{"agents", {{{"id", "rover"}, {"passed", 0}, {"at", {1.5, 3.5}}}}}});
    const Json second = post_json(path + "/reports", late);  // a gap in the numbers
    EXPECT_EQ(second["sequence"], 5);
    EXPECT_EQ(second["revision"], 2);
    EXPECT_EQ(second["changed"], Json::array({"rover"}));
    EXPECT_GT(second["makespan"], first["makespan"]);

    EXPECT_EQ(get_json(path + "/plan"), second["plan"]);
    EXPECT_EQ(get_json(path + "/plan?revision=1"), first["plan"]);
    EXPECT_EQ(get_json(path + "/plan?revision=0"), mission["plan"]);
    EXPECT_EQ(kind(get_json(path + "/plan?revision=3", 404)), "/problems/revision-not-found");
    Json summary = mission;
    summary.erase("plan");
    summary.update({{"sequence", 5}, {"revision", 2}, {"now", 2}, {"status", second["status"]}});
    EXPECT_EQ(get_json(path), summary);
    EXPECT_EQ(get_json(missions), Json({{"missions", {summary}}}));

    EXPECT_EQ(remove(path).status, 204);
    EXPECT_EQ(kind(get_json(path, 404)), "/problems/mission-not-found");
    EXPECT_EQ(kind(post_json(path + "/reports", state(6, 3), 404)), "/problems/mission-not-found");
    EXPECT_EQ(get_json(missions)["missions"], Json::array());
}

TEST_F(MissionsTest, RevisionsGoOnFromTheirPlans) {
    begin();
    const std::string path = begun();
    const std::string before = get(path + "/plan").body;
    const Json news = state(1, 2, {{"agents", {{{"id", "rover"}, {"passed", 0}, {"at", {2, 4}}}}}});
    post_json(path + "/reports", news);
    const std::string after = get(path + "/plan").body;
    EXPECT_EQ(Json::parse(after)["revision"]["supersedes"], io::sha256_digest(before));
    const io::PlanFile old = io::parse_plan(before, "old");
    const io::PlanFile next = io::parse_plan(after, "new");
    State reported{.sequence = 1, .now = 2};
    reported.agents.push_back({.id = "rover", .passed = 0, .at = Point(2, 4)});
    for (const Violation& violation :
         check_continuity(old.asked.mission, old.plan, reported, next.asked.mission, next.plan)) {
        ADD_FAILURE() << violation.message;
    }
    EXPECT_EQ(post_json(maps + "/house.map/check", Json::parse(after))["valid"], true);
}

TEST_F(MissionsTest, AReportTwiceIsAReportOnce) {
    begin();
    const std::string path = begun();
    const std::string first = post(path + "/reports", state(3, 1).dump()).body;
    const std::string second = post(path + "/reports", state(4, 2).dump()).body;
    EXPECT_EQ(post(path + "/reports", state(3, 1).dump(2)).body, first);  // spaced otherwise
    EXPECT_EQ(post(path + "/reports", state(4, 2).dump()).body, second);
    EXPECT_EQ(get_json(path)["revision"], 2);
    EXPECT_EQ(kind(post_json(path + "/reports", state(4, 3), 409)), "/problems/report-out-of-turn");
    EXPECT_EQ(kind(post_json(path + "/reports", state(2, 1), 409)), "/problems/report-out-of-turn");
    EXPECT_EQ(get_json(path)["revision"], 2);
}

TEST_F(MissionsTest, ReportsAtOnceAreTakenOneAfterTheOther) {
    options_.limits.workers = 4;
    begin();
    const std::string path = begun();
    std::vector<std::thread> reporting;
    for (int i = 0; i < 8; ++i) {
        reporting.emplace_back(
            [&, i] { client().Post(path + "/reports", state(1 + i / 2, 1).dump(), "application/json"); });
    }
    for (std::thread& one : reporting) one.join();
    // Those that came too late are refused; each that was taken made one revision.
    int taken = 0;
    for (int sequence = 1; sequence <= 4; ++sequence) {
        const auto again = client().Post(path + "/reports", state(sequence, 1).dump(), "application/json");
        taken += again->status == 200 ? 1 : 0;
    }
    EXPECT_GE(taken, 1);
    EXPECT_EQ(get_json(path)["revision"], taken);
}

TEST_F(MissionsTest, NewsWithoutAPlanCountsForTheNextReport) {
    begin();
    const std::string path = begun();
    const Json none = post_json(path + "/reports", state(1, 1, gap_blocked));
    EXPECT_EQ(none["status"], "no_plan");
    EXPECT_EQ(none["reason"], "no_plan");
    EXPECT_EQ(none["plan"], Json());
    EXPECT_EQ(none["revision"], 0);
    EXPECT_EQ(post_json(path + "/reports", state(2, 1.5))["status"], "no_plan");  // it is blocked still
    const Json opened{{"found", {{{"cells", {{5, 6}}}, {"blocked", false}}}}};
    const Json next = post_json(path + "/reports", state(3, 2, opened));
    EXPECT_EQ(next["revision"], 1);
    EXPECT_EQ(next["plan"]["revision"]["number"], 1);
    EXPECT_EQ(next["plan"]["revision"]["found"].size(), 2U);
}

TEST_F(MissionsTest, SaysWhoMustStop) {
    begin();
    const std::string path = begun({{"map", "house.map"}, {"mission", rover_mission}, {"reaction", 3}});
    // By the time it learns of it the rover would be in the gap.
    const Json broken = post_json(path + "/reports", state(1, 3, gap_blocked));
    EXPECT_EQ(broken["status"], "broken");
    EXPECT_EQ(broken["plan"], Json());
    ASSERT_EQ(broken["halts"].size(), 1U);
    EXPECT_EQ(broken["halts"][0]["agent"], "rover");
    EXPECT_GT(broken["halts"][0]["by"], 4);
    EXPECT_LT(broken["halts"][0]["by"], 5);
}

TEST_F(MissionsTest, RefusesWhatIsNoMission) {
    put("maps/shut.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
    begin();
    const auto refused = [&](Json request, int status) { return kind(post_json(missions, request, status)); };
    Json request = rover_mission;
    request.erase("map");
    EXPECT_EQ(refused(request, 400), "/problems/invalid-request");
    for (const char* map : {"nowhere.map", "../maps/house.map", ""}) {
        request["map"] = map;
        EXPECT_EQ(refused(request, 404), "/problems/map-not-found") << map;
    }
    request["map"] = "shut.map";
    request["agents"][0].update({{"start", {0, 0}}, {"goal", {2, 0}}});
    EXPECT_EQ(refused(request, 422), "/problems/mission-without-plan");
    request["agents"][0]["goal"] = {1, 0};
    EXPECT_EQ(refused(request, 422), "/problems/mission-unfit");
    EXPECT_EQ(refused({{"map", "house.map"}, {"methods", Json::array()}}, 400), "/problems/invalid-request");
    EXPECT_EQ(refused({{"map", "house.map"}, {"reaction", -1}}, 400), "/problems/invalid-request");
    EXPECT_EQ(get_json(missions)["missions"], Json::array());
}

TEST_F(MissionsTest, RefusesWhatIsNoReport) {
    begin();
    const std::string path = begun();
    post_json(path + "/reports", state(1, 2));
    const auto detail = [&](const Json& report, int status) {
        return post_json(path + "/reports", report, status)["detail"].get<std::string>();
    };
    EXPECT_NE(detail({{"format", "waybreaker-plan/1"}}, 400).find("report:1:"), std::string::npos);
    EXPECT_NE(detail(state(2, 1), 422).find("now"), std::string::npos);  // before the last report
    const Json stranger{{"agents", {{{"id", "tank"}, {"passed", 0}}}}};
    EXPECT_NE(detail(state(2, 3, stranger), 422).find("tank"), std::string::npos);
    EXPECT_NE(detail(state(2, 3, {{"opened", {{{"obstacle", 99}, {"at", 1}}}}}), 422).find("99"), std::string::npos);
    EXPECT_EQ(get_json(path)["sequence"], 1);
    post_json(path + "/reports", state(2, 3));  // the number is still free
}

TEST_F(MissionsTest, NoMoreAreLiveThanMayBe) {
    options_.limits.live_missions = 2;
    begin();
    const std::string first = begun();
    begun();
    const Json problem = post_json(missions, rover_mission, 507);
    EXPECT_EQ(kind(problem), "/problems/too-many-missions");
    EXPECT_NE(problem["detail"].get<std::string>().find("--live-missions"), std::string::npos);
    remove(first);
    begun();
    Json request = rover_mission;
    request["agents"][0]["goal"] = {5, 0};  // in the house: does not count
    remove(get_json(missions)["missions"][0]["id"].get<std::string>().insert(0, missions + "/"));
    post_json(missions, request, 422);
    begun();
}

TEST_F(MissionsTest, MissionsInMemoryAreWithinItsLimit) {
    options_.store = "";
    options_.limits.memory = std::size_t{8} << 20;
    begin();
    const std::string path = begun();
    constexpr int many = 2000;
    int taken = 0;
    while (taken < many &&
           client().Post(path + "/reports", state(taken + 1, 1).dump(), "application/json")->status == 200)
        ++taken;
    EXPECT_GT(taken, 10);
    const Json problem = post_json(path + "/reports", state(taken + 1, 1), 503);
    EXPECT_NE(problem["detail"].get<std::string>().find("live missions leave no memory"), std::string::npos);
    EXPECT_EQ(get_json(path)["sequence"], taken);
    remove(path);
    EXPECT_NE(get("/metrics").body.find("waybreaker_memory_bytes{use=\"missions\"} 0\n"), std::string::npos);
}

TEST_F(MissionsTest, StayOnTheirMapWhateverBecomesOfIt) {
    options_.limits.maps = 1;
    begin();
    const std::string path = begun();
    put("maps/house.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
    const std::string sent = "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n";
    const std::string id = Json::parse(post(maps, sent, octets).body)["id"];
    Json request = rover_mission;
    request["map"] = id;
    request["agents"][0].update({{"start", {0, 0}}, {"goal", {2, 0}}});
    const std::string on_sent = begun(request);
    EXPECT_EQ(kind(Json::parse(remove(maps + "/" + id).body)), "/problems/map-not-removable");
    EXPECT_EQ(post_json(path + "/reports", state(1, 1))["plan"]["map"]["width"], 11);
    EXPECT_EQ(post_json(on_sent + "/reports", state(1, 1))["plan"]["map"]["source"], id);
    remove(on_sent);
    EXPECT_EQ(remove(maps + "/" + id).status, 204);
}

TEST_F(MissionsTest, AreCounted) {
    begin();
    const std::string path = begun();
    post_json(path + "/reports", state(1, 1));
    post_json(path + "/reports", state(2, 1.5, gap_blocked));
    post_json(path + "/reports", state(1, 1));  // again
    const std::string metrics = get("/metrics").body;
    for (const char* line :
         {"waybreaker_missions_live 1\n", "waybreaker_missions_limit 100\n", "waybreaker_event_streams 0\n",
          "waybreaker_reports_total{status=\"kept\"} 1\n", "waybreaker_reports_total{status=\"no_plan\"} 1\n"}) {
        EXPECT_NE(metrics.find(line), std::string::npos) << line;
    }
}

TEST(States, TheLaterOneIsRightAndNothingIsForgotten) {
    const Found wall{.cells = {{1, 1}}};
    State earlier{.sequence = 1, .now = 1};
    earlier.agents = {{.id = "a", .passed = 2, .doing = Doing::lost},
                      {.id = "b", .passed = 2, .at = Point(1, 2), .goal = Cell{3, 3}},
                      {.id = "c", .passed = 1, .goal = Cell{4, 4}},
                      {.id = "d", .passed = 1, .at = Point(1, 2)}};
    earlier.opened = {{{1}, 1}, {{2}, 1}};
    earlier.failed = {{{3}, 1}, {{4}, 1}};
    earlier.found = {wall};
    earlier.joined = {vehicle("new", {0, 0}, {1, 1})};
    State later{.sequence = 2, .now = 2};
    later.agents = {{.id = "c", .passed = 2}};
    later.opened = {{{3}, 2}};
    later.failed = {{{2}, 2}};
    later.found = {wall, {.cells = {{2, 2}}}};
    const State both = with_earlier(later, earlier);
    EXPECT_EQ(both.sequence, 2U);
    ASSERT_EQ(both.agents.size(), 3U);
    EXPECT_EQ(both.agents[0].passed, 2U);
    EXPECT_EQ(both.agents[0].goal, (Cell{4, 4}));
    EXPECT_EQ(both.agents[1].doing, Doing::lost);
    EXPECT_EQ(both.agents[2].goal, (Cell{3, 3}));
    EXPECT_FALSE(both.agents[2].at);  // by now it is elsewhere
    EXPECT_EQ(both.opened, (std::vector<TimedOpening>{{{3}, 2}, {{1}, 1}}));
    EXPECT_EQ(both.failed, (std::vector<TimedOpening>{{{2}, 2}, {{4}, 1}}));
    EXPECT_EQ(both.found.size(), 2U);
    EXPECT_EQ(both.joined.size(), 1U);
}

}  // namespace
}  // namespace waybreaker::service

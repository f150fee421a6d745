// Flights for QGroundControl. They are read by the rules of MAVSDK's reader of such files, restated here, and flown by
// a clock of its own: who follows the items is where the plan has the aircraft, when it has it there.
#include "exports/plan_qgc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "input_error.hpp"
#include "placed_town.hpp"

namespace waybreaker::exports {
namespace {

using Json = nlohmann::json;

class PlanQgc : public PlacedTown {
  protected:
    PlanQgc() {
        for (Itinerary& agent : plan.agents) (agent.kind == AgentKind::air ? aircraft : vehicle) = &agent;
    }

    PlacedPlan flown() const {
        PlacedPlan result = placed();
        result.altitude = 60;
        return result;
    }

    // A MAVSDK reader takes it: versions, a fence and rally points though they are empty, seven parameters an item.
    Json read_flight(const std::string& text) const {
        const Json file = Json::parse(text);
        EXPECT_EQ(file.at("fileType"), "Plan");
        EXPECT_EQ(file.at("version"), 1);
        EXPECT_EQ(file.at("mission").at("version"), 2);
        EXPECT_EQ(file.at("geoFence").at("version"), 2);
        EXPECT_EQ(file.at("rallyPoints").at("version"), 2);
        EXPECT_EQ(file.at("mission").at("plannedHomePosition").size(), 3U);
        int number = 0;
        for (const Json& item : file.at("mission").at("items")) {
            EXPECT_EQ(item.at("type"), "SimpleItem");
            EXPECT_EQ(item.at("autoContinue"), true);
            EXPECT_TRUE(item.at("frame") == 3 || item.at("frame") == 2);
            EXPECT_EQ(item.at("params").size(), 7U);
            EXPECT_EQ(item.at("doJumpId"), ++number);
            for (const Json& param : item.at("params")) EXPECT_TRUE(param.is_number() || param.is_null());
        }
        return file.at("mission");
    }

    Point cell_of(const Json& params) const {
        return geotiff::FromLonLat(*map.georeference)({{params[5], params[4]}}).at(0);
    }

    Itinerary* aircraft = nullptr;
    Itinerary* vehicle = nullptr;
};

TEST_F(PlanQgc, IsFlownAsPlanned) {
    const auto files = plan_qgc(flown(), "out/flight.plan");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].path, "out/flight.plan");
    const Json mission = read_flight(files[0].bytes);
    const Json& items = mission.at("items");
    ASSERT_GE(items.size(), 4U);
    EXPECT_EQ(items.front().at("command"), 22);
    EXPECT_EQ(items.back().at("command"), 21);
    EXPECT_EQ(items[1].at("command"), 178);
    double speed = 0;
    double clock = 0;
    Point at = cell_of(items.front().at("params"));
    std::size_t breach = 0;
    for (std::size_t i = 1; i < items.size(); ++i) {
        const Json& params = items[i].at("params");
        const int command = items[i].at("command");
        if (command == 178) {
            EXPECT_EQ(params[0], 1);
            speed = params[1].get<double>() / map.cell_size;
        } else if (command == 181) {
            EXPECT_EQ(params[0], 0);
            EXPECT_EQ(params[1], 1);
            const Breach& opened = plan.breaches.at(breach++);
            EXPECT_NEAR(clock, opened.cleared_at - 30, 1e-3);
            EXPECT_LT(std::hypot(at.x - opened.at.x, at.y - opened.at.y), 1e-3);
        } else {
            const Point next = cell_of(params);
            clock += std::hypot(next.x - at.x, next.y - at.y) / speed;
            if (command == 19) clock += params[0].get<double>();
            at = next;
            EXPECT_EQ(params[6], command == 21 ? 0 : 60);
            EXPECT_TRUE(command == 16 || command == 19 || command == 21) << command;
        }
    }
    EXPECT_GT(breach, 0U);
    EXPECT_EQ(breach, plan.breaches.size());
    EXPECT_NEAR(clock, aircraft->path.back().t, 1e-3);
    EXPECT_LT(std::hypot(at.x - aircraft->path.back().x, at.y - aircraft->path.back().y), 1e-3);
    EXPECT_NEAR(mission.at("cruiseSpeed").get<double>(), speed * map.cell_size, 1e-9);
}

// Those that hold for it; a fence has no holes.
TEST_F(PlanQgc, HasAFenceRoundZones) {
    std::vector<Zone> zones{
        {ZoneKind::no_fly, {{{10, 10}, {60, 20}, {30, 90}}, {{30, 30}, {32, 30}, {32, 40}}}, "", {}},
        {ZoneKind::no_fly, {{{10, 10}, {60, 20}, {30, 90}}}, "", {"other"}},
        {ZoneKind::keep_out, {{{10, 10}, {60, 20}, {30, 90}}}, "", {}}};
    PlacedPlan zoned = flown();
    EXPECT_TRUE(Json::parse(plan_qgc(zoned, "a.plan")[0].bytes).at("geoFence").at("polygons").empty());
    zoned.zones = zones;
    const std::string text = plan_qgc(zoned, "a.plan")[0].bytes;
    read_flight(text);
    const Json fences = Json::parse(text).at("geoFence").at("polygons");
    ASSERT_EQ(fences.size(), 1U);
    EXPECT_EQ(fences[0].at("inclusion"), false);
    EXPECT_EQ(fences[0].at("version"), 1);
    ASSERT_EQ(fences[0].at("polygon").size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const Json& corner = fences[0].at("polygon")[i];
        const Point cell = geotiff::FromLonLat(*map.georeference)({{corner[1], corner[0]}}).at(0);
        EXPECT_LT(distance(cell, zones[0].polygon[0][i]), 1e-3);
    }
    const Waypoint& start = aircraft->path.front();
    zones[0].polygon = {{{start.x - 9, start.y - 9}, {start.x + 9, start.y - 9}, {start.x, start.y + 9}},
                        {{start.x - 2, start.y - 2}, {start.x + 2, start.y - 2}, {start.x, start.y + 2}}};
    EXPECT_EQ(input_error([&] { plan_qgc(zoned, "a.plan"); }),
              "QGroundControl: agent 'air' is in a hole of zone 1, and areas have no holes there; leave the hole out");
}

TEST_F(PlanQgc, HasTheCommandThatIsAskedFor) {
    const auto commands = [&](const char* text) {
        std::vector<Json> found;
        const Json mission = read_flight(plan_qgc(flown(), "a.plan", *parse_mav_action(text))[0].bytes);
        for (const Json& item : mission.at("items")) {
            const int command = item.at("command");
            if (command != 16 && command != 19 && command != 21 && command != 22 && command != 178)
                found.push_back(item);
        }
        return found;
    };
    const auto placed = commands("NAV_PAYLOAD_PLACE:40");
    ASSERT_EQ(placed.size(), plan.breaches.size());
    EXPECT_EQ(placed[0].at("command"), 94);
    EXPECT_EQ(placed[0].at("frame"), 3);
    EXPECT_EQ(placed[0].at("params")[0], 40);
    EXPECT_NEAR(cell_of(placed[0].at("params")).x, plan.breaches[0].at.x, 1e-3);
    const auto gripped = commands("MAV_CMD_DO_GRIPPER:1,0");
    ASSERT_EQ(gripped.size(), plan.breaches.size());
    EXPECT_EQ(gripped[0].at("frame"), 2);
    EXPECT_EQ(gripped[0].at("params"), Json({1, 0, 0, 0, 0, 0, 0}));
}

TEST_F(PlanQgc, HasAFileForEachAircraft) {
    plan.agents.push_back(*aircraft);
    aircraft = &plan.agents[1];
    aircraft->id = "north/1";
    plan.agents[2].id = "south";
    for (Breach& breach : plan.breaches) breach.by = "south";
    auto files = plan_qgc(flown(), "out/flight.v2.plan");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].path, "out/flight.v2-north_1.plan");
    EXPECT_EQ(files[1].path, "out/flight.v2-south.plan");
    const auto count = [&](const std::string& text) {
        const Json mission = read_flight(text);
        return std::ranges::count_if(mission.at("items"), [](const Json& item) { return item.at("command") == 181; });
    };
    EXPECT_EQ(count(files[0].bytes), 0);
    EXPECT_EQ(std::size_t(count(files[1].bytes)), plan.breaches.size());
    EXPECT_NE(input_error([&] { plan_qgc(flown(), "-"); }).find("not standard output"), std::string::npos);
    plan.agents[2].id = "north_1";
    EXPECT_NE(input_error([&] { plan_qgc(flown(), "a.plan"); }).find("a-north_1.plan would stand for"),
              std::string::npos);
}

TEST_F(PlanQgc, HasAFileForEachFlightFromLandingToLanding) {
    const Waypoint start = aircraft->path.front();
    const Waypoint goal = aircraft->path.back();
    aircraft->path = {start, {7, 1, 10}, {7, 1, 70}, {goal.x, goal.y, 90}};
    aircraft->recharges = {{.at = {7, 1}, .from = 10, .until = 70}};
    plan.breaches.clear();
    const auto files = plan_qgc(flown(), "flight.plan");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].path, "flight-1.plan");
    EXPECT_EQ(files[1].path, "flight-2.plan");
    for (const auto& [name, text] : files) {
        std::vector<int> commands;
        const Json flight = read_flight(text);
        for (const Json& item : flight.at("items")) commands.push_back(item.at("command"));
        EXPECT_EQ(commands, (std::vector<int>{22, 178, 16, 21})) << name;
    }
    EXPECT_NE(input_error([&] { plan_qgc(flown(), "-"); }).find("each of its flights"), std::string::npos);
}

TEST_F(PlanQgc, RefusesWhatCannotBeFlown) {
    EXPECT_NE(input_error([&] { plan_qgc(placed(), "a.plan"); }).find("--altitude"), std::string::npos);
    plan.revised = Revised{};
    EXPECT_NE(input_error([&] { plan_qgc(flown(), "a.plan"); }).find("revised plan"), std::string::npos);
    plan.revised.reset();
    plan.agents = {*vehicle};
    EXPECT_NE(input_error([&] { plan_qgc(flown(), "a.plan"); }).find("no aircraft"), std::string::npos);
    plan.agents.clear();
    EXPECT_TRUE(plan_qgc(flown(), "a.plan").empty());
}

TEST(MavActions, AreRead) {
    const auto params = [](const char* text) { return parse_mav_action(text).value().params; };
    EXPECT_EQ(parse_mav_action("DO_SET_SERVO:9,1900").value().command, 183);
    EXPECT_EQ(params("DO_SET_SERVO:9,1900"), (std::vector<double>{9, 1900}));
    EXPECT_EQ(parse_mav_action("2000").value().command, 2000);
    EXPECT_TRUE(params("2000").empty());
    EXPECT_EQ(params("181:1,2,3,4,5,6,-0.5").size(), 7U);
    for (const char* const none : {"", ":", "DO_THIS", "181:", "181:1,", "181:,1", "181:1,2,3,4,5,6,7,8", "181:x", "-1",
                                   "65536", "181:nan", "181:inf", "181 1", "do_set_relay"}) {
        EXPECT_FALSE(parse_mav_action(none)) << none;
    }
}

}  // namespace
}  // namespace waybreaker::exports

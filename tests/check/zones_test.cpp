// What the checker says of agents in zones.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "check/hand_made.hpp"
#include "waybreaker/check.hpp"

namespace waybreaker {
namespace {

const Map& open_ground() {
    static const Map map(Grid(20, 20));
    return map;
}

Mission mission_with(Zone zone) {
    Mission mission = ground_and_air({0, 9}, {19, 9});
    mission.rules.zones = {std::move(zone)};
    return mission;
}

Zone square(ZoneKind kind, double side = 4) {
    return {.kind = kind, .polygon = {{{8, 8}, {8 + side, 8}, {8 + side, 8 + side}, {8, 8 + side}}}, .name = "Z"};
}

// The first violation of the rule; empty if there is none.
std::string fault(const Mission& mission, const std::vector<Point>& ground, const std::vector<Point>& air) {
    Plan plan = hand_made(driven(ground), driven(air));
    for (const Violation& violation : check(open_ground(), mission, plan)) {
        if (violation.rule != Rule::zone) continue;
        return violation.message + " at " + std::to_string(violation.place->x).substr(0, 5);
    }
    return "";
}

const std::vector<Point> straight{{0, 9}, {19, 9}};
const std::vector<Point> above{{0, 9}, {8, 7}, {12, 7}, {19, 9}};

TEST(CheckZones, FindsFlightsInside) {
    const Mission mission = mission_with(square(ZoneKind::no_fly));
    EXPECT_TRUE(
        fault(mission, straight, straight).starts_with("the air agent flies in zone Z, where nobody may at 8."));
    EXPECT_EQ(fault(mission, straight, above), "");
    EXPECT_EQ(fault(mission, straight, {{0, 9}, {8, 8}, {12, 8}, {19, 9}}), "");  // along the outline
    EXPECT_NE(fault(mission, straight, {{0, 9}, {8, 8.01}, {12, 8.01}, {19, 9}}), "");
    EXPECT_EQ(fault(mission, straight, {{0, 9}, {8, 8.0005}, {12, 8.0005}, {19, 9}}), "");  // rounding
    // Corner to corner, and a bend in it.
    EXPECT_NE(fault(mission, straight, {{0, 9}, {8, 8}, {12, 12}, {19, 9}}), "");
    EXPECT_NE(fault(mission, straight, {{0, 9}, {0, 12}, {9, 11}, {0, 13}, {8, 13}, {13, 13}, {19, 9}}), "");
}

TEST(CheckZones, FindsDrivesThatReachInside) {
    const Mission mission = mission_with(square(ZoneKind::keep_out));
    EXPECT_NE(fault(mission, straight, straight), "");
    EXPECT_EQ(fault(mission, above, straight), "");
    // Its body is half a cell wide on either side.
    const Mission near = mission_with({.kind = ZoneKind::keep_out, .polygon = {{{8, 7.6}, {9, 7.6}, {9, 9}}}});
    EXPECT_TRUE(fault(near, {{0, 9}, {0, 7}, {19, 7}, {19, 9}}, straight).empty());
    const Mission nearer = mission_with({.kind = ZoneKind::keep_out, .polygon = {{{8, 7.4}, {9, 7.4}, {9, 9}}}});
    EXPECT_EQ(fault(nearer, {{0, 9}, {0, 7}, {19, 7}, {19, 9}}, straight),
              "the ground agent drives into zone 1, which it has to keep out of at 8.000");
}

// The way of 19 is in the zone from 8 to 12, its disc from 7.5 to 12.5.
TEST(CheckZones, JudgesInTime) {
    const auto in_time = [](ZoneKind kind, double from, double until) {
        Zone zone = square(kind);
        zone.from = from;
        zone.until = until;
        return fault(mission_with(zone), straight, straight);
    };
    constexpr double always = std::numeric_limits<double>::infinity();
    EXPECT_EQ(in_time(ZoneKind::no_fly, 0, 8), "");
    EXPECT_EQ(in_time(ZoneKind::no_fly, 12, always), "");
    EXPECT_EQ(in_time(ZoneKind::no_fly, 8.5, 9),
              "the air agent flies in zone Z, where nobody may from 8.5 until 9 at 8.500");
    EXPECT_NE(in_time(ZoneKind::no_fly, 0, 8.01), "");
    EXPECT_NE(in_time(ZoneKind::no_fly, 11.99, always), "");
    EXPECT_EQ(in_time(ZoneKind::keep_out, 0, 7.5), "");
    EXPECT_EQ(in_time(ZoneKind::keep_out, 12.5, always), "");
    EXPECT_NE(in_time(ZoneKind::keep_out, 0, 7.6), "");
    EXPECT_NE(in_time(ZoneKind::keep_out, 12.4, always), "");
}

// Who starts in it must have left, and who ends in it stands there for ever, unless it leaves.
TEST(CheckZones, CountsWhoStandsAtItsEnds) {
    Zone zone = square(ZoneKind::keep_out);
    zone.from = 100;
    Mission mission = mission_with(zone);
    const std::vector<Point> inwards{{0, 9}, {10, 9}};
    mission.agents[0].goal = {10, 9};
    EXPECT_NE(fault(mission, inwards, straight), "");
    mission.rules.at_goal = AtGoal::leave;
    EXPECT_EQ(fault(mission, inwards, straight), "");
    mission.rules.zones[0].kind = ZoneKind::no_fly;
    mission.agents[1].goal = {10, 9};
    EXPECT_EQ(fault(mission, straight, inwards), "the air agent flies in zone Z, where nobody may from 100 at 10.00");
    const std::vector<Point> outwards{{10, 9}, {19, 9}};
    mission.agents[1].start = {10, 9};
    mission.agents[1].goal = {19, 9};
    EXPECT_EQ(fault(mission, straight, outwards), "");
    mission.rules.zones[0].from = 1.9;
    EXPECT_NE(fault(mission, straight, outwards), "");
}

TEST(CheckZones, PassesByZonesForOthers) {
    Mission mission = mission_with(square(ZoneKind::no_fly));
    mission.rules.zones[0].agents = {"other"};
    EXPECT_EQ(fault(mission, straight, straight), "");
    mission.rules.zones[0].agents = {"air"};
    EXPECT_NE(fault(mission, straight, straight), "");
}

TEST(CheckZones, KnowsHoles) {
    Zone ring = square(ZoneKind::no_fly, 8);
    ring.polygon.push_back({{10, 10}, {14, 10}, {14, 14}, {10, 14}});
    Mission mission = mission_with(ring);
    mission.agents[1].start = {11, 11};
    mission.agents[1].goal = {13, 13};
    EXPECT_EQ(fault(mission, straight, {{11, 11}, {13, 13}}), "");
    EXPECT_NE(fault(mission, straight, {{11, 11}, {15, 13}, {13, 13}}), "");
}

TEST(CheckZones, FindsRemovedObstaclesThatReachInside) {
    const Map map = Map::from_rows({"......", "..aa..", "......"});
    Mission mission = ground_and_air({0, 0}, {5, 0});
    mission.rules.zones = {{.kind = ZoneKind::keep_out, .polygon = {{{3.2, 1}, {5, 1}, {5, 2}}}}};
    const std::vector<Point> way{{0, 0}, {5, 0}};
    Plan plan = hand_made(driven(way), driven(way), {{.obstacle = ObstacleId{1}, .cells = 2, .at = {2, 0}}});
    const auto is_of_zone = [](const Violation& v) {
        return v.rule == Rule::zone && v.message == "obstacle 1 is removed, and reaches into zone 1";
    };
    EXPECT_EQ(std::ranges::count_if(check(map, mission, plan), is_of_zone), 1);
    mission.rules.zones[0].until = 50;  // before and after, it is of use
    EXPECT_EQ(std::ranges::count_if(check(map, mission, plan), is_of_zone), 0);
    mission.rules.zones[0].until = std::numeric_limits<double>::infinity();
    mission.rules.zones[0].polygon = {{{3.5, 1}, {5, 1}, {5, 2}}};
    EXPECT_EQ(std::ranges::count_if(check(map, mission, plan), is_of_zone), 0);
}

}  // namespace
}  // namespace waybreaker

// Missions with zones, against all plans there are.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "all_plans.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "mission/any_world.hpp"
#include "waybreaker/map_edit.hpp"
#include "waybreaker/planner.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker::zoned {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Zone box(ZoneKind kind, Point least, Point most) {
    return {.kind = kind, .polygon = {{least, {most.x, least.y}, most, {least.x, most.y}}}};
}

// A few small polygons with corners at centres, sides and corners of cells.
std::vector<Zone> small_zones(const Map& map) {
    std::vector<Zone> zones;
    const int count = *number(1, 3);
    for (int i = 0; i < count; ++i) {
        Zone zone{.kind = *rc::gen::element(ZoneKind::no_fly, ZoneKind::no_fly, ZoneKind::keep_out)};
        std::vector<Point>& ring = zone.polygon.emplace_back();
        const int corners = *number(3, 5);
        for (int k = 0; k < corners; ++k)
            ring.emplace_back(*number(-2, 2 * map.width()) / 2.0, *number(-2, 2 * map.height()) / 2.0);
        if (is_valid(zone)) zones.push_back(std::move(zone));
    }
    return zones;
}

std::vector<Zone> of_kind(const Rules& rules, ZoneKind kind) {
    std::vector<Zone> zones;
    for (const Zone& zone : rules.zones) {
        if (zone.kind == kind) zones.push_back(zone);
    }
    return zones;
}

// Whether an interior meets the area of a cell.
bool reaches_into(const std::vector<Zone>& zones, Cell c) {
    return std::ranges::any_of(zones, [c](const Zone& zone) { return area_within(zone.polygon.front(), c) > 1e-9; });
}

// The same without zones to keep out of: the cells that they reach into are closed, the obstacles stay.
World with_closed_ground(const World& world) {
    const std::vector<Zone> closed_to_ground = of_kind(world.mission.rules, ZoneKind::keep_out);
    Mission mission = world.mission;
    mission.rules.zones = of_kind(world.mission.rules, ZoneKind::no_fly);
    std::vector<Cell> closed;
    for (Cell c; c.y < world.map.height(); ++c.y) {
        for (c.x = 0; c.x < world.map.width(); ++c.x) {
            if (!reaches_into(closed_to_ground, c)) continue;
            if (const ObstacleId id = world.map.obstacle_at(c)) {
                mission.rules.protect.push_back(id);
            } else {
                closed.push_back(c);
            }
        }
    }
    std::vector<MapEdit> edits;
    if (!closed.empty()) edits.push_back(MapEdit::add(closed, {.destructible = false}));
    return {world.map.with(edits), std::move(mission)};
}

double best_of_all(const World& world) {
    const auto [map, mission] = with_closed_ground(world);
    const std::vector<Zone> closed_to_air = of_kind(mission.rules, ZoneKind::no_fly);
    const auto width = map.width();
    const auto height = map.height();
    std::map<std::pair<std::pair<double, double>, std::pair<double, double>>, double> known;
    const auto flown = [&](Point a, Point b) {
        const auto [length, is_new] = known.try_emplace({{a.x, a.y}, {b.x, b.y}});
        if (is_new && (slowly_inside(closed_to_air, a) || slowly_inside(closed_to_air, b)))
            length->second = infinity;
        else if (is_new)
            length->second = slow_length(closed_to_air, width, height, a, b);
        return length->second;
    };
    return AllPlans(map, mission, flown).best();
}

std::string text(const Mission& mission) {
    std::ostringstream out;
    for (const Zone& zone : mission.rules.zones) {
        out << to_string(zone.kind) << ":";
        for (const Point p : zone.polygon.front()) out << " " << p.x << "," << p.y;
        out << "\n";
    }
    return out.str();
}

void expect_between_bound_and_plan(const World& world) {
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_LOG() << text(world.mission);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    const double best = best_of_all(world);
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(best == infinity);
        return;
    }
    const double reached = *value(plan.after, world.mission.rules.objective);
    RC_LOG() << "reached " << reached << ", best " << best << ", bound " << *plan.bound << "\n";
    RC_CLASSIFY(plan.after.air().path.size() > plan.breaches.size() + 2, "bent");
    RC_CLASSIFY(!plan.breaches.empty(), "breached");
    RC_ASSERT(*plan.bound <= best * (1 + 1e-9));
    RC_ASSERT(reached >= best * (1 - 1e-6));
}

World any_zoned_world() {
    World world = any_world();
    world.mission.rules.zones = small_zones(world.map);
    return world;
}

RC_GTEST_PROP(ZonedMission, NoPlanIsBelowTheBoundAndNoneBeatsAllPlans, ()) {
    const World world = any_zoned_world();
    RC_PRE(is_plannable(world));
    expect_between_bound_and_plan(world);
}

RC_GTEST_PROP(ZonedMission, TheSameForTwoAircraft, ()) {
    World world = any_zoned_world();
    Agent other = world.mission.agents[1];
    other.id = "other";
    other.speed = *rc::gen::element(0.5, 1.0, 3.0);
    world.mission.agents.push_back(other);
    RC_PRE(is_plannable(world));
    expect_between_bound_and_plan(world);
}

RC_GTEST_PROP(ZonedMission, TeamsKeepOutOfZones, ()) {
    World world = any_zoned_world();
    const std::vector<Cell> free = free_cells(world.map);
    const Cell at = one_of(free);
    const Cell to = one_of(free);
    world.mission.agents.push_back(vehicle("second", at, to));
    RC_PRE(is_plannable(world));
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
}

RC_GTEST_PROP(ZonedMission, EveryMethodKeepsOutOfZones, ()) {
    World world = any_zoned_world();
    RC_PRE(is_plannable(world));
    Method method;
    method.select = *rc::gen::element(Selection::hits, Selection::greedy, Selection::none);
    method.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest);
    if (method.select != Selection::greedy) method.planner = *rc::gen::element(Algorithm::theta, Algorithm::astar);
    if (*rc::gen::arbitrary<bool>()) world.mission.rules.timing = Timing::ignore;
    const Plan plan = Planner().plan(world.map, world.mission, method);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
}

// A zone more leaves no better plan: what is proven without it holds with it.
RC_GTEST_PROP(ZonedMission, ZonesNeverHelp, ()) {
    const World world = any_zoned_world();
    RC_PRE(is_plannable(world));
    Mission free = world.mission;
    free.rules.zones.clear();
    const Plan with = Planner().plan(world.map, world.mission);
    if (with.status != PlanStatus::solved) return;
    const Plan without = Planner().plan(world.map, free);
    RC_ASSERT(without.status == PlanStatus::solved);
    RC_ASSERT(*value(with.after, free.rules.objective) >= *without.bound * (1 - 1e-9));
}

// Where the plan without zones enters none of them, it is as good as the plan with them.
RC_GTEST_PROP(ZonedMission, ZonesThatNobodyTouchesChangeNothing, ()) {
    const World world = any_zoned_world();
    RC_PRE(is_plannable(world));
    Mission free = world.mission;
    free.rules.zones.clear();
    const Plan without = Planner().plan(world.map, free);
    RC_PRE(without.status == PlanStatus::solved && *without.gap < 1e-9);
    const World closed = with_closed_ground(world);  // more than the zones themselves
    RC_PRE(plan_faults(closed.map, closed.mission, without) == "");
    const Plan with = Planner().plan(world.map, world.mission);
    RC_ASSERT(with.status == PlanStatus::solved);
    const double reached = *value(without.after, free.rules.objective);
    RC_ASSERT(*with.bound <= reached * (1 + 1e-9));
    RC_ASSERT(*value(with.after, free.rules.objective) >= reached * (1 - 1e-9));
}

TEST(ZonedMission, FliesRoundAZone) {
    const Map map(Grid(12, 12));
    Mission mission = ground_and_air({0, 6}, {11, 6});
    mission.rules.zones = {box(ZoneKind::no_fly, {3, 5}, {8, 11})};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.after.air().path, (std::vector<Point>{{0, 6}, {3, 5}, {8, 5}, {11, 6}}));
    EXPECT_EQ(plan.before.air().path, plan.after.air().path);
    EXPECT_EQ(plan.after.ground().path, (std::vector<Point>{{0, 6}, {11, 6}}));
    EXPECT_NEAR(*plan.after.makespan, 5 + 2 * std::sqrt(10.0), 1e-9);
    EXPECT_EQ(plan.agents[1].path.size(), 4U);
}

TEST(ZonedMission, DrivesRoundAZone) {
    const Map map(Grid(12, 12));
    Mission mission = ground_and_air({0, 6}, {11, 6});
    mission.rules.zones = {box(ZoneKind::keep_out, {3, 5}, {8, 11})};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_GT(*plan.after.ground().length, 11);
    EXPECT_EQ(plan.after.air().path, (std::vector<Point>{{0, 6}, {11, 6}}));
}

// From the one side that is not in the zone.
TEST(ZonedMission, BreachesFromOutsideAZone) {
    const Map map = Map::from_rows({".....", ".....", "aaaaa", ".....", "....."});
    Mission mission = ground_and_air({2, 0}, {2, 4});
    mission.agents[1].goal = {2, 0};
    mission.rules.zones = {box(ZoneKind::no_fly, {-0.5, 2.5}, {4.5, 4.5})};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].at.y, 1);
    mission.rules.zones.push_back(box(ZoneKind::no_fly, {-0.5, 0.5}, {4.5, 2.5}));
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
    mission.rules.force = {ObstacleId{1}};
    EXPECT_EQ(input_error([&] { validate(map, mission); }),
              "obstacle 1 must be removed, but the zones leave no cell beside it to breach it from");
}

TEST(ZonedMission, LeavesObstaclesThatReachIntoAZone) {
    const Map map = Map::from_rows({".....", "aaaaa", "....."});
    Mission mission = ground_and_air({1, 0}, {1, 2});
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::solved);
    mission.rules.zones = {box(ZoneKind::keep_out, {4, 1}, {6, 3})};
    EXPECT_EQ(Planner().plan(map, mission).status, PlanStatus::no_plan);
    mission.rules.force = {ObstacleId{1}};
    mission.rules.zones[0].name = "school yard";
    EXPECT_EQ(
        input_error([&] { validate(map, mission); }),
        "obstacle 1, which must be removed, reaches into the zone 'school yard', which vehicles keep out of; leave "
        "one of them out");
}

std::string fault_of(const Mission& mission) {
    const Map map(Grid(12, 12));
    return input_error([&] { validate(map, mission); });
}

TEST(ZonedMission, IsRefusedWhereAnAgentStartsOrEndsInAZone) {
    Mission mission = ground_and_air({1, 1}, {10, 10});
    mission.rules.zones = {box(ZoneKind::no_fly, {0, 0}, {2, 2})};
    mission.rules.zones[0].name = "airport";
    EXPECT_EQ(fault_of(mission),
              "the air agent's start 1,1 lies in the zone 'airport'; move it, or leave the zone out");
    mission.rules.zones[0] = box(ZoneKind::no_fly, {9, 9}, {12, 12});
    EXPECT_EQ(fault_of(mission), "the air agent's goal 10,10 lies in zone 1; move it, or leave the zone out");
    mission.rules.zones[0] = box(ZoneKind::no_fly, {1, 1}, {3, 3});  // on its outline
    EXPECT_EQ(fault_of(mission), "");
    mission.rules.zones[0] = box(ZoneKind::keep_out, {1, 1}, {3, 3});
    EXPECT_EQ(fault_of(mission), "the ground agent's start 1,1 lies in zone 1; move it, or leave the zone out");
    mission.rules.zones[0] = box(ZoneKind::keep_out, {1.5, 1}, {3, 3});
    EXPECT_EQ(fault_of(mission), "");
    mission.agents[0].body.radius = 0.6;
    EXPECT_EQ(fault_of(mission), "the ground agent's start 1,1 lies in zone 1; move it, or leave the zone out");
}

TEST(ZonedMission, IsRefusedWhereThereIsNoWayToFly) {
    Mission mission = ground_and_air({1, 1}, {10, 10});
    mission.rules.zones = {box(ZoneKind::no_fly, {5, -3}, {6, 20})};
    EXPECT_EQ(fault_of(mission),
              "the zones leave no way to fly from the air agent's start 1,1 to its goal 10,10; leave one of them out");
}

TEST(ZonedMission, IsRefusedWhereAZoneIsForSomeOnly) {
    Mission mission = ground_and_air({1, 1}, {10, 10});
    mission.rules.zones = {box(ZoneKind::no_fly, {5, 5}, {6, 6})};
    mission.rules.zones[0].agents = {"air"};
    EXPECT_EQ(fault_of(mission), "");
    mission.agents.push_back(aircraft("other", {1, 1}));
    EXPECT_EQ(
        fault_of(mission),
        "zone 1 is for some of the aircraft only, and not for 'other': such zones cannot be planned with yet; leave "
        "out 'agents', or name all of them");
    mission.rules.zones[0].agents = {"air", "other"};
    EXPECT_EQ(fault_of(mission), "");
    mission.rules.zones[0].agents = {"nobody"};
    EXPECT_EQ(fault_of(mission), "zone 1 is for the agent 'nobody', which the mission has not");
    mission.rules.zones[0].agents = {"ground"};
    EXPECT_EQ(fault_of(mission), "zone 1 is one not to fly in, but the agent 'ground' drives");
}

}  // namespace
}  // namespace waybreaker::zoned

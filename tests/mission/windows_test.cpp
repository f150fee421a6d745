// Missions with zones that hold for a time.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checked_plan.hpp"
#include "input_error.hpp"
#include "mission/any_windowed_world.hpp"
#include "waybreaker/planner.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker::windowed {
namespace {

Zone box(ZoneKind kind, Point least, Point most, double from = 0, double until = infinity) {
    return {
        .kind = kind, .polygon = {{least, {most.x, least.y}, most, {least.x, most.y}}}, .from = from, .until = until};
}

Mission without_windows(Mission mission) {
    std::erase_if(mission.rules.zones, &Zone::has_window);
    return mission;
}

Mission without_times(Mission mission) {
    for (Zone& zone : mission.rules.zones) {
        zone.from = 0;
        zone.until = infinity;
    }
    return mission;
}

Mission team_of(const World& world, bool more_aircraft) {
    Mission mission = world.mission;
    const std::vector<Cell> free = free_cells(world.map);
    const Cell at = one_of(free);
    const Cell to = one_of(free);
    mission.agents.push_back(vehicle("second", at, to));
    mission.rules.at_goal = *rc::gen::element(AtGoal::stay, AtGoal::leave);
    if (!more_aircraft) return mission;
    Agent other = mission.agents[1];
    other.id = "other";
    other.speed = *rc::gen::element(0.5, 1.0, 3.0);
    mission.agents.push_back(other);
    return mission;
}

void give_batteries(Mission& mission) {
    for (Agent& agent : mission.agents) {
        if (agent.kind != AgentKind::air) continue;
        agent.range = *rc::gen::element(5.0, 9.0, 16.0);
        if (*rc::gen::arbitrary<bool>()) agent.recharge = 2;
    }
}

void expect_legal(const Map& map, const Mission& mission) {
    RC_LOG() << text(mission);
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (mission.rules.force.empty()) {
        Mission nothing = mission;
        nothing.rules.removals = 0;
        RC_ASSERT(reached(plan, mission) <= reached(Planner().plan(map, nothing), mission) * (1 + 1e-9));
    }
    const Plan free = Planner().plan(map, without_windows(mission));
    RC_CLASSIFY(plan.status != PlanStatus::solved, "no plan");
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(free.status != PlanStatus::solved || plan.barred_by.has_value());
        return;
    }
    RC_ASSERT(free.status == PlanStatus::solved);
    RC_CLASSIFY(reached(plan, mission) > reached(free, mission) + 1e-6, "later for a zone");
    RC_CLASSIFY(plan_faults(map, mission, free) != "", "in a zone without times");
    if (free.bound) RC_ASSERT(reached(plan, mission) >= *free.bound * (1 - 1e-9));
    RC_ASSERT(plan.bound.has_value() == free.bound.has_value());
    if (free.bound) RC_ASSERT(*plan.bound >= *free.bound * (1 - 1e-9));
}

RC_GTEST_PROP(WindowedMission, PlansOfAPairAreLegalAndZonesNeverHelp, ()) {
    World world = any_windowed_world();
    if (*rc::gen::arbitrary<bool>()) give_batteries(world.mission);
    RC_PRE(is_plannable(world));
    expect_legal(world.map, world.mission);
}

RC_GTEST_PROP(WindowedMission, PlansOfATeamAreLegalAndZonesNeverHelp, ()) {
    World world = any_windowed_world();
    world.mission = team_of(world, *rc::gen::arbitrary<bool>());
    if (*rc::gen::arbitrary<bool>()) give_batteries(world.mission);
    RC_PRE(is_plannable(world));
    expect_legal(world.map, world.mission);
}

RC_GTEST_PROP(WindowedMission, EveryMethodKeepsOutOfZones, ()) {
    World world = any_windowed_world();
    if (*rc::gen::arbitrary<bool>()) world.mission.agents[0].body = point_body;
    RC_PRE(is_plannable(world));
    Method method;
    method.select = *rc::gen::element(Selection::exact, Selection::hits, Selection::greedy, Selection::none);
    method.explain = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) world.mission.rules.timing = Timing::ignore;
    RC_LOG() << text(world.mission);
    for (const Plan& plan : Planner().front(world.map, world.mission, method))
        RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    for (const Plan& plan : Planner().alternatives(world.map, world.mission, 0.5, method))
        RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
}

RC_GTEST_PROP(WindowedMission, VehiclesThatClearKeepOutOfZones, ()) {
    World world = any_windowed_world();
    world.mission.agents[0].own_breaches = 1;
    RC_PRE(is_plannable(world));
    RC_LOG() << text(world.mission);
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
}

RC_GTEST_PROP(WindowedMission, IsNoWorseThanWhereZonesHoldAllTheTime, ()) {
    World world = any_windowed_world();
    RC_PRE(is_plannable(world));
    const Mission closed = without_times(world.mission);
    RC_PRE(is_plannable({world.map, closed}));
    const Plan always = Planner().plan(world.map, closed);
    RC_PRE(always.status == PlanStatus::solved);
    RC_LOG() << text(world.mission);
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_ASSERT(plan.status == PlanStatus::solved);
    // Neither is proven to be the best where there is a gap.
    RC_ASSERT(reached(plan, closed) <= reached(always, closed) * (1 + always.gap.value_or(0) + 1e-9));
}

bool are_same(const Plan& a, const Plan& b) {
    const auto same_paths = [](const Itinerary& x, const Itinerary& y) { return x.path == y.path; };
    return a.status == b.status && a.bound == b.bound && a.gap == b.gap && a.limit_reached == b.limit_reached &&
           a.before.makespan == b.before.makespan && a.after.flowtime == b.after.flowtime &&
           std::ranges::equal(a.agents, b.agents, same_paths) &&
           std::ranges::equal(a.breaches, b.breaches, {}, &Breach::cleared_at, &Breach::cleared_at);
}

RC_GTEST_PROP(WindowedMission, ZonesBeforeAndAfterEverybodyChangeNothing, ()) {
    World world = any_world();
    world.mission.agents[0].ready_at = world.mission.agents[1].ready_at = 5;
    const Plan free = Planner().plan(world.map, world.mission);
    RC_PRE(free.status == PlanStatus::solved);
    for (Zone zone : small_zones(world.map)) {
        zone.from = *rc::gen::element(0.0, *free.after.makespan + 0.001);
        zone.until = zone.from == 0 ? 4 : infinity;
        // With a cell to spare on every side.
        const auto is_near = [&](const Agent& agent) {
            const Cell at = zone.from == 0 ? agent.start : agent.goal;
            for (Cell c{at.x - 1, at.y - 1}; c.y <= at.y + 1; ++c.y) {
                for (c.x = at.x - 1; c.x <= at.x + 1; ++c.x) {
                    if (area_within(zone.polygon.front(), c) > 0) return true;
                }
            }
            return false;
        };
        if (std::ranges::none_of(world.mission.agents, is_near)) world.mission.rules.zones.push_back(std::move(zone));
    }
    RC_PRE(!world.mission.rules.zones.empty());
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_ASSERT(are_same(plan, free));
}

// A flight by the clock: whether it is in the zone at any of many moments while that holds, or stands in it at its end.
// `deep`: by more than rounding.
bool is_met(const Zone& zone, const std::vector<Waypoint>& path, bool deep = false) {
    constexpr double step = 1.0 / 512;
    const Waypoint& end = path.back();
    if (slowly_inside(zone, {end.x, end.y}) && zone.until > end.t) return true;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        for (double t = a.t; t < b.t; t += step) {
            const double share = (t - a.t) / (b.t - a.t);
            const Point p(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
            const bool is_in = slowly_inside(zone, p) && (!deep || (slowly_inside(zone, {p.x + 0.003, p.y + 0.002}) &&
                                                                    slowly_inside(zone, {p.x - 0.003, p.y - 0.002})));
            if (is_in && zone.from + 1e-6 < t && t < zone.until - 1e-6) return true;
        }
    }
    return false;
}

std::vector<Waypoint> flight(Point from, Point to, double ready) {
    return {{from.x, from.y, 0}, {from.x, from.y, ready}, {to.x, to.y, ready + distance(from, to)}};
}

// Against the ways to fly past one zone: at once, round it, or into it as soon as it is over.
RC_GTEST_PROP(WindowedMission, OneFlightIsAsGoodAsTheBestOfRoundAndInto, ()) {
    constexpr int size = 9;
    const Map map(Grid(size, size));
    Zone zone = any_zone(size);
    zone.from = *rc::gen::element(0.0, 1.5, 4.0, 7.0);
    zone.until = *rc::gen::element(infinity, zone.from + 1, zone.from + 4);
    RC_PRE(zone.has_window() && is_valid(zone));
    const Cell start{*number(0, size - 1), *number(0, size - 1)};
    const Cell goal{*number(0, size - 1), *number(0, size - 1)};
    Mission mission = ground_and_air(start, goal);
    mission.agents[0].speed = 100;
    mission.rules.zones = {zone};
    RC_PRE(is_plannable({map, mission}));
    const double straight = distance(start, goal);
    double best = is_met(zone, flight(start, goal, 0)) ? infinity : straight;
    // In the zone when that is over.
    for (const Point at : outline(zone, size)) {
        if (slowly_inside(zone, start)) break;
        const double comes_at = slow_length({zone}, size, size, start, at);
        best = std::min(best, std::max(comes_at, zone.until) + distance(at, goal));
    }
    const bool may_go_round = !slowly_inside(zone, start) && !slowly_inside(zone, goal);
    if (may_go_round) best = std::min(best, slow_length({zone}, size, size, start, goal));
    for (double ready = 0; ready < 30 && ready + straight < best; ready += 1.0 / 64) {
        if (!is_met(zone, flight(start, goal, ready))) best = ready + straight;
    }
    const Plan plan = Planner().plan(map, mission);
    RC_LOG() << text(mission) << start.x << "," << start.y << " to " << goal.x << "," << goal.y << ", best " << best;
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_CLASSIFY(best > straight + 1.0 / 32, "not at once");
    RC_CLASSIFY(plan.status != PlanStatus::solved, "no plan");
    if (plan.status != PlanStatus::solved) {
        // Moments may miss a short stay in a zone: not in one that holds for a little longer.
        Zone longer = zone;
        longer.from = std::max(zone.from - 0.1, 0.0);
        longer.until = zone.until + 0.1;
        for (double ready = 0; ready < 30; ready += 1.0 / 64) RC_ASSERT(is_met(longer, flight(start, goal, ready)));
        return;
    }
    const std::vector<Waypoint>& path = plan.agents[1].path;
    RC_ASSERT(!is_met(zone, path, true));
    // Moments are so far apart.
    RC_ASSERT(path.back().t <= best + 1.0 / 64);
    RC_ASSERT(path.back().t >= best - 1.0 / 32);
    RC_ASSERT(*plan.bound <= best + 1e-9);
}

using Path = std::vector<Waypoint>;

// From 3 to 8 on its way of 11.
Mission past_a_box(ZoneKind kind, double from, double until) {
    Mission mission = ground_and_air({0, 6}, {11, 6});
    mission.rules.zones = {box(kind, {3, 5}, {8, 11}, from, until)};
    return mission;
}

TEST(WindowedMission, FliesOnWhereTheZoneIsOverOrHasNotBegun) {
    const Map map(Grid(12, 12));
    for (const auto& [from, until] : {std::pair(0.0, 3.0), std::pair(8.0, infinity), std::pair(8.0, 9.0)}) {
        const Mission mission = past_a_box(ZoneKind::no_fly, from, until);
        const Plan plan = Planner().plan(map, mission);
        ASSERT_TRUE(is_valid(map, mission, plan));
        EXPECT_EQ(plan.agents[1].path, (Path{{0, 6, 0}, {11, 6, 11}}));
        EXPECT_DOUBLE_EQ(*plan.gap, 0);
    }
}

// Along its side while it holds, and then in.
TEST(WindowedMission, MayFlyAlongAZone) {
    const Map map(Grid(12, 12));
    Mission mission = ground_and_air({7, 0}, {7, 4});
    mission.rules.zones = {{.polygon = {{{9, 4}, {9, 5}, {5, 7}, {7, 3}, {7, -1}, {9, 3}}}, .from = 1.5, .until = 2.5}};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.agents[1].path, (Path{{7, 0, 0}, {7, 4, 4}}));
}

TEST(WindowedMission, WaitsOrFliesRound) {
    const Map map(Grid(12, 12));
    Mission soon_over = past_a_box(ZoneKind::no_fly, 1, 3.25);
    soon_over.rules.zones[0] = box(ZoneKind::no_fly, {3, -1}, {8, 12}, 1, 3.25);
    const Plan later = Planner().plan(map, soon_over);
    ASSERT_TRUE(is_valid(map, soon_over, later));
    EXPECT_EQ(later.agents[1].path, (Path{{0, 6, 0}, {0, 6, 0.25}, {11, 6, 11.25}}));
    EXPECT_NEAR(*later.bound, 11.25, 1e-9);
    EXPECT_DOUBLE_EQ(*later.before.makespan, 11);
    const Mission lasting = past_a_box(ZoneKind::no_fly, 1, 9.5);
    const Plan round = Planner().plan(map, lasting);
    ASSERT_TRUE(is_valid(map, lasting, round));
    EXPECT_EQ(round.after.air().path, (std::vector<Point>{{0, 6}, {3, 5}, {8, 5}, {11, 6}}));
    EXPECT_DOUBLE_EQ(*round.gap, 0);
    // It begins while the aircraft would be in it.
    const Mission begins = past_a_box(ZoneKind::no_fly, 7.9, infinity);
    EXPECT_EQ(Planner().plan(map, begins).after.air().path, round.after.air().path);
}

TEST(WindowedMission, AVehicleSaysWhatItWaitsFor) {
    const Map map(Grid(12, 7));
    Mission mission = past_a_box(ZoneKind::keep_out, 1, 4);
    mission.rules.zones[0] = box(ZoneKind::keep_out, {3, -1}, {8, 11}, 1, 4);
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    // Its disc, half a cell wide, is at the cells of the zone after 2 cells.
    const std::vector<Wait>& waits = plan.agents[0].waits;
    ASSERT_EQ(waits.size(), 1U);
    EXPECT_EQ(waits[0].at, Point(0, 6));
    EXPECT_EQ(waits[0].reason, WaitReason::zone);
    EXPECT_EQ(waits[0].zone, 1U);
    EXPECT_NEAR(waits[0].until, 2, 1e-3);
    EXPECT_NEAR(*plan.after.makespan, 13, 1e-3);
}

TEST(WindowedMission, RemovesWhatReachesIntoAZoneThatIsOver) {
    const Map map = Map::from_rows({".....", "aaaaa", "....."});
    Mission mission = ground_and_air({1, 0}, {1, 2});
    mission.rules.breach_time.per_obstacle = 5;
    mission.rules.zones = {box(ZoneKind::keep_out, {4, 1}, {6, 3}, 0, 3)};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.breaches.size(), 1U);
}

TEST(WindowedMission, MayStartAndEndInAZoneThatDoesNotHoldThen) {
    const Map map(Grid(12, 12));
    for (const ZoneKind kind : {ZoneKind::no_fly, ZoneKind::keep_out}) {
        Mission mission = ground_and_air({1, 1}, {10, 10});
        mission.rules.zones = {box(kind, {0, 0}, {2, 2}, 3.5), box(kind, {9, 9}, {12, 12}, 0, 20)};
        mission.rules.zones[1].name = "market";
        const Plan plan = Planner().plan(map, mission);
        EXPECT_TRUE(is_valid(map, mission, plan));
        // Who sets out late enough for the one is still in the other.
        EXPECT_EQ(plan.status, PlanStatus::not_found);
        ASSERT_TRUE(plan.barred_by);
        EXPECT_EQ(plan.barred_by->zone, 2U);
        EXPECT_EQ(plan.barred_by->agent, kind == ZoneKind::no_fly ? "air" : "ground");
        EXPECT_NEAR(plan.barred_by->at, kind == ZoneKind::no_fly ? 8 * std::sqrt(2.0) : 10.107, 1e-3);
        mission.rules.zones[1].until = kind == ZoneKind::no_fly ? 12.5 : 10.5;
        const Plan later = Planner().plan(map, mission);
        ASSERT_TRUE(is_valid(map, mission, later));
        EXPECT_NEAR(*later.after.makespan, kind == ZoneKind::no_fly ? 13.5 : 9 * std::sqrt(2.0) + 0.393, 2e-3);
    }
}

TEST(WindowedMission, IsRefusedWhereAnAgentMustBeInAZoneThatHolds) {
    const Map map(Grid(12, 12));
    const auto fault = [&](const Mission& mission) { return input_error([&] { validate(map, mission); }); };
    Mission mission = ground_and_air({1, 1}, {10, 10});
    mission.rules.zones = {box(ZoneKind::no_fly, {0, 0}, {2, 2}, 0, 5)};
    EXPECT_EQ(fault(mission), "the air agent's start 1,1 lies in zone 1 (until 5); move it, or leave the zone out");
    mission.rules.zones[0].from = 2;
    EXPECT_EQ(fault(mission), "");
    mission.agents[1].ready_at = 2;
    EXPECT_EQ(fault(mission),
              "the air agent's start 1,1 lies in zone 1 (from 2 until 5); move it, or leave the zone out");
    mission.rules.zones[0] = box(ZoneKind::keep_out, {9, 9}, {12, 12}, 7);
    EXPECT_EQ(fault(mission), "the ground agent's goal 10,10 lies in zone 1 (from 7); move it, or leave the zone out");
    mission.rules.zones[0].until = 8;
    EXPECT_EQ(fault(mission), "");
}

// Without the zone a vehicle that clears states no bound here; that of the mission with it is none.
TEST(WindowedMission, StatesNoBoundOfAnotherMission) {
    const Map map = Map::from_rows({"..a...", "......", "......", "......"});
    Mission mission = ground_and_air({5, 0}, {5, 0});
    mission.agents[0].own_breaches = 1;
    mission.agents[1].start = {0, 0};
    mission.agents[1].goal = {0, 3};
    mission.rules.zones = {box(ZoneKind::no_fly, {-1, 2}, {1, 4}, 9.5, 12.5)};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_NEAR(plan.agents[1].path.back().t, 13.5, 1e-9);
    Mission free = mission;
    free.rules.zones.clear();
    EXPECT_EQ(plan.bound, Planner().plan(map, free).bound);
}

TEST(WindowedMission, AlternativesKeepOutOfZonesToo) {
    const Map map(Grid(12, 12));
    const Mission mission = past_a_box(ZoneKind::no_fly, 1, 3.25);
    for (const Plan& plan : Planner().alternatives(map, mission, 1)) EXPECT_TRUE(is_valid(map, mission, plan));
}

}  // namespace
}  // namespace waybreaker::windowed

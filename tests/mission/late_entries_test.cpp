// Aircraft that fly into zones when these are over, and what is proven of all that might.
#include "mission/late_entries.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "checked_plan.hpp"
#include "mission/any_windowed_world.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::windowed {
namespace {

Zone square(Point least, Point most, double from, double until) {
    return {.polygon = {{least, {most.x, least.y}, most, {least.x, most.y}}}, .from = from, .until = until};
}

RC_GTEST_PROP(LateEntry, IsNoLaterThanAnyOther, ()) {
    constexpr int size = 9;
    const Map map(Grid(size, size));
    std::vector<Zone> zones{any_zone(size)};
    if (*rc::gen::arbitrary<bool>()) zones.push_back(any_zone(size));
    RC_PRE(std::ranges::all_of(zones, [](const Zone& zone) { return is_valid(zone); }));
    zones[0].until = *number(0, 40) / 2.0;
    Agent air = aircraft("air", {*number(0, size - 1), *number(0, size - 1)});
    air.speed = *rc::gen::element(0.5, 1.0, 3.0);
    air.ready_at = *number(0, 3);
    air.airspace = Airspace(zones, size, size);
    const Point start(air.start);
    const Point place(*number(0, size - 1), *number(0, size - 1));
    RC_PRE(!slowly_inside(zones, start));
    const double least = least_arrival_past(map, air, zones, zones[0], place);
    const auto entry = earliest_entry(map, air, zones, zones[0], place);
    double best = infinity;
    for (const Point at : outline(zones[0], size)) {
        if (slowly_inside(zones, at)) continue;
        const double comes_at = air.ready_at + slow_length(zones, size, size, start, at) / air.speed;
        best = std::min(best, std::max(comes_at, zones[0].until) + distance(at, place) / air.speed);
    }
    RC_CLASSIFY(best == infinity, "no entry");
    RC_ASSERT(least <= best + 1e-9);
    if (!entry) return;
    Mission shown;
    shown.rules.zones = zones;
    RC_LOG() << text(shown) << start.x << "," << start.y << " to " << entry->at.x << "," << entry->at.y;
    RC_ASSERT(slow_length(zones, size, size, start, entry->at) / air.speed <= entry->enters_at - air.ready_at + 1e-2);
    RC_ASSERT(entry->arrival >= least - 1e-9);
    // Sides have so many places.
    RC_CLASSIFY(entry->arrival <= best + 1e-9, "the best");
}

bool is_legal(const Map& map, const Mission& mission, const Plan& plan) {
    if (plan.status != PlanStatus::solved) return false;
    return std::ranges::none_of(check(map, mission, plan), [](const Violation& v) { return v.rule == Rule::zone; });
}

// As if the aircraft were told to be somewhere first.
Mission by_way_of(Mission mission, Cell at) {
    Agent& air = mission.agents[std::size_t(*number(1, int(mission.agents.size()) - 1))];
    const double comes_at = air.ready_at + distance(air.start, at) / air.speed;
    const double leaves_at = comes_at + *rc::gen::element(0.0, 0.3, 1.0, 4.0);
    const Point start(air.start);
    const Point there(at);
    air.approach = {{start.x, start.y, 0}, {start.x, start.y, air.ready_at}, {there.x, there.y, comes_at}};
    if (leaves_at > comes_at) air.approach.push_back({there.x, there.y, leaves_at});
    air.start = at;
    air.ready_at = leaves_at;
    return mission;
}

RC_GTEST_PROP(LateEntry, NoPlanIsBelowTheBound, ()) {
    constexpr int others = 30;
    World world = any_windowed_world();
    for (Zone& zone : world.mission.rules.zones) zone.kind = ZoneKind::no_fly;
    if (*rc::gen::arbitrary<bool>()) world.mission.rules.breach_time.per_obstacle = *rc::gen::element(1.0, 4.0);
    world.mission.rules.objective = Objective::makespan;
    if (*rc::gen::arbitrary<bool>()) {
        Agent other = world.mission.agents[1];
        other.id = "other";
        if (*rc::gen::arbitrary<bool>()) other.breaches = 0;
        world.mission.agents.push_back(other);
    }
    RC_PRE(is_plannable(world));
    RC_LOG() << text(world.mission);
    const Plan plan = Planner().plan(world.map, world.mission);
    RC_PRE(plan.bound.has_value());
    Mission free = world.mission;
    std::erase_if(free.rules.zones, &Zone::has_window);
    const Plan relaxed = Planner().plan(world.map, free);
    RC_CLASSIFY(*plan.bound > *relaxed.bound + 1e-6, "above that without zones");
    for (int i = 0; i < others; ++i) {
        const Cell at{*number(0, world.map.width() - 1), *number(0, world.map.height() - 1)};
        const Mission other = by_way_of(free, at);
        if (!is_plannable({world.map, other})) continue;
        const Plan flown = Planner().plan(world.map, other);
        if (!is_legal(world.map, world.mission, flown)) continue;
        RC_LOG() << "by way of " << at.x << "," << at.y << ": " << reached(flown, other) << "\n";
        RC_ASSERT(*plan.bound <= reached(flown, other) * (1 + 1e-9));
    }
}

// Round the corner of the zone it is there when that is over; straight on it would be too soon, round it too late.
TEST(LateEntry, IsWhereItIsBest) {
    const Map map(Grid(40, 40));
    Mission mission = ground_and_air({0, 20}, {39, 20});
    mission.agents[0].speed = 100;
    mission.rules.zones = {square({10, 15}, {30, 40}, 0, 20)};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    const double straight = 39;
    const double round = 2 * std::hypot(10, 5) + 20 - 1;
    EXPECT_GT(*plan.after.makespan, straight + 1);
    EXPECT_LT(*plan.after.makespan, round - 0.5);
    EXPECT_NEAR(*plan.gap, 0, 1e-3);
    EXPECT_EQ(plan.agents[1].path.size(), 5U);
}

// The best entry is the corner at which it waits for nothing.
TEST(LateEntry, OfAClosedGoalIsProven) {
    const Map map(Grid(20, 20));
    Mission mission = ground_and_air({0, 10}, {15, 10});
    mission.rules.zones = {square({12, 5}, {18, 15}, 0, 30)};
    const Plan plan = Planner().plan(map, mission);
    ASSERT_TRUE(is_valid(map, mission, plan));
    EXPECT_NEAR(*plan.after.makespan, 33, 1e-2);
    EXPECT_NEAR(*plan.bound, 33, 1e-9);
}

// One under way hovers where it is.
TEST(LateEntry, OfAnAircraftInTheAir) {
    const Map map(Grid(20, 20));
    Mission mission = ground_and_air({0, 10}, {15, 10});
    mission.agents[1].ready_at = 2;
    mission.agents[1].approach = {{0, 8, 0}, {0, 10, 2}};
    mission.rules.zones = {square({12, 5}, {18, 15}, 0, 30)};
    for (const double range : {infinity, 40.0}) {
        mission.agents[1].range = range;
        const Plan plan = Planner().plan(map, mission);
        ASSERT_TRUE(is_valid(map, mission, plan));
        EXPECT_NEAR(*plan.after.makespan, 33, 1e-2);
    }
}

}  // namespace
}  // namespace waybreaker::windowed

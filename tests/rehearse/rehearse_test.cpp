// Rehearsals of random missions: nobody ever meets anybody, nor what stands. A thousand runs; a hundred thousand with
// RC_PARAMS=max_success=10000.
#include "waybreaker/rehearse.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "live/underway.hpp"
#include "rehearse/script.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

using Rehearsable = Underway;

Rehearsable any_rehearsable(int side, int most_vehicles, bool zoned = false, bool batteries = false) {
    return any_planned(side, most_vehicles, 2, zoned, batteries, Left::perhaps_rubble);
}

RehearsalOptions any_options() {
    RehearsalOptions options;
    options.fail = *rc::gen::element(0.0, 0.3, 0.7, 1.0);
    options.delay = {*rc::gen::element(DelayKind::fixed, DelayKind::exponential, DelayKind::poisson),
                     *rc::gen::element(0.0, 0.5, 2.0)};
    options.blocked = *rc::gen::element(0.0, 0.5, 1.0);
    options.sight = *rc::gen::element(3.0, 5.0);
    options.lost = *rc::gen::element(0.0, 0.3, 1.0);
    options.seed = *rc::gen::arbitrary<std::uint64_t>();
    options.runs = 10;
    options.threads = 1;
    return options;
}

std::string faults(const Rehearsal& rehearsal) {
    std::string faults;
    for (const Rehearsed& run : rehearsal.runs) {
        if (run.illegal > 0) faults += run.fault + "\n";
        if (run.ending == Ending::stuck) faults += "stuck\n";
    }
    return faults;
}

// How much later than planned an execution may be for that vehicles which touch while both move go step by step.
double steps(const Rehearsable& drawn) {
    double later = 0;
    for (const Order& order : drawn.plan.orders) later -= std::min(order.slack, 0.0);
    // Before two obstacles at once, it stands for one after the other, however long it has waited for the first.
    later += drawn.mission.rules.rubble * double(drawn.plan.breaches.size());
    return later;
}

RC_GTEST_PROP(Rehearse, WithoutDrawsIsNoLaterThanPlanned, (bool zoned)) {
    const Rehearsable drawn = any_rehearsable(14, 3, zoned);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    const double later = 1e-6 + steps(drawn);
    RC_ASSERT(rehearsal.makespan.worst <= rehearsal.planned * (1 + 1e-9) + later);
    RC_ASSERT(rehearsal.ground_makespan.worst <= rehearsal.ground_planned * (1 + 1e-9) + later);
}

void expect_legal(const Rehearsable& drawn) {
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, any_options());
    int revised = 0;
    for (const Rehearsed& run : rehearsal.runs) revised += run.revisions > 0 ? 1 : 0;
    RC_CLASSIFY(rehearsal.arrived == int(rehearsal.runs.size()), "all arrive");
    RC_CLASSIFY(rehearsal.arrived == 0, "none arrives");
    RC_CLASSIFY(revised > 0, "some are revised");
    RC_ASSERT(faults(rehearsal) == "");
}

RC_GTEST_PROP(Rehearse, NoRunIsIllegal, ()) {
    expect_legal(any_rehearsable(14, 3));
}

RC_GTEST_PROP(Rehearse, NoRunIsIllegalWhereThereAreZones, ()) {
    expect_legal(any_rehearsable(14, 3, true));
}

RC_GTEST_PROP(Rehearse, NoRunIsIllegalWhereZonesHaveTimes, ()) {
    expect_legal(any_windowed_underway(14));
}

RC_GTEST_PROP(Rehearse, WhereZonesHaveTimesNobodyIsLateWithoutDraws, ()) {
    Rehearsable drawn = any_windowed_underway(14);
    RC_PRE(drawn.mission.rules.rubble == 0);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    if (steps(drawn) == 0) RC_ASSERT(rehearsal.caught == 0);
    const double later = 1e-6 + steps(drawn);
    RC_ASSERT(rehearsal.makespan.worst <= rehearsal.planned * (1 + 1e-9) + later);
}

RC_GTEST_PROP(Rehearse, NoRunIsIllegalWhereBatteriesEnd, ()) {
    expect_legal(any_rehearsable(14, 3, *rc::gen::arbitrary<bool>(), true));
}

// The plan brings all home with their reserves.
RC_GTEST_PROP(Rehearse, NoBatteryIsEmptyWithoutDraws, ()) {
    const Rehearsable drawn = any_rehearsable(14, 3, false, true);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(rehearsal.on_reserve == 0);
    RC_ASSERT(rehearsal.emptied == 0);
    RC_ASSERT(rehearsal.arrived == 1);
}

RC_GTEST_PROP(Rehearse, NoRunOfAnAgentThatOpensItsOwnWayIsIllegal, ()) {
    expect_legal(any_own_way(14, 2, Left::perhaps_rubble));
}

RC_GTEST_PROP(Rehearse, NoRunOfAVehicleThatClearsIsIllegal, ()) {
    expect_legal(any_clearing(12, 1, Left::perhaps_rubble));
}

RC_GTEST_PROP(Rehearse, OfAVehicleThatClearsIsNoLaterThanPlannedWithoutDraws, ()) {
    const Rehearsable drawn = any_clearing(12, 1, Left::perhaps_rubble);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    RC_ASSERT(rehearsal.makespan.worst <= rehearsal.planned * (1 + 1e-9) + 1e-6 + steps(drawn));
}

RC_GTEST_PROP(Rehearse, OfAnAgentThatOpensItsOwnWayIsAsPlannedWithoutDraws, ()) {
    const Rehearsable drawn = any_own_way(14, 2, Left::perhaps_rubble);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    RC_ASSERT(std::abs(rehearsal.makespan.worst - rehearsal.planned) <= 1e-6 * (1 + rehearsal.planned));
}

RC_GTEST_PROP(Rehearse, NoRunToManyPlacesIsIllegal, ()) {
    expect_legal(any_places(12, 2));
}

RC_GTEST_PROP(Rehearse, ManyPlacesAreReachedAsPlannedWithoutDraws, ()) {
    const Rehearsable drawn = any_places(12, 2);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    RC_ASSERT(rehearsal.arrived == 1);
    RC_CLASSIFY(rehearsal.unreached_planned > 0, "not all are reached");
    RC_ASSERT(rehearsal.unreached == rehearsal.unreached_planned);
    const double later = 1e-6 + drawn.mission.rules.rubble * double(drawn.plan.breaches.size());
    double weight = 0;
    for (const Agent& agent : drawn.mission.agents) weight += agent.weight;
    RC_ASSERT(rehearsal.flowtime.mean <= rehearsal.flowtime_planned * (1 + 1e-9) + later * weight);
}

// As after a breach that has failed when the aircraft was about to leave.
TEST(Rehearse, AnAircraftBreachesFromBesideTheCentreOfItsCell) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    const Mission mission = ground_and_air({0, 1}, {4, 1});
    Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    for (Itinerary& agent : plan.agents) {
        if (agent.kind == AgentKind::ground) continue;
        for (Waypoint& point : agent.path) point.x += 1e-10;
    }
    int planned = 0;
    for (const rehearsal::Script& script : rehearsal::scripts_of(map, mission, plan, {})) {
        for (const rehearsal::Stop& stop : script) planned += int(stop.breaches.size());
    }
    EXPECT_EQ(planned, 1);
}

RC_GTEST_PROP(Rehearse, RunsAreTheSameWhateverTheThreadsAndTheirNumber, ()) {
    const Rehearsable drawn = any_rehearsable(10, 2);
    RehearsalOptions options = any_options();
    const Rehearsal one = rehearse(drawn.map, drawn.mission, drawn.plan, options);
    options.threads = 3;
    options.runs = 4;
    const Rehearsal other = rehearse(drawn.map, drawn.mission, drawn.plan, options);
    RC_ASSERT(std::equal(other.runs.begin(), other.runs.end(), one.runs.begin()));
}

// Once every breach has failed, all that is left is the way without them, begun late.
RC_GTEST_PROP(Rehearse, WhereAllBreachesFailTheWayWithoutThemIsLeft, ()) {
    Rehearsable drawn = any_rehearsable(14, 1);
    drawn.mission.rules.retries = 0;
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    Mission without = drawn.mission;
    without.rules.removals = 0;
    const Plan plan = Planner().plan(drawn.map, without);
    const Rehearsal rehearsal = rehearse(drawn.map, drawn.mission, drawn.plan, {.fail = 1, .runs = 1, .threads = 1});
    RC_ASSERT(faults(rehearsal) == "");
    const Rehearsed& run = rehearsal.runs.front();
    if (plan.status != PlanStatus::solved) {
        RC_ASSERT(run.ending != Ending::arrived);
        return;
    }
    RC_ASSERT(run.ending == Ending::arrived);
    // The disc's own path need not be its shortest: what no path of it is below.
    const Agent& rover = drawn.mission.first(AgentKind::ground);
    const double least =
        CrossingSearcher().find(drawn.map, rover.start, rover.goal, {.body = rover.body, .relaxed = true}).lower_bound;
    RC_ASSERT(run.ground_makespan >= least / rover.speed * (1 - 1e-9) - 1e-6);
}

// A wall between start and goal, and a rover that crosses the other's way.
Rehearsable crossing() {
    const Map map = Map::from_rows({
        ".......A.......",
        ".......A.......",
        ".......A.......",
        ".......A.......",
        ".......A.......",
    });
    Mission mission{
        .agents = {vehicle("one", {0, 2}, {14, 2}), vehicle("two", {3, 0}, {3, 4}), aircraft("heli", {0, 0}, {0, 0})}};
    mission.rules.breach_time.per_obstacle = 3;
    return {map, mission, Planner().plan(map, mission)};
}

// The executor sees what a plan without one of its orders leads to.
TEST(Rehearse, AnOrderThatIsMissingIsSeen) {
    const Rehearsable drawn = crossing();
    ASSERT_EQ(drawn.plan.status, PlanStatus::solved);
    ASSERT_GE(drawn.plan.orders.size(), 2U);
    const RehearsalOptions options{.delay = {DelayKind::exponential, 3}, .runs = 300, .threads = 1};
    EXPECT_EQ(faults(rehearse(drawn.map, drawn.mission, drawn.plan, options)), "");
    for (const OrderReason reason : {OrderReason::opening, OrderReason::passing}) {
        Plan plan = drawn.plan;
        std::erase_if(plan.orders, [&](const Order& order) { return order.reason == reason; });
        ASSERT_LT(plan.orders.size(), drawn.plan.orders.size()) << to_string(reason);
        EXPECT_GT(rehearse(drawn.map, drawn.mission, plan, options).illegal, 0) << to_string(reason);
    }
}

// Nor does it miss what a plan without zones leads through.
TEST(Rehearse, AnAgentInAZoneIsSeen) {
    Rehearsable drawn = crossing();
    const Zone zone{.polygon = {{{2, -0.5}, {5, -0.5}, {5, 3.5}, {2, 3.5}}}, .name = "park"};
    for (const ZoneKind kind : {ZoneKind::no_fly, ZoneKind::keep_out}) {
        drawn.mission.rules.zones = {zone};
        drawn.mission.rules.zones.front().kind = kind;
        const Rehearsed run = rehearse(drawn.map, drawn.mission, drawn.plan, {.runs = 1}).runs.front();
        EXPECT_EQ(run.illegal, kind == ZoneKind::no_fly ? 1 : 2);
        EXPECT_NE(run.fault.find("is in the zone 'park' between"), std::string::npos) << run.fault;
    }
}

// A rover drives along a street, through a market that it reaches into from 9 to 13 after it sets out.
Rehearsable past_a_market(double from, double until) {
    const Map map = Map::from_rows({"...............", "...............", "..............."});
    Mission mission = ground_and_air({0, 1}, {14, 1});
    mission.rules.removals = 0;
    mission.agents.pop_back();
    mission.agents.push_back(aircraft("air", {0, 0}));
    Zone market{.kind = ZoneKind::keep_out, .polygon = {{{9.5, -1}, {12.5, -1}, {12.5, 4}, {9.5, 4}}}};
    market.from = from;
    market.until = until;
    mission.rules.zones = {market};
    return {map, mission, Planner().plan(map, mission)};
}

TEST(Rehearse, WhoIsLateWaitsUntilAZoneIsOver) {
    const Rehearsable drawn = past_a_market(14, 30);
    ASSERT_EQ(drawn.plan.after.makespan, 14);
    const auto played = [&](double late) {
        return rehearse(drawn.map, drawn.mission, drawn.plan, {.delay = {DelayKind::fixed, late}, .runs = 1})
            .runs.front();
    };
    EXPECT_EQ(played(0).revisions, 0);
    EXPECT_EQ(played(0.25).revisions, 0);
    const Rehearsed late = played(3);
    EXPECT_EQ(late.revisions, 1);
    EXPECT_EQ(late.illegal, 0) << late.fault;
    EXPECT_EQ(late.caught, 0);
    EXPECT_EQ(late.ending, Ending::arrived);
    EXPECT_NEAR(late.makespan, 35 + 3, 1e-3);  // late once more, when it leaves at last
}

// It turns in the zone, at a place that it leaves late.
TEST(Rehearse, WhoIsLateInAZoneIsCaughtThereAndGoesOn) {
    const Map map = Map::from_rows({"....", "@@@.", "@@@.", "@@@.", "@@@."});
    Mission mission = ground_and_air({0, 0}, {3, 4});
    mission.rules.removals = 0;
    mission.rules.zones = {
        {.kind = ZoneKind::keep_out, .polygon = {{{1.5, -1}, {4, -1}, {4, 1.5}, {1.5, 1.5}}}, .from = 7.5}};
    const Rehearsable drawn{map, mission, Planner().plan(map, mission)};
    ASSERT_EQ(drawn.plan.after.makespan, 7);
    const Rehearsal rehearsal =
        rehearse(drawn.map, drawn.mission, drawn.plan, {.delay = {DelayKind::fixed, 2}, .runs = 1});
    EXPECT_EQ(rehearsal.caught, 1);
    EXPECT_EQ(rehearsal.illegal, 0) << rehearsal.runs.front().fault;
    EXPECT_EQ(rehearsal.arrived, 1);
    EXPECT_EQ(rehearsal.revisions, 0);
}

TEST(Rehearse, CountsWhatHappens) {
    const Rehearsable drawn = crossing();
    const auto played = [&](const RehearsalOptions& options) {
        return rehearse(drawn.map, drawn.mission, drawn.plan, options).runs.front();
    };
    const Rehearsed late = played({.delay = {DelayKind::fixed, 1}, .runs = 1});
    EXPECT_EQ(late.ending, Ending::arrived);
    EXPECT_GT(late.makespan, *drawn.plan.after.makespan);
    EXPECT_EQ(late.revisions, 0);
    const Rehearsed failed = played({.fail = 1, .runs = 1});
    EXPECT_EQ(failed.ending, Ending::no_way);
    EXPECT_EQ(failed.failed, 1);
    EXPECT_EQ(failed.revisions, 1);
    const Rehearsed lost = played({.lost = 1, .runs = 1});
    EXPECT_EQ(lost.lost, 1);
}

// A flight of 16 of 20 cells, 4 of them in reserve; it is late when it leaves the breach cell, in the air.
TEST(Rehearse, CountsLandingsOnTheReserveAndEmptyBatteries) {
    const Map map = map_from_ascii(R"(
        .........#...
        .........#...
        .........#...
        .........#...
        .........#...
        .............)");
    Mission mission = ground_and_air({8, 0}, {12, 0});
    mission.agents[1].start = mission.agents[1].goal = {0, 0};
    mission.agents[1].range = 20;
    mission.agents[1].reserve = 0.2;
    mission.agents[1].speed = 4;
    mission.rules.objective = Objective::ground_makespan;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 1U);
    const auto late = [&](double delay) {
        return rehearse(map, mission, plan, {.delay = {DelayKind::fixed, delay}, .runs = 2, .threads = 1});
    };
    EXPECT_EQ(late(0).on_reserve, 0);
    EXPECT_EQ(late(0.5).on_reserve, 2);
    EXPECT_EQ(late(0.5).emptied, 0);
    EXPECT_EQ(late(1.5).on_reserve, 0);
    EXPECT_EQ(late(1.5).emptied, 2);
    EXPECT_EQ(late(1.5).runs.front().lost, 0);
    EXPECT_EQ(late(1.5).arrived, 2);
}

TEST(Rehearse, RefusesWhatItCannotPlay) {
    Rehearsable drawn = crossing();
    const auto refused = [&](const RehearsalOptions& options) {
        return input_error([&] { static_cast<void>(rehearse(drawn.map, drawn.mission, drawn.plan, options)); });
    };
    EXPECT_EQ(refused({.fail = 1.5}), "the chance that a breach fails must be from 0 to 1, not 1.5");
    EXPECT_EQ(refused({.runs = 0}), "the number of runs must be from 1 to 1e+07, not 0");
    drawn.mission.rules.timing = Timing::ignore;
    EXPECT_EQ(
        refused({}),
        "a plan that enters obstacles before they are breached cannot be rehearsed: plan it with timing enforced");
    drawn.plan.status = PlanStatus::no_plan;
    EXPECT_EQ(refused({}), "only a plan that is solved can be rehearsed");
}

TEST(Rehearse, QuantilesAreValuesOfTheList) {
    EXPECT_EQ(quantile({}, 0.5), 0);
    EXPECT_EQ(quantile({1, 2, 3, 4}, 0.5), 2);
    EXPECT_EQ(quantile({1, 2, 3, 4}, 0.95), 4);
    EXPECT_EQ(quantile({1, 2, 3, 4}, 0), 1);
}

}  // namespace
}  // namespace waybreaker

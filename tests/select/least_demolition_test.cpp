// Plans that demolish the least, against every set of obstacles there is.
#include "select/least_demolition.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr int width = 14;
constexpr int height = 9;

// Some rectangles between two free columns.
Map some_blocks() {
    std::vector<std::uint32_t> labels(std::size_t(width) * height, 0);
    const int blocks = *number(1, 6);
    for (int label = 1; label <= blocks; ++label) {
        const Cell corner{*number(1, width - 3), *number(0, height - 1)};
        const Cell end{std::min(corner.x + *number(1, 4), width - 1), std::min(corner.y + *number(1, 8), height)};
        for (Cell c = corner; c.y < end.y; ++c.y) {
            for (c.x = corner.x; c.x < end.x; ++c.x) labels[std::size_t(c.y * width + c.x)] = std::uint32_t(label);
        }
    }
    std::vector<ObstacleAttributes> attributes(std::size_t(blocks) + 1);
    for (ObstacleAttributes& one : attributes) one.destructible = mostly();
    return Map::from_labels(width, height, std::move(labels), attributes);
}

std::uint64_t cells_of(const Plan& plan) {
    std::uint64_t cells = 0;
    for (const Breach& breach : plan.breaches) cells += breach.cells;
    return cells;
}

double reached(const Plan& plan, const Mission& mission) {
    return value(plan.after, mission.rules.objective).value_or(infinity);
}

// Calls visit(cells, objective) for each set of at most that many obstacles, each removed as a whole.
template <class Visit>
void for_each_set(const Map& map, Mission mission, int most, Visit visit) {
    std::vector<ObstacleId> can_go;
    for (const Obstacle& o : map.obstacles()) {
        if (o.destructible && std::ranges::count(mission.rules.protect, o.id) == 0) can_go.push_back(o.id);
    }
    Planner planner;
    mission.rules.minimise_demolition.reset();
    for (std::size_t set = 0; set < std::size_t{1} << can_go.size(); ++set) {
        mission.rules.force.clear();
        std::uint64_t cells = 0;
        for (std::size_t i = 0; i < can_go.size(); ++i) {
            if ((set >> i & 1U) == 0) continue;
            mission.rules.force.push_back(can_go[i]);
            cells += map.obstacle(can_go[i]).cells;
        }
        mission.rules.removals = int(mission.rules.force.size());
        if (mission.rules.removals <= most) visit(cells, reached(planner.plan(map, mission), mission));
    }
}

Mission some_mission(const Map& map) {
    const auto row = [] { return *number(0, height - 1); };
    Mission mission = ground_and_air({0, row()}, {width - 1, row()});
    mission.rules.removals = *number(0, 3);
    mission.rules.timing = *rc::gen::element(Timing::enforce, Timing::ignore);
    mission.rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    mission.rules.breach_time.per_obstacle = *rc::gen::element(0.0, 0.0, 2.0);
    Body& body = mission.agents[0].body;
    body.radius = *rc::gen::element(0.5, 0.5, 0.6, 0.7, 1.2);
    RC_PRE(fits(OpenedMap(map), mission.agents[0].start, body) && fits(OpenedMap(map), mission.agents[0].goal, body));
    if (map.obstacles().size() > 1 && *number(0, 3) == 0) mission.rules.protect = {{1}};
    return mission;
}

// The same for two vehicles, with one or two aircraft.
Mission some_team(const Map& map) {
    Mission mission = some_mission(map);
    mission.rules.removals = *number(0, 2);
    Agent other = mission.agents[0];
    other.id = "other";
    other.start.y = *number(0, height - 1);
    other.goal.y = *number(0, height - 1);
    other.ready_at = *rc::gen::element(0.0, 3.0);
    mission.agents.push_back(other);
    if (*rc::gen::arbitrary<bool>()) mission.agents.push_back(aircraft("second", {0, 0}, {0, 0}, 2));
    RC_PRE(input_error([&] { validate(map, mission); }).empty());
    return mission;
}

void expect_frugal(const Map& map, Mission mission) {
    Planner planner;
    const Plan best = planner.plan(map, mission);
    const double tolerance = *rc::gen::element(0.0, 0.02, 0.1);
    mission.rules.minimise_demolition = tolerance;
    const Plan spares = planner.plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, spares) == "");
    RC_ASSERT(spares.status == best.status);
    if (best.status != PlanStatus::solved) return;
    const double limit = reached(best, mission) * (1 + tolerance);
    RC_ASSERT(reached(spares, mission) <= limit * (1 + 1e-9));
    RC_ASSERT(cells_of(spares) <= cells_of(best));
    RC_ASSERT(spares.least_demolition.has_value());
    RC_ASSERT(*spares.least_demolition <= cells_of(spares));
    RC_TAG(std::string(*spares.least_demolition == cells_of(spares) ? "proven" : "not proven"));
    for_each_set(map, mission, mission.rules.removals, [&](std::uint64_t cells, double objective) {
        if (objective <= limit) RC_ASSERT(cells >= *spares.least_demolition);
    });
}

RC_GTEST_PROP(LeastDemolition, IsAsGoodAsAskedForAndNothingAsGoodDemolishesLess, ()) {
    const Map map = some_blocks();
    expect_frugal(map, some_mission(map));
}

RC_GTEST_PROP(LeastDemolition, OfATeamIsAsGoodAsAskedForAndNothingAsGoodDemolishesLess, ()) {
    const Map map = some_blocks();
    expect_frugal(map, some_team(map));
}

// A thick block on the straight way; beside it a thin one, a little farther. Others are far away.
constexpr std::string_view two_ways = R"(
    ######.######
    ......b......
    ......b......
    .....aaa.....
    S....aaa....G
    .....aaa.....
    ######.######)";

Plan planned(const Map& map, std::optional<double> tolerance, int removals = 1) {
    Mission mission = ground_and_air(mark_in_ascii(two_ways, 'S'), mark_in_ascii(two_ways, 'G'));
    mission.rules.removals = removals;
    mission.rules.minimise_demolition = tolerance;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_TRUE(is_valid(map, mission, plan));
    return plan;
}

TEST(LeastDemolition, TakesTheThinWallForALittleMore) {
    const Map map = map_from_ascii(two_ways);
    EXPECT_EQ(cells_of(planned(map, std::nullopt)), 9U);
    EXPECT_FALSE(planned(map, std::nullopt).least_demolition);
    EXPECT_EQ(cells_of(planned(map, 0.01)), 9U);
    const Plan plan = planned(map, 0.2);
    EXPECT_EQ(cells_of(plan), 2U);
    EXPECT_EQ(plan.least_demolition, 2U);
    EXPECT_GT(plan.gap.value_or(0), 0.01);
}

TEST(LeastDemolition, EndsForAWideDisc) {
    const Map map = map_from_ascii("...a...\n...a...\n...a...");
    Mission mission = ground_and_air({1, 1}, {5, 1});
    mission.agents[0].body.radius = 0.6;
    mission.rules.minimise_demolition = 0;
    const Plan plan = Planner().plan(map, mission);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(cells_of(plan), 3U);
    EXPECT_EQ(plan.least_demolition, 3U);
}

// Two stones in the way of a wide disc, or one, for a little more.
TEST(LeastDemolition, SparesAStoneOfTwoForAWideDisc) {
    const Map map = map_from_ascii("....\n...a\n....\n....\nb.c.\n....\n....\n....\n....");
    Mission mission = ground_and_air({1, 1}, {2, 7});
    mission.agents[0].body.radius = 1.2;
    mission.agents[1].start = {2, 3};
    mission.rules.removals = 3;
    Planner planner;
    const double best = reached(planner.plan(map, mission), mission);
    mission.rules.minimise_demolition = 0.08;
    const Plan plan = planner.plan(map, mission);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_LE(reached(plan, mission), best * 1.08);
    EXPECT_EQ(cells_of(plan), 1U);
}

TEST(LeastDemolition, IsForExactSelectionAndBudgetsOfCells) {
    const Map map = map_from_ascii(two_ways);
    Mission mission = ground_and_air(mark_in_ascii(two_ways, 'S'), mark_in_ascii(two_ways, 'G'));
    const auto refusal = [&](const Map& on, const Method& method) {
        return input_error([&] { Planner().plan(on, mission, method); });
    };
    mission.rules.minimise_demolition = 0.1;
    EXPECT_EQ(refusal(map, {.select = Selection::hits}), "demolition is minimised by exact selection only");
    mission.rules.budget = 10;
    EXPECT_EQ(refusal(map, {}),
              "demolition is minimised within a budget of square metres or cells, not of other weights");
    std::vector<double> areas{0};
    for (const Obstacle& o : map.obstacles()) areas.push_back(o.cells * 5.76);
    EXPECT_EQ(refusal(map.with_weights(areas), {}), "");
    mission.rules.minimise_demolition = 1.5;
    EXPECT_NE(refusal(map, {}), "");
}

}  // namespace
}  // namespace waybreaker

// What a plan promises, whatever the mission: figures that add up, and agents that do what the plan says.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"
#include "legal_path.hpp"
#include "paper_plan.hpp"
#include "random_map.hpp"
#include "select/hits.hpp"
#include "waybreaker/advanced/flight.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * (1 + std::abs(a));
}

std::vector<Point> points(const std::vector<Cell>& cells) {
    return {cells.begin(), cells.end()};
}

double length(const std::vector<Point>& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        sum += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return sum;
}

void check_outcome(const Outcome& outcome, const Agent& driver, const Agent& flyer) {
    RC_ASSERT(near(outcome.air().length.value(), length(outcome.air().path)));
    RC_ASSERT(outcome.air().path.front() == Point(flyer.start));
    RC_ASSERT(outcome.air().path.back() == Point(flyer.goal));
    RC_ASSERT(outcome.ground().length.has_value() == !outcome.ground().path.empty());
    RC_ASSERT(outcome.makespan.has_value() == outcome.ground().length.has_value());
    RC_ASSERT(outcome.flowtime.has_value() == outcome.ground().length.has_value());
    if (!outcome.ground().length) return;
    const double ground_time = *outcome.ground().length / driver.speed;
    const double air_time = *outcome.air().length / flyer.speed;
    RC_ASSERT(near(*outcome.makespan, std::max(ground_time, air_time)));
    RC_ASSERT(near(*outcome.flowtime, ground_time + air_time));
}

RC_GTEST_PROP(Mission, PlansWhatItsStepsSay, ()) {
    const PlainMap plain_map = *random_map(20, 16);
    const Map map(plain_map.grid());
    Mission mission = ground_and_air(any_free_cell(plain_map), any_free_cell(plain_map));
    const Agent driver = mission.agents[0];
    mission.agents[1].start = any_cell(plain_map);
    mission.agents[1].goal = any_cell(plain_map);
    mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 4.0);
    const Agent flyer = mission.agents[1];
    if (*rc::gen::arbitrary<bool>()) std::swap(mission.agents[0], mission.agents[1]);
    Method method;
    method.select = Selection::hits;
    mission.rules.removals = *number(0, 4);
    mission.rules.timing = Timing::ignore;
    method.flight = *rc::gen::element(FlightRule::optimal, FlightRule::nearest);
    method.planner = *rc::gen::element(Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar, Algorithm::jps);
    const Plan plan = Planner().plan(map, mission, method);

    // The paper's steps, one by one.
    const SearchOptions search = search_options(method, driver.body);
    SearchOptions counting = search;
    counting.count_hits = true;
    const SearchResult before = Searcher().find(OpenedMap(map), driver.start, driver.goal, counting);
    const std::vector<ObstacleId> chosen = most_hit(map, before.hits, mission.rules.removals);
    const Flight flight = method.flight == FlightRule::optimal ? fly_optimal(map, flyer.start, flyer.goal, chosen)
                                                               : fly_nearest(map, flyer.start, flyer.goal, chosen);
    const SearchResult after = Searcher().find(OpenedMap(map, chosen), driver.start, driver.goal, search);
    RC_ASSERT(plan.before.ground().path == points(before.path));
    RC_ASSERT(plan.before.ground().expanded == before.expanded);
    RC_ASSERT(plan.before.ground().generated == before.generated);
    RC_ASSERT(plan.after.ground().path == points(after.path));
    RC_ASSERT(plan.after.ground().expanded == after.expanded);
    RC_ASSERT(near(plan.after.air().length.value(), flight.length));
    RC_ASSERT((plan.status == PlanStatus::solved) == (after.status == SearchStatus::found));
    RC_ASSERT(!plan.bound);
    check_outcome(plan.before, driver, flyer);
    check_outcome(plan.after, driver, flyer);
    RC_ASSERT(path_fault(waybreaker::plain(map, chosen), driver.start, driver.goal, search, after).empty());

    // The removed obstacles, in the order of the flight, each from its boundary and when the air agent is there.
    RC_ASSERT(plan.breaches.size() == chosen.size());
    double flown = 0;
    for (std::size_t i = 0; i < plan.breaches.size(); ++i) {
        const Breach& breach = plan.breaches[i];
        RC_ASSERT(breach.obstacle == flight.breaches[i].obstacle);
        RC_ASSERT(Point(breach.at) == plan.after.air().path[i + 1]);
        RC_ASSERT(breach.cells == map.obstacle(breach.obstacle).cells);
        RC_ASSERT(breach.hits == before.hits[breach.obstacle.value]);
        const std::vector<Cell> boundary = map.boundary(breach.obstacle);
        RC_ASSERT(std::count(boundary.begin(), boundary.end(), breach.at) == 1);
        flown += distance(plan.after.air().path[i], breach.at);
        RC_ASSERT(near(breach.cleared_at, flown / flyer.speed));
    }

    // The agents, in the mission's order, on time.
    RC_ASSERT(plan.agents.size() == (plan.status == PlanStatus::solved ? 2U : 0U));
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Itinerary& agent = plan.agents[i];
        RC_ASSERT(agent.id == mission.agents[i].id);
        RC_ASSERT(agent.kind == mission.agents[i].kind);
        RC_ASSERT(agent.speed == mission.agents[i].speed);
        const std::vector<Point> path =
            agent.kind == AgentKind::ground ? plan.after.ground().path : plan.after.air().path;
        RC_ASSERT(agent.path.size() == path.size());
        RC_ASSERT(near(agent.path.back().t, length(path) / agent.speed));
    }
}

TEST(Mission, ReportsTimesAndFigures) {
    const Map map = map_from_ascii(R"(
        .............
        ......aa.....
        ......aa.....
        ......aa.....
        ......aa.....
        ......aa.....
        .............)");
    Mission mission = ground_and_air({0, 3}, {12, 3});
    mission.agents[0].speed = 2;
    const Plan plan = paper_plan(map, mission, 1);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_NEAR(plan.before.ground().length.value(), std::hypot(5, 3) + 3 + 5, 1e-12);
    EXPECT_DOUBLE_EQ(plan.after.ground().length.value(), 12);
    EXPECT_DOUBLE_EQ(plan.after.makespan.value(), 12);
    EXPECT_DOUBLE_EQ(plan.after.flowtime.value(), 6 + 12);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].cells, 10U);
    EXPECT_GT(plan.breaches[0].hits, 0U);
    EXPECT_EQ(plan.breaches[0].at, (Cell{5, 3}));
    EXPECT_DOUBLE_EQ(plan.breaches[0].cleared_at, 5);
    EXPECT_DOUBLE_EQ(plan.breaches[0].entered_at.value(), 2.5);  // before it is gone: the paper does not ask when
}

// A search sees the walls it reaches, no more: of two walls across the map it removes the first.
TEST(Mission, CannotSeeBehindAWallAcrossTheMap) {
    const Map map = map_from_ascii(R"(
        ..a..b..
        ..a..b..
        ..a..b..)");
    const Plan plan = paper_plan(map, ground_and_air({0, 1}, {7, 1}), 2);
    EXPECT_EQ(plan.status, PlanStatus::no_plan);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].obstacle, map.obstacle_at({2, 0}));
    EXPECT_FALSE(plan.breaches[0].entered_at);
    EXPECT_FALSE(plan.after.ground().length || plan.after.makespan || plan.after.flowtime);
    EXPECT_TRUE(plan.agents.empty());
}

TEST(Mission, OpensTheOnlyWay) {
    const Map map = map_from_ascii(R"(
        ..a..
        ..a..
        ..a..)");
    const Plan plan = paper_plan(map, ground_and_air({0, 1}, {4, 1}), 1);
    EXPECT_EQ(plan.status, PlanStatus::solved);
    EXPECT_FALSE(plan.before.ground().length || plan.before.makespan);
    EXPECT_DOUBLE_EQ(plan.after.ground().length.value(), 4);
    const Plan closed = paper_plan(map, ground_and_air({0, 1}, {4, 1}), 0);
    EXPECT_EQ(closed.status, PlanStatus::no_plan);
    EXPECT_TRUE(closed.breaches.empty());
}

TEST(Mission, LeavesAloneWhatCannotBeRemoved) {
    std::vector<std::uint32_t> labels{0, 0, 1, 0, 2, 0, 0};
    const std::vector<ObstacleAttributes> attributes{{}, {.destructible = false}, {.source_id = 77}};
    const Map map = Map::from_labels(7, 1, labels, attributes);
    const Plan plan = paper_plan(map, ground_and_air({3, 0}, {6, 0}), 2);
    EXPECT_EQ(plan.status, PlanStatus::solved);
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].source_id, 77);
}

TEST(Mission, ChangesNothingWhereNothingWasHit) {
    const Map map = map_from_ascii(R"(
        ........
        ........
        ........
        #.......)");
    for (const int removals : {0, 1, 3, 1000}) {
        const Plan plan = paper_plan(map, ground_and_air({1, 0}, {7, 0}), removals);
        EXPECT_EQ(plan.status, PlanStatus::solved);
        EXPECT_TRUE(plan.breaches.empty());
        EXPECT_EQ(plan.before.ground().path, plan.after.ground().path);
        EXPECT_EQ(plan.before.makespan, plan.after.makespan);
        EXPECT_DOUBLE_EQ(plan.after.air().length.value(), 6);
    }
}

TEST(Mission, TakesStartAsGoal) {
    const Map map = map_from_ascii("..#");
    const Plan plan = paper_plan(map, ground_and_air({1, 0}, {1, 0}), 3);
    EXPECT_EQ(plan.status, PlanStatus::solved);
    EXPECT_EQ(plan.after.makespan, 0);
    EXPECT_TRUE(plan.breaches.empty());
}

TEST(Mission, SaysThatASearchEndedEarly) {
    const Map map(Grid(30, 30));
    const Mission mission = ground_and_air({0, 0}, {29, 29});
    const Method method{.select = Selection::hits, .planner = Algorithm::dijkstra};
    EXPECT_EQ(Planner().plan(map, mission, method, {.expansions = 3}).status, PlanStatus::limit_reached);
    StopSource source;
    source.request_stop();
    EXPECT_EQ(Planner().plan(map, mission, method, {.stop = source.get_token()}).status, PlanStatus::stopped);
}

}  // namespace
}  // namespace waybreaker

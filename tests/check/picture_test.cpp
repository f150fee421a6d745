// What is allowed and what is not, in pictures.
#include <gtest/gtest.h>

#include "ascii_map.hpp"
#include "hand_made.hpp"

namespace waybreaker {

// Shown by GoogleTest.
inline void PrintTo(Rule rule, std::ostream* out) {
    *out << to_string(rule);
}

namespace {

using BrokenRules = std::set<Rule>;
using Path = std::vector<Point>;

const BrokenRules none;

// Which rules it breaks to drive so, while the air agent stays where it is.
BrokenRules drive(const Map& map, const Path& path, const Body& body = {}) {
    return broken_rules(map, hand_made(driven(path), driven({{0, 0}})), {}, body);
}

TEST(Check, LetsADiscTouchButNotMeetCorners) {
    const Map map = map_from_ascii(R"(
        .........
        .........
        ..#......
        .........
        .........)");
    EXPECT_EQ(drive(map, {{0, 1}, {8, 1}}), none) << "along its side";
    EXPECT_EQ(drive(map, {{1, 0}, {1, 4}}), none);
    // kin.
    EXPECT_EQ(drive(map, {{0, 3}, {8, 2}}), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(map, {{1, 1}, {3, 3}}), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(map, {{0, 3}, {1, 3}, {3, 3}, {3, 2}}), none);
    EXPECT_EQ(drive(map, {{3, 1}, {2, 1}, {2, 2}}), BrokenRules{Rule::collision}) << "into it";
    EXPECT_EQ(drive(map, {{2, 2}}), BrokenRules{Rule::collision}) << "to stand in it";
}

// The line from (0, 0) to (8, 6) passes the corners of cells at multiples of a tenth; a corner at exactly 0.5 is
// touched.
TEST(Check, TellsTouchingFromMeetingExactly) {
    const auto with_blocked = [](Cell c) {
        Grid grid(9, 7);
        grid.set_blocked(c, true);
        return Map(std::move(grid));
    };
    const Path line{{0, 0}, {8, 6}};
    // Distance of corner (x, y) to the line: |3 x - 4 y| / 5.
    EXPECT_EQ(drive(with_blocked({2, 0}), line), none) << "corner (1.5, 0.5) at 2.5 / 5";
    EXPECT_EQ(drive(with_blocked({2, 0}), line, {.radius = 0.501}), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(with_blocked({6, 3}), line), none) << "corner (5.5, 3.5) at 2.5 / 5";
    EXPECT_EQ(drive(with_blocked({5, 3}), line), BrokenRules{Rule::collision}) << "corner (4.5, 3.5) at 0.5 / 5";
    EXPECT_EQ(drive(with_blocked({4, 4}), line), BrokenRules{Rule::collision}) << "corner (4.5, 3.5) at 0.5 / 5";
    EXPECT_EQ(drive(with_blocked({6, 2}), line), none);
}

TEST(Check, KnowsTheCornerRules) {
    const Map one = map_from_ascii(R"(
        ...
        .#.
        ...)");
    const Map two = map_from_ascii(R"(
        .#.
        #..
        ...)");
    const Path past_one{{0, 1}, {1, 2}};
    const Path past_two{{0, 0}, {1, 1}};
    EXPECT_EQ(drive(one, past_one), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(one, past_one, {.corners = Corners::cut}), none);
    EXPECT_EQ(drive(one, past_one, {.corners = Corners::squeeze}), none);
    EXPECT_EQ(drive(two, past_two), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(two, past_two, {.corners = Corners::cut}), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(two, past_two, {.corners = Corners::squeeze}), none);
    EXPECT_EQ(drive(two, {{1, 1}, {0, 0}}, {.corners = Corners::cut}), BrokenRules{Rule::collision}) << "and back";
    EXPECT_EQ(drive(two, {{0, 0}, {1, 0}}, {.corners = Corners::squeeze}), BrokenRules{Rule::collision})
        << "into a wall";
}

TEST(Check, KeepsWideAgentsOnTheMap) {
    const Map map(Grid(9, 5));
    EXPECT_EQ(drive(map, {{2, 2}, {6, 2}}, {.radius = 2.5}), none);
    EXPECT_EQ(drive(map, {{2, 2}, {6, 2}}, {.radius = 2.501}), BrokenRules{Rule::collision});
    EXPECT_EQ(drive(map, {{2, 2}, {7, 2}}, {.radius = 2}), BrokenRules{Rule::collision});
}

TEST(Check, LetsPointsTouchAndSlipButNotPassWalls) {
    const Map map = map_from_ascii(R"(
        .....aab.
        .....aab.
        ..cd.....
        .c.......
        .........)");
    EXPECT_EQ(drive(map, {{4, 2}, {4.5, 1.5}, {7.5, 1.5}, {8, 1}}, point_body), none) << "along a wall";
    EXPECT_EQ(drive(map, {{8, 3}, {7.5, 1.5}, {7.5, -0.5}, {8, 0}}, point_body), none)
        << "along it up to the map's edge";
    EXPECT_EQ(drive(map, {{6, 2}, {6.5, 1.5}, {6.5, -0.5}, {8, 0}}, point_body), BrokenRules{Rule::collision})
        << "between two obstacles, then along the map's edge beside one";
    EXPECT_EQ(drive(map, {{4, 0}, {4.5, -0.5}, {7.5, -0.5}, {8, 0}}, point_body), BrokenRules{Rule::collision})
        << "along the map's edge beside walls";
    EXPECT_EQ(drive(map, {{6, 2}, {5.5, 1.5}, {5.5, 0.5}}, point_body).count(Rule::collision), 1U)
        << "within an obstacle";
    EXPECT_EQ(drive(map, {{1, 2}, {2, 3}}, point_body), none) << "between diagonal neighbours";
    EXPECT_EQ(drive(map, {{2, 3}, {2.5, 2.5}, {2.5, 1.5}, {3, 1}}, point_body), BrokenRules{Rule::collision})
        << "between c and d";
    EXPECT_EQ(drive(map, {{2, 3}, {2.5, 2}}, point_body), (BrokenRules{Rule::goal, Rule::vertex}))
        << "half way up a side";
    EXPECT_EQ(drive(map, {{0, 0}, {-0.5, -0.5}, {-0.5, 4.5}, {0, 4}}, point_body), none);
    EXPECT_EQ(drive(map, {{0, 0}, {-1.5, 1.5}, {0, 4}}, point_body), BrokenRules{Rule::vertex}) << "off the map";
}

TEST(Check, KeepsPointsFromPassingWallsAtAnyEdgeOfTheMap) {
    const Map map = map_from_ascii(R"(
        .a.
        b.c
        .d.)");
    const BrokenRules collision{Rule::collision};
    EXPECT_EQ(drive(map, {{0, 0}, {-0.5, 0.5}, {-0.5, 1.5}, {0, 2}}, point_body), collision);
    EXPECT_EQ(drive(map, {{2, 2}, {2.5, 1.5}, {2.5, 0.5}, {2, 0}}, point_body), collision);
    EXPECT_EQ(drive(map, {{0, 0}, {0.5, -0.5}, {1.5, -0.5}, {2, 0}}, point_body), collision);
    EXPECT_EQ(drive(map, {{2, 2}, {1.5, 2.5}, {0.5, 2.5}, {0, 2}}, point_body), collision);
    EXPECT_EQ(drive(map, {{0, 0}, {0.5, 0.5}, {1.5, 0.5}, {2, 0}}, point_body), none) << "along the other side";
}

TEST(Check, LetsNoErrorsAddUp) {
    const Map map(Grid(1100, 1));
    const Path path{{0, 0}, {1000, 0}, {1001, 0}, {1002, 0}, {1003, 0}};
    std::vector<Waypoint> ground = driven(path);
    ground[2].t -= 0.0007;  // within the tolerance of a millionth of 1000
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}})), {}), none);
    ground[3].t -= 0.0014;
    ground[4].t -= 0.0021;
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}})), {}).count(Rule::speed), 1U);
}

TEST(Check, GrantsNoMoreToWhoWaitsLonger) {
    const Map map(Grid(1100, 1));
    std::vector<Waypoint> ground{{0, 0, 0}, {0, 0, 1e9}, {100, 0, 1e9 + 100}};
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}})), {}), none);
    ground[2].t -= 0.01;
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}})), {}).count(Rule::speed), 1U);
}

TEST(Check, BendsAtCellCentresOfTheMap) {
    const Map map(Grid(9, 5));
    EXPECT_EQ(drive(map, {{1, 1}, {2.5, 1.5}, {4, 1}}), BrokenRules{Rule::vertex});
    EXPECT_EQ(drive(map, {{1, 1}, {9, 1}, {4, 1}}), BrokenRules{Rule::vertex});
    EXPECT_EQ(drive(map, {{1, 1}, {1e300, -1e300}, {4, 1}}).count(Rule::vertex), 1U);
}

// Two walls, each breached from its side that the air agent reaches first.
class TwoWalls : public testing::Test {
  protected:
    const Map map = map_from_ascii(R"(
        ...a...b...
        ...a...b...
        ...a...b...)");
    const Breach a{.obstacle = {1}, .cells = 3, .at = {2, 0}, .cleared_at = 2, .entered_at = 2.5};
    const Breach b{.obstacle = {2}, .cells = 3, .at = {6, 0}, .cleared_at = 6, .entered_at = 6.5};
    const std::vector<Waypoint> ground = driven({{0, 1}, {10, 1}});
    const std::vector<Waypoint> air = driven({{0, 0}, {10, 0}});
    const Plan good = hand_made(ground, air, {a, b});
    const BrokenRules collision{Rule::collision};

    BrokenRules broken(const Plan& plan, const Rules& rules = {}) const { return broken_rules(map, plan, rules); }
};

// The disc's front is half a cell ahead, and the wall's side half a cell nearer.
TEST_F(TwoWalls, MustBeGoneWhenTheGroundAgentComes) {
    Plan plan = good;
    plan.breaches[0].entered_at = plan.breaches[1].entered_at = 2;
    plan.breaches[1].entered_at = 6;
    EXPECT_EQ(broken(plan), none) << "each in the moment it goes";
    EXPECT_EQ(broken(good), BrokenRules{Rule::entered});

    plan.agents[1] = agent(AgentKind::air, driven({{0, 0}, {10, 0}}, 0.5), 0.5);
    plan.breaches[0].cleared_at = 4;
    plan.breaches[1].cleared_at = 12;
    set_figures(plan);
    EXPECT_EQ(broken(plan), collision) << "the air agent is late";
    EXPECT_EQ(broken(plan, {.timing = Timing::ignore}), none) << "the paper does not ask when";
    const std::vector<Violation> violations = check(map, mission_of(plan), plan);
    ASSERT_EQ(violations.size(), 2U);
    EXPECT_EQ(violations[0].message, "the ground agent touches obstacle 1, which stands until 4");
    EXPECT_EQ(violations[0].obstacle, ObstacleId{1});
    EXPECT_NEAR(violations[0].time.value(), 2, 1e-9);
    EXPECT_NEAR(violations[0].place.value().x, 2, 1e-9);
    EXPECT_EQ(violations[1].obstacle, ObstacleId{2});

    plan.agents[0] = agent(AgentKind::ground, {{0, 1, 0}, {2, 1, 2}, {2, 1, 4}, {6, 1, 8}, {6, 1, 12}, {10, 1, 16}});
    plan.breaches[0].entered_at = 4;
    plan.breaches[1].entered_at = 12;
    set_figures(plan);
    EXPECT_EQ(broken(plan), none) << "so the ground agent waits";
    plan.agents[0].path[2].t = 3.9;
    EXPECT_EQ(broken(plan).count(Rule::collision), 1U);
}

TEST_F(TwoWalls, AreSaidToBeEnteredWhenTheyAre) {
    Plan plan = good;
    plan.breaches[0].entered_at = 2;
    plan.breaches[1].entered_at = std::nullopt;
    EXPECT_EQ(broken(plan), BrokenRules{Rule::entered}) << "not never";
    plan = hand_made(driven({{0, 1}, {1, 1}}), air, {a, b});
    plan.breaches[0].entered_at = plan.breaches[1].entered_at = std::nullopt;
    EXPECT_EQ(broken(plan), none);
    plan.breaches[1].entered_at = 7;
    EXPECT_EQ(broken(plan), BrokenRules{Rule::entered}) << "but never";
}

TEST_F(TwoWalls, TakeTimeToBreach) {
    const Rules rules{.breach_time = {.per_obstacle = 1, .per_cell = 0.5}};  // 2.5 for three cells
    Plan plan = hand_made({{0, 1, 0}, {2, 1, 2}, {2, 1, 4.5}, {6, 1, 8.5}, {6, 1, 11}, {10, 1, 15}},
                          {{0, 0, 0}, {2, 0, 2}, {2, 0, 4.5}, {6, 0, 8.5}, {6, 0, 11}, {10, 0, 15}}, {a, b});
    plan.breaches[0].cleared_at = plan.breaches[0].entered_at.emplace(4.5);
    plan.breaches[1].cleared_at = plan.breaches[1].entered_at.emplace(11);
    EXPECT_EQ(broken(plan, rules), none);
    EXPECT_EQ(broken(plan, {.breach_time = {.per_obstacle = 2.6}}), BrokenRules{Rule::breach})
        << "does not stay so long";

    Plan restless = plan;
    restless.agents[1].path.insert(restless.agents[1].path.begin() + 2, {{2, 1, 3}, {2, 0, 4}});
    set_figures(restless);
    EXPECT_EQ(broken(restless, rules), BrokenRules{Rule::breach}) << "goes for a walk";

    // Both from one place between them, one after the other.
    const Map near = map_from_ascii("..a.b..");
    const Rules slow{.breach_time = {.per_obstacle = 2}};
    Plan both = hand_made({{0, 0, 0}}, {{0, 0, 0}, {3, 0, 3}, {3, 0, 7}, {6, 0, 10}},
                          {{.obstacle = {1}, .cells = 1, .at = {3, 0}, .cleared_at = 5, .entered_at = {}},
                           {.obstacle = {2}, .cells = 1, .at = {3, 0}, .cleared_at = 7, .entered_at = {}}});
    EXPECT_EQ(broken_rules(near, both, slow), none);
    both.breaches[1].cleared_at = 6;
    EXPECT_EQ(broken_rules(near, both, slow), BrokenRules{Rule::order}) << "at the same time";
}

TEST_F(TwoWalls, MayNotAllBeRemoved) {
    Plan plan = good;
    plan.breaches[0].entered_at = 2;
    plan.breaches[1].entered_at = 6;
    EXPECT_EQ(broken(plan, {.removals = 2}), none);
    EXPECT_EQ(broken(plan, {.removals = 1}), BrokenRules{Rule::removals});
    EXPECT_EQ(broken(plan, {.protect = {ObstacleId{2}}}), BrokenRules{Rule::obstacle});
    EXPECT_EQ(broken(plan, {.budget = 2}), none);
    const Map heavy = map.with_weights(std::vector<double>{0, 1.5, 0.7});
    EXPECT_EQ(broken_rules(heavy, plan, {.budget = 2}), BrokenRules{Rule::budget});
    const std::vector<ObstacleAttributes> attributes{{}, {}, {.destructible = false, .source_id = 9}};
    const Map solid = Map::from_labels(11, 3, {map.labels().begin(), map.labels().end()}, attributes);
    EXPECT_EQ(broken_rules(solid, plan, {}), (BrokenRules{Rule::obstacle, Rule::cells}))
        << "nor are they what they were";
}

// A point on the line between two cells is inside neither.
TEST(Check, LetsPointsPassBetweenCellsThatAreGone) {
    const Map map = map_from_ascii(R"(
        .....
        .aa..
        .aa..
        .....)");
    const std::vector<Waypoint> ground = driven({{2, 0}, {1.5, 0.5}, {1.5, 2.5}, {2, 3}});
    const double enters = std::sqrt(0.5);
    Plan plan =
        hand_made(ground, driven({{0, 0}}), {{.obstacle = {1}, .cells = 4, .at = {0, 0}, .entered_at = enters}});
    EXPECT_EQ(broken_rules(map, plan, {}, point_body), none);
    plan.breaches[0].entered_at = std::nullopt;
    EXPECT_EQ(broken_rules(map, plan, {}, point_body), BrokenRules{Rule::entered});
    plan.breaches.clear();
    EXPECT_EQ(broken_rules(map, plan, {}, point_body), BrokenRules{Rule::collision});
    plan = hand_made(ground, {{0, 0, 0}, {0, 0, 1}},
                     {{.obstacle = {1}, .cells = 4, .at = {0, 0}, .cleared_at = 1, .entered_at = enters}});
    EXPECT_EQ(broken_rules(map, plan, {}, point_body), BrokenRules{Rule::collision}) << "too early";
}

TEST(Check, LetsPointsPassBetweenTwoObstaclesIfOneIsGone) {
    const Map map = map_from_ascii(R"(
        .....
        .aab.
        .....)");
    const std::vector<Waypoint> ground = driven({{2, 0}, {2.5, 0.5}, {2.5, 1.5}, {2, 2}});
    const double enters = std::sqrt(0.5);
    const Breach a{.obstacle = {1}, .cells = 2, .at = {0, 0}, .entered_at = enters};
    const Breach b{.obstacle = {2}, .cells = 1, .at = {4, 0}, .entered_at = enters};
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}}), {a}), {}, point_body), none);
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{4, 0}}), {b}), {}, point_body), none);
    EXPECT_EQ(broken_rules(map, hand_made(ground, driven({{0, 0}})), {}, point_body), BrokenRules{Rule::collision});
}

TEST(Check, KnowsWhatBelongsToAPlanThatThereIsNot) {
    const Map map = map_from_ascii("..a..");
    Plan plan;
    plan.status = PlanStatus::no_plan;
    EXPECT_EQ(broken_rules(map, plan, {}), none);
    plan.breaches = {{.obstacle = {1}, .cells = 1, .at = {1, 0}, .cleared_at = 1, .entered_at = {}}};
    EXPECT_EQ(broken_rules(map, plan, {}), none) << "a removal that was no help";
    plan.status = PlanStatus::solved;
    EXPECT_EQ(broken_rules(map, plan, {}), BrokenRules{Rule::status});
    plan.status = PlanStatus::no_plan;
    plan.after.makespan = 4;
    EXPECT_EQ(broken_rules(map, plan, {}), BrokenRules{Rule::status});
    plan.after.makespan = std::nullopt;
    plan.before.ground().length = plan.before.makespan = plan.before.flowtime = 4;
    EXPECT_EQ(broken_rules(map, plan, {}), BrokenRules{Rule::status}) << "to remove nothing is a plan";
}

TEST(Check, RefusesRulesThatMakeNoSense) {
    const Map map(Grid(1, 1));
    const auto with_radius = [](double radius) {
        Mission mission = ground_and_air({0, 0}, {0, 0});
        mission.agents[0].body.radius = radius;
        return mission;
    };
    EXPECT_THROW(static_cast<void>(check(map, with_radius(-1), {})), std::exception);
    EXPECT_THROW(static_cast<void>(check(map, with_radius(1e300), {})), std::exception);
    EXPECT_THROW(static_cast<void>(check(map, {}, {}, 1)), std::exception);
    EXPECT_THROW(static_cast<void>(check(map, {{}, {.breach_time = {.per_cell = -1}}}, {})), std::exception);
}

}  // namespace
}  // namespace waybreaker

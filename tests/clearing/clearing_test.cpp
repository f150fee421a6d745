// Vehicles that clear the way for others.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "abilities.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double reached(const Mission& mission, const Plan& plan) {
    return plan.status == PlanStatus::solved ? value(plan.after, mission.rules.objective).value() : infinity;
}

struct World {
    Map map;
    Mission mission;
};

// One or two that clear, up to two others that drive, perhaps an aircraft.
World any_world(int side) {
    const PlainMap plain = *random_map(side, side);
    World world{Map(plain.grid()), {}};
    const auto add = [&](const std::string& id, int own_breaches) {
        Agent agent =
            vehicle(id, any_free_cell(plain), any_free_cell(plain), *rc::gen::element(0.0, 0.4, 0.5, 0.5, 0.9));
        agent.speed = *rc::gen::element(0.5, 1.0, 2.0);
        agent.ready_at = *rc::gen::element(0.0, 0.0, 3.0);
        agent.weight = *rc::gen::element(1.0, 1.0, 3.0);
        agent.own_breaches = own_breaches;
        world.mission.agents.push_back(agent);
    };
    const int clearing = *rc::gen::element(1, 1, 1, 2);
    for (int i = 0; i < clearing; ++i) add("dozer" + std::to_string(i), *number(1, 3));
    const int others = *number(0, 2);
    for (int i = 0; i < others; ++i) add("rover" + std::to_string(i), 0);
    if (*number(0, 3) == 0 || world.mission.agents.size() == 1)
        world.mission.agents.push_back(aircraft("heli", any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 2.0)));
    Rules& rules = world.mission.rules;
    rules.removals = *number(0, 3);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time = {*rc::gen::element(0.0, 1.0, 4.0), *rc::gen::element(0.0, 0.0, 0.25)};
    if (*number(0, 3) == 0) rules.rubble = *rc::gen::element(0.5, 2.0);
    if (!world.map.obstacles().empty()) {
        if (*number(0, 3) == 0) rules.opened = {{{1}, *rc::gen::element(0.0, 2.0, 9.0)}};
        if (*number(0, 3) == 0) rules.protect = {world.map.obstacles().back().id};
        if (*number(0, 3) == 0) rules.budget = *number(0, 12);
        if (*number(0, 5) == 0) rules.force = {{1}};
    }
    if (*number(0, 2) == 0) give_abilities(world.map, world.mission, [](int count) { return *number(0, count - 1); });
    try {
        validate(world.map, world.mission, {}, {});
    } catch (const InputError&) {
        RC_DISCARD("two stand too near or have no room, or what is forced is protected");
    }
    return world;
}

RC_GTEST_PROP(Clearing, IsValidAndNoWorseThanToClearNothing, ()) {
    const World world = any_world(12);
    const Method method{.explain = *number(0, 3) == 0};
    const Plan plan = Planner().plan(world.map, world.mission, method);
    Mission none = world.mission;
    for (Agent& agent : none.agents) agent.own_breaches = 0;
    none.rules.force.clear();
    const Plan without = Planner().plan(world.map, none);
    RC_CLASSIFY(plan.status == PlanStatus::solved);
    RC_CLASSIFY(!plan.breaches.empty() && plan.breaches.front().by.starts_with("dozer"));
    if (world.mission.rules.force.empty())
        RC_ASSERT(reached(world.mission, plan) <= reached(none, without) * (1 + 1e-9));
    RC_ASSERT(plan_faults(world.map, world.mission, plan) == "");
    if (plan.bound) RC_ASSERT(*plan.bound <= reached(world.mission, plan) * (1 + 1e-9));
}

RC_GTEST_PROP(Clearing, HasOnePlanWhateverTheOrderOfAgents, ()) {
    const World world = any_world(10);
    Mission turned = world.mission;
    std::ranges::reverse(turned.agents);
    const Plan plan = Planner().plan(world.map, world.mission);
    const Plan other = Planner().plan(world.map, turned);
    RC_ASSERT(plan.status == other.status);
    RC_ASSERT(reached(world.mission, plan) == reached(turned, other));
}

// One that clears and one that drives, where they are not in each other's way: the best of all
// tours of up to two obstacles, whatever the cells it breaches them from.
class AllTours {
  public:
    AllTours(const Map& map, const Mission& mission) : map_(map), mission_(mission) {}

    double best() {
        const Agent& dozer = mission_.agents.front();
        go_on(dozer.start, dozer.ready_at, {});
        return best_;
    }

  private:
    double length(Cell from, Cell to, const std::vector<ObstacleId>& open) {
        const CrossingResult way = searcher_.find(map_, from, to, {.body = {}, .removed = open});
        return way.status == SearchStatus::found ? way.best.length : infinity;
    }

    // Those beside it, or, where its reach is longer, all within that.
    std::vector<Cell> places_for(ObstacleId id) const {
        const double reach = mission_.agents.front().body.reach() + mission_.agents.front().reach;
        if (mission_.agents.front().reach <= 1) return map_.boundary(id);
        std::vector<Cell> places;
        for (Cell place; place.y < map_.height(); ++place.y) {
            for (place.x = 0; place.x < map_.width(); ++place.x) {
                if (is_near(place, id, reach)) places.push_back(place);
            }
        }
        return places;
    }

    bool is_near(Cell place, ObstacleId id, double reach) const {
        for (Cell c; c.y < map_.height(); ++c.y) {
            for (c.x = 0; c.x < map_.width(); ++c.x) {
                if (map_.obstacle_at(c) != id) continue;
                const double dx = std::max(std::abs(c.x - place.x) - 0.5, 0.0);
                const double dy = std::max(std::abs(c.y - place.y) - 0.5, 0.0);
                if (std::hypot(dx, dy) <= reach) return true;
            }
        }
        return false;
    }

    void go_on(Cell at, double time, const std::vector<TimedOpening>& openings) {
        std::vector<ObstacleId> open;
        for (const TimedOpening& opening : openings) open.push_back(opening.obstacle);
        const Agent& dozer = mission_.agents.front();
        const double home = time + length(at, dozer.goal, open) / dozer.speed;
        if (std::isfinite(home)) {
            Mission rest{{mission_.agents.back()}, mission_.rules};
            rest.rules.opened = openings;
            rest.rules.removals = 0;
            const Plan plan = planner_.plan(map_, rest);
            if (plan.status == PlanStatus::solved) {
                const double arrival = *plan.after.makespan;
                const bool sums = mission_.rules.objective == Objective::flowtime;
                best_ = std::min(best_, sums ? arrival + home : std::max(arrival, home));
            }
        }
        if (std::ssize(openings) == mission_.removals_allowed()) return;
        for (const Obstacle& obstacle : map_.obstacles()) {
            if (std::ranges::count(open, obstacle.id) > 0) continue;
            const double stay = time_to_breach(dozer, obstacle, mission_.rules);
            for (const Cell place : places_for(obstacle.id)) {
                const ObstacleId in = map_.obstacle_at(place);
                if (in && std::ranges::count(open, in) == 0) continue;
                const double there = time + length(at, place, open) / dozer.speed;
                if (!(there < best_)) continue;
                std::vector<TimedOpening> more = openings;
                more.push_back({obstacle.id, there + stay});
                go_on(place, more.back().at, more);
            }
        }
    }

    const Map& map_;
    const Mission& mission_;
    CrossingSearcher searcher_;
    Planner planner_;
    double best_ = infinity;
};

struct Drawn {
    Map map;
    Mission mission;
};

// Not by RapidCheck: the same worlds every time, so that what is found of them is a figure.
Drawn drawn_pair(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto draw = [&](std::uint32_t most) { return int(random() % most); };
    constexpr int side = 9;
    Grid grid(side, side);
    for (int i = 0; i < 4; ++i) {
        const bool down = draw(2) == 0;
        const int at = 1 + draw(side - 2);
        const int from = draw(4);
        for (int k = from; k < from + 5; ++k) grid.set_blocked(down ? Cell{at, k} : Cell{k, at}, true);
    }
    const Map map(grid);
    const auto any_free = [&] {
        for (;;) {
            const Cell c{draw(side), draw(side)};
            if (!map.grid().blocked(c)) return c;
        }
    };
    const Cell dozer_start = any_free();
    const Cell dozer_goal = any_free();
    const Cell rover_start = any_free();
    const Cell rover_goal = any_free();
    Mission mission{{vehicle("dozer", dozer_start, dozer_goal), vehicle("rover", rover_start, rover_goal)}};
    mission.agents.front().own_breaches = 2;
    mission.rules.removals = 2;
    mission.rules.collisions = false;
    mission.rules.breach_time.per_obstacle = draw(3);
    mission.rules.objective = draw(2) == 0 ? Objective::makespan : Objective::flowtime;
    return {map, mission};
}

void compare_with_all_tours(std::uint32_t seeds, const std::function<void(std::uint32_t, Drawn&)>& change) {
    int as_good = 0;
    int solved = 0;
    double excess = 0;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        Drawn drawn = drawn_pair(seed);
        change(seed, drawn);
        const Plan plan = Planner().plan(drawn.map, drawn.mission);
        EXPECT_TRUE(is_valid(drawn.map, drawn.mission, plan)) << seed;
        const double best = AllTours(drawn.map, drawn.mission).best();
        ASSERT_EQ(plan.status == PlanStatus::solved, std::isfinite(best)) << seed;
        if (plan.status != PlanStatus::solved) continue;
        ASSERT_TRUE(plan.bound.has_value()) << seed;
        EXPECT_LE(*plan.bound, best * (1 + 1e-9)) << seed;
        const double own = reached(drawn.mission, plan);
        ++solved;
        if (own <= best * (1 + 1e-9)) ++as_good;
        excess += own / best - 1;
    }
    EXPECT_GE(as_good, solved * 9 / 10);
    // A vehicle may stand farther from what it breaches than these do.
    EXPECT_LE(excess / solved, 0);
}

TEST(Clearing, IsHardlyWorseThanTheBestOfAllTours) {
    compare_with_all_tours(120, [](std::uint32_t, Drawn&) {});
}

TEST(Clearing, WithAbilitiesIsHardlyWorseThanTheBestOfAllTours) {
    compare_with_all_tours(60, [](std::uint32_t seed, Drawn& drawn) {
        std::mt19937 random(seed);
        give_abilities(drawn.map, drawn.mission, [&](int count) { return int(random() % unsigned(count)); });
        Agent& dozer = drawn.mission.agents.front();
        dozer.reach = std::min(std::max(dozer.reach, 1.0), 2.0);
    });
}

TEST(Clearing, ABulldozerOpensTheWayForAnother) {
    const std::string_view picture = R"(
        ......#......
        ......#......
        S.....#.....G
        ......#......
        ......#......)";
    const Map map = map_from_ascii(picture);
    Mission mission{
        {vehicle("dozer", {0, 0}, {0, 4}), vehicle("rover", mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'))}};
    mission.agents.front().own_breaches = 1;
    mission.rules.removals = 1;
    mission.rules.breach_time.per_obstacle = 7;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches.front().by, "dozer");
    EXPECT_EQ(plan.before.makespan, std::nullopt);
    // Who waits for whom.
    ASSERT_FALSE(plan.orders.empty());
    const auto opening = std::ranges::find(plan.orders, OrderReason::opening, &Order::reason);
    ASSERT_NE(opening, plan.orders.end());
    EXPECT_EQ(opening->before.agent, 0U);
    EXPECT_EQ(opening->after.agent, 1U);
    ASSERT_FALSE(plan.agents[1].waits.empty());
    EXPECT_EQ(plan.agents[1].waits.front().agent, "dozer");
    ASSERT_FALSE(plan.agents[0].waits.empty());
    EXPECT_EQ(plan.agents[0].waits.front().agent, "dozer");
}

TEST(Clearing, SelectsNothingButWhatIsForcedWhereNothingIsToBeSelected) {
    const Map map = Map::from_rows({"....A....B....", "....A....B....", "..............", "....A....B...."});
    Mission mission{{vehicle("dozer", {0, 0}, {0, 3}), vehicle("rover", {0, 1}, {13, 0})}};
    mission.agents.front().own_breaches = 2;
    mission.rules.removals = 2;
    const Method none{.select = Selection::none};
    EXPECT_TRUE(Planner().plan(map, mission, none).breaches.empty());
    EXPECT_FALSE(Planner().plan(map, mission).breaches.empty());
    mission.rules.force = {map.obstacle_at({4, 0})};
    const Plan forced = Planner().plan(map, mission, none);
    EXPECT_TRUE(is_valid(map, mission, forced));
    ASSERT_EQ(forced.breaches.size(), 1U);
    EXPECT_EQ(forced.breaches.front().obstacle, mission.rules.force.front());
}

TEST(Clearing, AnAircraftAndABulldozerShareTheWork) {
    const std::string_view picture = R"(
        ....#....#....#....
        S...#....#....#...G
        ....#....#....#....
        ....#....#....#....)";
    const Map map = map_from_ascii(picture);
    Mission mission{{vehicle("dozer", {0, 3}, {18, 3}),
                     vehicle("rover", mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G')),
                     aircraft("heli", mark_in_ascii(picture, 'G'))}};
    mission.agents[0].own_breaches = 3;
    mission.agents[2].breaches = 2;
    mission.rules.removals = 3;
    mission.rules.breach_time.per_obstacle = 10;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    ASSERT_EQ(plan.breaches.size(), 3U);
    EXPECT_EQ(std::ranges::count(plan.breaches, "dozer", &Breach::by), 1);
    EXPECT_EQ(std::ranges::count(plan.breaches, "heli", &Breach::by), 2);
}

// Each is at the crossing at the same time, on its way to what it has to open for itself.
TEST(Clearing, TwoDoNotMeetOnTheirWays) {
    const Map map = Map::from_rows({".........", ".........", ".........", ".......AA", ".......A.", ".......AA",
                                    ".........", "...BBB...", "...B.B..."});
    Mission mission{{vehicle("across", {0, 4}, {8, 4}), vehicle("down", {4, 0}, {4, 8})}};
    for (Agent& agent : mission.agents) agent.own_breaches = 1;
    mission.rules.removals = 2;
    mission.rules.breach_time.per_obstacle = 3;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_TRUE(is_valid(map, mission, plan));
    EXPECT_EQ(plan.breaches.size(), 2U);
}

// Its own goal is walled in.
TEST(Clearing, OneThatCannotArriveStaysWhereItHasBreachedItsLast) {
    const Map map = map_from_ascii(R"(
        ...a....
        ...a.bbb
        ...a.b.b
        ...a.bbb)");
    Mission mission{{vehicle("dozer", {0, 2}, {6, 2}), vehicle("van", {0, 0}, {7, 0})}};
    mission.agents[0].own_breaches = 1;
    Rules& rules = mission.rules;
    rules.removals = 1;
    rules.objective = Objective::flowtime;
    rules.collisions = false;
    rules.unreached = 30;
    rules.protect = {map.obstacle_at({5, 1})};
    const Plan plan = Planner().plan(map, mission);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches[0].by, "dozer");
    EXPECT_TRUE(plan.agents[1].reached);
    const Itinerary& dozer = plan.agents[0];
    EXPECT_FALSE(dozer.reached);
    EXPECT_DOUBLE_EQ(dozer.path.back().t, 30);
    Plan elsewhere = plan;
    elsewhere.agents[0].path.back().y += 1;
    EXPECT_NE(plan_faults(map, mission, elsewhere).find("is not reached, and ends elsewhere"), std::string::npos);
}

TEST(Clearing, RefusesWhatItCannotPlan) {
    const Map map(Grid(8, 8));
    Mission mission{{vehicle("dozer", {0, 0}, {7, 7}), vehicle("rover", {0, 3}, {7, 3})}};
    mission.agents.front().own_breaches = 2;
    const std::string who = "the dozer agent breaches from the ground: ";
    const auto error = [&] { return input_error([&] { Planner().plan(map, mission); }); };
    mission.rules.minimise_demolition = 0.1;
    EXPECT_EQ(error(), who + "demolition is minimised where only aircraft breach");
    mission.rules.minimise_demolition.reset();
    mission.rules.timing = Timing::ignore;
    EXPECT_EQ(error(), who + "that takes time, so timing must be enforced");
}

}  // namespace
}  // namespace waybreaker

// A ground agent that breaches what is in its way itself.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "abilities.hpp"
#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "input_error.hpp"
#include "map/line_of_sight.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double none_gets_there = std::numeric_limits<double>::infinity();

Mission any_own_way(const PlainMap& plain, const Map& map) {
    Mission mission{{vehicle("dozer", any_free_cell(plain), any_free_cell(plain))}};
    Agent& dozer = mission.agents.front();
    dozer.speed = *rc::gen::element(0.5, 1.0, 2.0);
    dozer.ready_at = *rc::gen::element(0.0, 0.0, 3.0);
    dozer.body.radius = *rc::gen::element(0.0, 0.0, 0.3, 0.5);
    dozer.own_breaches = *number(1, 4);
    mission.rules.removals = *number(0, 4);
    mission.rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    mission.rules.breach_time = {*rc::gen::element(0.0, 1.0, 4.0), *rc::gen::element(0.0, 0.0, 0.25)};
    if (*number(0, 1) == 0) give_abilities(map, mission, [](int count) { return *number(0, count - 1); });
    return mission;
}

// When the agent is at its goal past the best of all sets of so many obstacles, by one search for each.
double best_of_all_sets(const Map& map, const Mission& mission, int most) {
    const Agent& driver = mission.agents.front();
    const std::size_t obstacles = map.obstacles().size();
    CrossingSearcher searcher;
    double best = none_gets_there;
    for (std::uint32_t set = 0; set < (1U << obstacles); ++set) {
        if (std::popcount(set) > most) continue;
        std::vector<ObstacleId> removed;
        double stays = 0;
        for (std::uint32_t i = 0; i < obstacles; ++i) {
            if ((set >> i & 1U) == 0) continue;
            removed.push_back({i + 1});
            const Obstacle& obstacle = map.obstacle({i + 1});
            const BreachTime& by_rules = mission.rules.breach_time;
            stays += driver.breach_time.value_or(by_rules.per_obstacle) +
                     driver.breach_time_per_cell.value_or(by_rules.per_cell) * obstacle.cells;
            const std::optional<CanBreach>& can = driver.can_breach;
            if (can && obstacle.cells > can->most_cells) stays = none_gets_there;
            if (can && can->only && std::ranges::count(*can->only, obstacle.id) == 0) stays = none_gets_there;
        }
        const CrossingResult way =
            searcher.find(map, driver.start, driver.goal, {.body = driver.body, .removed = removed});
        if (way.status != SearchStatus::found) continue;
        best = std::min(best, driver.ready_at + way.best.length / driver.speed + stays);
    }
    return best;
}

RC_GTEST_PROP(OwnWay, OfAPointIsTheBestOfAllSets, ()) {
    const PlainMap plain = *random_map(9, 8);
    const Map map(plain.grid());
    RC_PRE(map.obstacles().size() <= 9U);
    Mission mission = any_own_way(plain, map);
    mission.agents.front().body = point_body;
    const Plan plan = Planner().plan(map, mission);
    const double best = best_of_all_sets(map, mission, mission.removals_allowed());
    RC_ASSERT((plan.status == PlanStatus::solved) == std::isfinite(best));
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_ASSERT(std::abs(*plan.after.makespan - best) <= 1e-9 * (1 + best));
    RC_ASSERT(*plan.gap <= 1e-9);
}

RC_GTEST_PROP(OwnWay, IsValidAndNoWorseThanToBreachNothing, ()) {
    const PlainMap plain = *random_map(16, 14);
    const Map map(plain.grid());
    Mission mission = any_own_way(plain, map);
    Agent& dozer = mission.agents.front();
    dozer.body.radius = *rc::gen::element(0.0, 0.3, 0.5, 0.8, 1.2);
    RC_PRE(fits(OpenedMap(map), dozer.start, dozer.body) && fits(OpenedMap(map), dozer.goal, dozer.body));
    if (!map.obstacles().empty()) {
        if (*number(0, 2) == 0) mission.rules.opened = {{{1}, *rc::gen::element(0.0, 2.0, 9.0)}};
        if (*number(0, 2) == 0) mission.rules.protect = {map.obstacles().back().id};
        if (*number(0, 2) == 0) mission.rules.budget = *number(0, 12);
    }
    const Method method{.select = *rc::gen::element(Selection::exact, Selection::greedy, Selection::hits),
                        .explain = *rc::gen::arbitrary<bool>()};
    const Plan plan = Planner().plan(map, mission, method);
    Mission none = mission;
    none.rules.removals = 0;
    const Plan without = Planner().plan(map, none, method);
    if (without.status == PlanStatus::solved) RC_ASSERT(plan.status == PlanStatus::solved);
    if (plan.status != PlanStatus::solved) return;
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    if (without.status == PlanStatus::solved) RC_ASSERT(*plan.after.makespan <= *without.after.makespan * (1 + 1e-9));
    for (const Breach& breach : plan.breaches) RC_ASSERT(breach.by == "dozer");
}

RC_GTEST_PROP(OwnWay, MoreBreachesNeverCostMore, ()) {
    const PlainMap plain = *random_map(14, 12);
    const Map map(plain.grid());
    Mission mission = any_own_way(plain, map);
    double last = none_gets_there;
    for (mission.rules.removals = 0; mission.rules.removals < 4; ++mission.rules.removals) {
        const Plan plan = Planner().plan(map, mission);
        const double reached = plan.after.makespan.value_or(none_gets_there);
        RC_ASSERT(reached <= last * (1 + 1e-9));
        last = reached;
    }
}

TEST(OwnWay, BreaksTheThinWallAndWaitsForIt) {
    const std::string_view picture = R"(
        ......#......
        ......#......
        S.....#.....G
        ......#......
        ......#......)";
    const Map map = map_from_ascii(picture);
    Mission mission{{vehicle("dozer", mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'))}};
    mission.agents.front().body.radius = 0.5;
    mission.agents.front().own_breaches = 1;
    mission.rules.breach_time.per_obstacle = 7;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    EXPECT_EQ(plan_faults(map, mission, plan), "");
    ASSERT_EQ(plan.breaches.size(), 1U);
    EXPECT_EQ(plan.breaches.front().by, "dozer");
    EXPECT_EQ(plan.breaches.front().at, (Cell{5, 2}));
    EXPECT_DOUBLE_EQ(*plan.breaches.front().begun_at, 5);
    EXPECT_DOUBLE_EQ(plan.breaches.front().cleared_at, 12);
    EXPECT_DOUBLE_EQ(*plan.after.makespan, 19);
    ASSERT_EQ(plan.agents.front().waits.size(), 1U);
    EXPECT_EQ(plan.agents.front().waits.front().reason, WaitReason::opening);
    EXPECT_EQ(plan.agents.front().waits.front().agent, "dozer");
}

TEST(OwnWay, RefusesWhatCannotBePlannedYet) {
    const Map map(Grid(8, 8));
    Mission mission{{vehicle("dozer", {0, 0}, {7, 7})}};
    mission.agents.front().own_breaches = 2;
    const std::string who = "the dozer agent breaches what is in its way itself: ";
    const auto error = [&] { return input_error([&] { Planner().plan(map, mission); }); };
    mission.rules.timing = Timing::ignore;
    EXPECT_EQ(error(), who + "that takes time, so timing must be enforced");
}

}  // namespace
}  // namespace waybreaker

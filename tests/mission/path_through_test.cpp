// The way of one agent that breaks what is in its way: against every set of obstacles, and own geometry.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "ascii_map.hpp"
#include "crossing/crossing_case.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double unpayable = std::numeric_limits<double>::infinity();
constexpr std::size_t few_obstacles = 8;

struct BreakingCase {
    CrossingCase problem = {.map = Map(Grid(1, 1)), .start = {}, .goal = {}};
    std::vector<double> costs{0};  // by id

    double of(const Obstacle& obstacle) const { return costs[obstacle.id.value]; }
    PathThrough way(double weight = 1) const {
        return Planner().path_through(problem.map, problem.start, problem.goal,
                                      [this](const Obstacle& wall) { return of(wall); },
                                      {.body = problem.body, .weight = weight});
    }
    // Each set of obstacles broken in turn.
    double least() const {
        const slow::CrossingOracle oracle = problem.oracle();
        double least = unpayable;
        for (const slow::Set set : problem.choices()) {
            double cost = oracle.shortest(set);
            for (const Obstacle& wall : problem.map.obstacles()) cost += set >> wall.id.value & 1 ? of(wall) : 0;
            least = std::min(least, cost);
        }
        return least;
    }
};

BreakingCase any_breaking(const std::vector<Body>& bodies) {
    BreakingCase drawn;
    if (*number(0, 1) == 0) {
        drawn.problem = *any_walls();
    } else {
        drawn.problem.map = random_label_map(9);
        const PlainMap map = plain(drawn.problem.map);
        drawn.problem.start = *number(0, 15) == 0 ? any_cell(map) : any_free_cell(map);
        drawn.problem.goal = any_free_cell(map);
    }
    const std::size_t obstacles = drawn.problem.map.obstacles().size();
    RC_PRE(obstacles <= few_obstacles);
    drawn.problem.body = *rc::gen::elementOf(bodies);
    drawn.problem.relaxed = false;
    drawn.problem.crossings = int(obstacles);
    drawn.problem.budget = unpayable;
    for (std::size_t i = 0; i < obstacles; ++i) {
        drawn.costs.push_back(*number(0, 7) == 0 ? unpayable : 0.25 * *number(0, 16));
    }
    return drawn;
}

double distance_to(const Map& map, ObstacleId id, Point at) {
    double least = unpayable;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (map.obstacle_at(c) != id) continue;
            const double dx = std::max(std::abs(at.x - c.x) - 0.5, 0.0);
            const double dy = std::max(std::abs(at.y - c.y) - 0.5, 0.0);
            least = std::min(least, std::hypot(dx, dy));
        }
    }
    return least;
}

// Whether the disc meets nothing on the way but what is broken, looked at 64 times a leg.
bool keeps_clear(const Map& map, const PathThrough& way, double radius) {
    for (const Obstacle& wall : map.obstacles()) {
        const auto is_wall = [&wall](const Broken& broken) { return broken.obstacle == wall.id; };
        if (std::ranges::any_of(way.broken, is_wall)) continue;
        for (std::size_t i = 1; i < way.path.size(); ++i) {
            for (int step = 0; step <= 64; ++step) {
                const double share = step / 64.0;
                const Point a = way.path[i - 1];
                const Point b = way.path[i];
                const Point at{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
                if (distance_to(map, wall.id, at) < radius - 1e-9) return false;
            }
        }
    }
    return true;
}

RC_GTEST_PROP(PathThrough, OfAPointIsTheCheapestOfAllSets, ()) {
    const BreakingCase drawn = any_breaking({point_body});
    const PathThrough way = drawn.way();
    const double least = drawn.least();
    RC_CLASSIFY(least == unpayable, "no way");
    RC_CLASSIFY(way.broken.size() == 1, "one broken");
    RC_CLASSIFY(way.broken.size() > 1, "several broken");
    RC_ASSERT((way.status == PlanStatus::no_plan) == (least == unpayable));
    if (least == unpayable) return;
    RC_ASSERT(same_length(way.cost, least));
    RC_ASSERT(same_length(way.bound, least));
    for (const Broken& broken : way.broken)
        RC_ASSERT(distance_to(drawn.problem.map, broken.obstacle, broken.at) < 1e-9);
}

RC_GTEST_PROP(PathThrough, OfADiscIsNoDearerThanItsSquares, ()) {
    const BreakingCase drawn = any_breaking({Body{}});
    const PathThrough way = drawn.way();
    const double least = drawn.least();
    RC_ASSERT((way.status == PlanStatus::no_plan) == (least == unpayable));
    if (least == unpayable) return;
    RC_ASSERT(way.cost <= least * (1 + 1e-9));
    RC_ASSERT(same_length(way.bound, least));
    RC_ASSERT(keeps_clear(drawn.problem.map, way, 0.5));
    for (const Broken& broken : way.broken)
        RC_ASSERT(std::abs(distance_to(drawn.problem.map, broken.obstacle, broken.at) - 0.5) < 1e-6);
}

RC_GTEST_PROP(PathThrough, IsSoManyTimesAsDearAtMost, ()) {
    const BreakingCase drawn = any_breaking({point_body, Body{}});
    const PathThrough best = drawn.way();
    const PathThrough soon = drawn.way(1.5);
    RC_ASSERT(best.status == soon.status);
    if (best.status == PlanStatus::solved) RC_ASSERT(soon.cost <= 1.5 * best.bound * (1 + 1e-9));
}

TEST(PathThrough, SaysWhichWallToBreakAndFromWhere) {
    const Map map = Map::from_rows({
        "....A..B.",
        "....A..B.",
        "....A..B.",
        ".......B.",
    });
    const auto cheap = [](const Obstacle& wall) { return wall.cells == 3 ? 2.0 : 3.0; };
    const PathThrough way = Planner().path_through(map, {0, 0}, {8, 0}, cheap);
    ASSERT_EQ(way.status, PlanStatus::solved);
    ASSERT_EQ(way.broken.size(), 2U);
    EXPECT_EQ(way.broken[0].obstacle, map.obstacle_at({4, 0}));
    EXPECT_EQ(way.broken[0].at, Point(3, 0));
    EXPECT_EQ(way.broken[1].at, Point(6, 0));
    EXPECT_EQ(way.length, 8);
    EXPECT_EQ(way.cost, 13);
    // Around A, where that costs less than to break it.
    const auto dear = [](const Obstacle& wall) { return wall.cells == 3 ? 9.0 : 3.0; };
    const PathThrough around = Planner().path_through(map, {0, 0}, {8, 0}, dear);
    ASSERT_EQ(around.broken.size(), 1U);
    EXPECT_EQ(around.broken[0].obstacle, map.obstacle_at({7, 0}));
}

TEST(PathThrough, BreaksNothingThatCostsInfinitelyMuch) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    const auto never = [](const Obstacle&) { return unpayable; };
    EXPECT_EQ(Planner().path_through(map, {0, 1}, {4, 1}, never).status, PlanStatus::no_plan);
}

TEST(PathThrough, RefusesACostBelowZero) {
    const Map map = Map::from_rows({"..A..", "..A..", "..A.."});
    for (const double wrong : {-1.0, std::nan("")}) {
        EXPECT_THROW((void)Planner().path_through(map, {0, 1}, {4, 1}, [=](const Obstacle&) { return wrong; }),
                     InputError);
    }
}

}  // namespace
}  // namespace waybreaker

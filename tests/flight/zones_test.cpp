// Tours round zones, against every order and every cell.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "flight/brute_force.hpp"
#include "flight/local_search.hpp"
#include "flight/long_tour.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Over all orders and cells, as far as `air` says it is.
double slow_tour(const World& world, const Airspace& air, Point at, std::vector<ObstacleId> left) {
    if (left.empty()) return air.length(at, world.goal);
    double least = infinity;
    for (std::size_t i = 0; i < left.size(); ++i) {
        std::vector<ObstacleId> rest = left;
        rest.erase(rest.begin() + std::ptrdiff_t(i));
        for (const Cell c : slow_boundary(world.map, left[i])) {
            const double there = air.allows(c) ? air.length(at, c) : infinity;
            if (std::isfinite(there)) least = std::min(least, there + slow_tour(world, air, c, rest));
        }
    }
    return least;
}

// Two stops in the hole of a zone: whichever way round, there is none.
TEST(FlyRoundZones, TheSearchForABetterTourEndsWhereThereIsNoWay) {
    const std::vector<Zone> zones{{.polygon = {{{2, 2}, {9, 2}, {9, 9}, {2, 9}}, {{3, 3}, {8, 3}, {8, 8}, {3, 8}}}}};
    const Airspace air(zones, 11, 11);
    const std::vector<Target> targets{{{1}, {{4, 4}}}, {{2}, {{6, 6}}}};
    const Tour tour = improved_tour({0, 0}, {{0, {4, 4}}, {1, {6, 6}}}, {10, 10}, targets, air);
    EXPECT_EQ(tour.size(), 2U);
}

RC_GTEST_PROP(FlyRoundZones, IsTheShortestPastUpToThreeObstacles, ()) {
    const World world = *arbitrary_world(20, 20, *uniform(0, 4), 4);
    const std::vector<Zone> zones = any_zones(4, 20);
    const Airspace air(zones, 20, 20);
    RC_PRE(air.allows(world.start) && air.allows(world.goal) && std::isfinite(air.length(world.start, world.goal)));
    const double slow = slow_tour(world, air, world.start, world.ids);
    RC_PRE(std::isfinite(slow));
    const Flight flight = fly_optimal(world.map, world.start, world.goal, world.ids, air);
    RC_ASSERT(std::abs(flight.length - slow) < 1e-9);
    const Flight nearest = fly_nearest(world.map, world.start, world.goal, world.ids, air);
    RC_ASSERT(nearest.length >= slow - 1e-9);
    double flown = 0;
    Point at = world.start;
    for (const BreachPoint& breach : flight.breaches) {
        RC_ASSERT(air.allows(breach.at));
        flown += air.length(at, breach.at);
        at = breach.at;
    }
    RC_ASSERT(std::abs(flown + air.length(at, world.goal) - flight.length) < 1e-9);
}

RC_GTEST_PROP(FlyRoundZones, LongToursAreNoLongerThanTheNearestOne, ()) {
    const World world = *arbitrary_world(30, 30, *uniform(9, 14), 3);
    const std::vector<Zone> zones = any_zones(4, 30);
    const Airspace air(zones, 30, 30);
    RC_PRE(air.allows(world.start) && air.allows(world.goal) && std::isfinite(air.length(world.start, world.goal)));
    for (const ObstacleId id : world.ids) {
        const auto reached = [&](Cell c) { return air.allows(c) && std::isfinite(air.length(world.start, c)); };
        RC_PRE(std::ranges::any_of(slow_boundary(world.map, id), reached));
    }
    const Flight flight = fly_optimal(world.map, world.start, world.goal, world.ids, air);
    RC_ASSERT(flight.length <= fly_nearest(world.map, world.start, world.goal, world.ids, air).length + 1e-9);
}

}  // namespace
}  // namespace waybreaker

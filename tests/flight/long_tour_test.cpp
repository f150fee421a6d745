// Flights past more obstacles than the exact method takes.
#include "flight/long_tour.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <span>

#include "flight/best_cells.hpp"
#include "flight/brute_force.hpp"
#include "flight/exact.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(LongFlight, IsValidAndNeverLongerThanNearest, ()) {
    const World world = *arbitrary_world(80, 80, *uniform(9, 30), 12);
    const Flight flight = fly_optimal(world.map, world.start, world.goal, world.ids);
    expect_valid(world.map, world.start, world.goal, world.ids, flight);
    RC_ASSERT(flight.length <= fly_nearest(world.map, world.start, world.goal, world.ids).length + 1e-9);
    RC_ASSERT(flight.breaches == fly_optimal(world.map, world.start, world.goal, world.ids).breaches);
}

// On as many obstacles as can be proven it stays within a quarter of the shortest, and is it where one window holds
// all.
RC_GTEST_PROP(LongFlight, IsCloseToTheShortest, ()) {
    const World world = *arbitrary_world(80, 80, *uniform(1, 9), 12);
    const std::vector<Target> targets = targets_of(world.map, world.ids);
    const Tour nearest = nearest_tour(world.start, world.goal, targets);
    const auto length = [&](const Tour& tour) { return tour_length(world.start, tour, world.goal); };
    const double exact = length(shortest_tour(world.start, world.goal, targets, nearest));
    const double good = length(good_tour(world.start, world.goal, targets, nearest));
    RC_ASSERT(good >= exact - 1e-9);
    RC_ASSERT(good <= 1.25 * exact + 1e-9);
    if (targets.size() <= exact_window) RC_ASSERT(good <= exact + 1e-9);
}

// Over all boundary cells, in a given order.
double shortest_in_order(const World& world, const Tour& order, std::span<const Target> targets, std::size_t stop = 0) {
    const Cell from = stop > 0 ? order[stop - 1].at : world.start;
    if (stop == order.size()) return distance(from, world.goal);
    double least = std::numeric_limits<double>::infinity();
    Tour tour = order;
    for (const Cell c : targets[order[stop].target].cells) {
        tour[stop].at = c;
        least = std::min(least, distance(from, c) + shortest_in_order(world, tour, targets, stop + 1));
    }
    return least;
}

RC_GTEST_PROP(LongFlight, HasTheBestCellsForItsOrder, ()) {
    const World world = *arbitrary_world(16, 12, *uniform(0, 4), 4);
    const std::vector<Target> targets = targets_of(world.map, world.ids);
    Tour tour = nearest_tour(world.start, world.goal, targets);
    choose_best_cells(world.start, tour, world.goal, targets);
    RC_ASSERT(tour_length(world.start, tour, world.goal) <= shortest_in_order(world, tour, targets) + 1e-9);
}

}  // namespace
}  // namespace waybreaker

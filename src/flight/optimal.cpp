// The shortest flight that breaches every obstacle.
#include "flight/exact.hpp"
#include "flight/local_search.hpp"
#include "flight/long_tour.hpp"

namespace waybreaker {

Flight fly_optimal(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles,
                   const Airspace& air) {
    const std::vector<Target> targets = targets_of(map, obstacles, air, start);
    const Tour nearest = nearest_tour(start, goal, targets);
    const Tour tour = targets.size() <= exact_flight_limit
                          ? shortest_tour(start, goal, targets, improved_tour(start, nearest, goal, targets, air), air)
                          : good_tour(start, goal, targets, nearest, air);
    return flight_of(start, tour, goal, targets, air);
}

}  // namespace waybreaker

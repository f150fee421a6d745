#include "flight/target.hpp"

#include <algorithm>
#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker {

std::vector<Target> targets_of(const Map& map, std::span<const ObstacleId> obstacles) {
    std::vector<ObstacleId> ids(obstacles.begin(), obstacles.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<Target> targets;
    targets.reserve(ids.size());
    for (const ObstacleId id : ids) {
        targets.push_back({id, map.boundary(id)});
        if (targets.back().cells.empty()) {
            throw InputError("obstacle " + std::to_string(id.value) +
                             " fills the whole map, so no cell is left to breach it from; leave it out");
        }
    }
    return targets;
}

double tour_length(Point start, const Tour& tour, Point goal) {
    double length = 0;
    Point at = start;
    for (const Stop& stop : tour) {
        length += distance(at, stop.at);
        at = stop.at;
    }
    return length + distance(at, goal);
}

Flight flight_of(Point start, const Tour& tour, Point goal, std::span<const Target> targets) {
    Flight flight;
    flight.length = tour_length(start, tour, goal);
    for (const Stop& stop : tour) flight.breaches.push_back({targets[stop.target].obstacle, stop.at});
    return flight;
}

}  // namespace waybreaker

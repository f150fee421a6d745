#include "flight/target.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker {

std::vector<Target> targets_of(const Map& map, std::span<const ObstacleId> obstacles, const Airspace& air,
                               Point start) {
    std::vector<ObstacleId> ids(obstacles.begin(), obstacles.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<Target> targets;
    targets.reserve(ids.size());
    for (const ObstacleId id : ids) {
        targets.push_back({id, map.boundary(id)});
        std::vector<Cell>& cells = targets.back().cells;
        if (cells.empty()) {
            throw InputError("obstacle " + std::to_string(id.value) +
                             " fills the whole map, so no cell is left to breach it from; leave it out");
        }
        if (air.is_open()) continue;
        std::erase_if(cells, [&](Cell c) { return !air.allows(c) || !std::isfinite(air.length(start, c)); });
        if (cells.empty()) {
            throw InputError("the zones leave no way to a cell beside obstacle " + std::to_string(id.value) +
                             ", to breach it from; leave it out");
        }
    }
    return targets;
}

double tour_length(Point start, const Tour& tour, Point goal, const Airspace& air) {
    double length = 0;
    Point at = start;
    for (const Stop& stop : tour) {
        length += air.length(at, stop.at);
        at = stop.at;
    }
    return length + air.length(at, goal);
}

Flight flight_of(Point start, const Tour& tour, Point goal, std::span<const Target> targets, const Airspace& air) {
    Flight flight;
    flight.length = tour_length(start, tour, goal, air);
    for (const Stop& stop : tour) flight.breaches.push_back({targets[stop.target].obstacle, stop.at});
    return flight;
}

}  // namespace waybreaker

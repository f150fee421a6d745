#include "model/rubble.hpp"

#include <array>

#include "model/timeline.hpp"

namespace waybreaker {

std::vector<std::size_t> rubble_on(const Map& map, std::span<const Waypoint> path, const Body& body,
                                   std::span<const ObstacleId> obstacles) {
    std::vector<std::size_t> touched(path.size(), 0);
    const std::array<Waypoint, 2> start{path.front(), path.front()};
    const double radius = standing_radius(body);
    for (const ObstacleId obstacle : obstacles) {
        const auto touch = first_touch_on(map, obstacle, path, radius);
        if (touch && !first_touch_on(map, obstacle, start, radius)) ++touched[touch->move];
    }
    return touched;
}

std::vector<Waypoint> timed_through(const Map& map, std::span<const Point> path, const Body& body, double speed,
                                    double from, const Rubble& rubble) {
    std::vector<Waypoint> driven = timed(path, speed, from);
    if (rubble.time == 0 || rubble.obstacles.empty()) return driven;
    const std::vector<std::size_t> touched = rubble_on(map, driven, body, rubble.obstacles);
    std::vector<Waypoint> stopped;
    double delay = 0;
    for (std::size_t i = 0; i < driven.size(); ++i) {
        stopped.push_back({driven[i].x, driven[i].y, driven[i].t + delay});
        if (touched[i] == 0) continue;
        delay += double(touched[i]) * rubble.time;
        stopped.push_back({driven[i].x, driven[i].y, driven[i].t + delay});
    }
    return stopped;
}

}  // namespace waybreaker

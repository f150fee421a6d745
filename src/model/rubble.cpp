#include "model/rubble.hpp"

#include <array>

#include "model/timeline.hpp"

namespace waybreaker {

bool stands_in(const Map& map, ObstacleId obstacle, Point at, const Body& body) {
    const std::array<Waypoint, 2> still{{{at.x, at.y, 0}, {at.x, at.y, 1}}};
    return first_touch(map, obstacle, still, standing_radius(body)).has_value();
}

std::vector<double> stands_on(const Map& map, std::span<const Point> path, const Body& body, const Rubble& rubble) {
    std::vector<double> stands(path.size(), 0);
    if (rubble.time == 0 || rubble.obstacles.empty()) return stands;
    const std::vector<Waypoint> driven = timed(path, 1);
    for (const ObstacleId obstacle : rubble.obstacles) {
        const auto touch = first_touch_on(map, obstacle, driven, standing_radius(body));
        if (touch && !stands_in(map, obstacle, path.front(), body)) stands[touch->move] += rubble.time;
    }
    return stands;
}

std::vector<Waypoint> timed_through(const Map& map, std::span<const Point> path, const Body& body, double speed,
                                    double from, const Rubble& rubble) {
    std::vector<Waypoint> driven = timed(path, speed, from);
    if (rubble.time == 0 || rubble.obstacles.empty()) return driven;
    const std::vector<double> stands = stands_on(map, path, body, rubble);
    std::vector<Waypoint> stopped;
    double delay = 0;
    for (std::size_t i = 0; i < driven.size(); ++i) {
        stopped.push_back({driven[i].x, driven[i].y, driven[i].t + delay});
        if (stands[i] == 0) continue;
        delay += stands[i];
        stopped.push_back({driven[i].x, driven[i].y, driven[i].t + delay});
    }
    return stopped;
}

}  // namespace waybreaker

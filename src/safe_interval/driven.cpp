#include "safe_interval/driven.hpp"

#include <algorithm>
#include <array>

#include "model/timeline.hpp"

namespace waybreaker::safe_interval {

double opened_for(const Map& map, Cell from, Cell to, double duration, const SafeIntervalOptions& options) {
    double earliest = 0;
    const std::array<Waypoint, 2> path{{{double(from.x), double(from.y), 0}, {double(to.x), double(to.y), duration}}};
    for (const TimedOpening& opening : options.openings) {
        const auto touched = first_touch(map, opening.obstacle, path, standing_radius(options.body));
        if (touched) earliest = std::max(earliest, opening.at - *touched);
    }
    return earliest;
}

std::vector<Waypoint> driven(const Map& map, std::span<const Cell> way, const SafeIntervalOptions& options) {
    const Cell start = way.front();
    std::vector<Waypoint> path{{double(start.x), double(start.y), options.since}};
    double time = options.ready_at;
    if (time > options.since) path.push_back({path[0].x, path[0].y, time});
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (way[i] == way[i - 1]) continue;
        const double duration = distance(way[i - 1], way[i]) / options.speed;
        if (const double opened = opened_for(map, way[i - 1], way[i], duration, options); opened > time) {
            time = opened;
            path.push_back({path.back().x, path.back().y, time});
        }
        time += duration;
        path.push_back({double(way[i].x), double(way[i].y), time});
    }
    return path;
}

}  // namespace waybreaker::safe_interval

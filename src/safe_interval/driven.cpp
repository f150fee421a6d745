#include "safe_interval/driven.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "model/rubble.hpp"
#include "model/timeline.hpp"

namespace waybreaker::safe_interval {

double opened_for(const Map& map, Cell from, Cell to, double duration, const SafeIntervalOptions& options) {
    double earliest = 0;
    const std::array<Waypoint, 2> path{{{double(from.x), double(from.y), 0}, {double(to.x), double(to.y), duration}}};
    for (const TimedOpening& opening : options.openings) {
        const auto touched = first_touch(map, opening.obstacle, path, standing_radius(options.body));
        if (touched) earliest = std::max(earliest, opening.at + options.rubble - *touched);
    }
    return earliest;
}

double rubble_before(const OpenedMap& map, Cell from, Cell to, const SafeIntervalOptions& options) {
    if (options.rubble == 0) return 0;
    const std::array<Waypoint, 2> move{{{double(from.x), double(from.y), 0}, {double(to.x), double(to.y), 1}}};
    const auto enters = [&](ObstacleId obstacle) {
        return first_touch(map.map(), obstacle, move, standing_radius(options.body)) &&
               !stands_in(map.map(), obstacle, from, options.body);
    };
    return options.rubble * double(std::ranges::count_if(map.removed(), enters));
}

std::vector<Waypoint> driven(const OpenedMap& map, std::span<const Cell> way, const SafeIntervalOptions& options) {
    std::vector<Cell> turns;
    std::ranges::unique_copy(way, std::back_inserter(turns));
    std::vector<double> stands(turns.size(), 0);
    if (options.rubble > 0) {
        const std::vector<Point> places(turns.begin(), turns.end());
        stands = stands_on(map.map(), places, options.body, {map.removed(), options.rubble});
    }
    std::vector<Waypoint> path{{double(turns[0].x), double(turns[0].y), options.since}};
    double time = options.ready_at;
    const auto stand_until = [&](double until) {
        time = until;
        if (time > path.back().t) path.push_back({path.back().x, path.back().y, time});
    };
    stand_until(time);
    for (std::size_t i = 1; i < turns.size(); ++i) {
        const double duration = distance(turns[i - 1], turns[i]) / options.speed;
        const double opened = opened_for(map.map(), turns[i - 1], turns[i], duration, options);
        stand_until(std::max(time + stands[i - 1], opened));
        time += duration;
        path.push_back({double(turns[i].x), double(turns[i].y), time});
    }
    return path;
}

}  // namespace waybreaker::safe_interval

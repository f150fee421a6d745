#include "schedule/own_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/rubble.hpp"
#include "model/timeline.hpp"
#include "schedule/timetable.hpp"

namespace waybreaker {
namespace {

// A stop before an obstacle, in the times of a drive without stops.
struct OwnStop {
    Touch touch;
    ObstacleId obstacle;
    bool is_breached = false;
    double opens = 0;  // by itself
    double stay = 0;   // until it is breached
    double rubble = 0;
};

// The cell in which the agent stands: at the border of two, the one outside of the obstacle.
Cell standing_cell(const Map& map, Point at, ObstacleId obstacle) {
    const Cell middle{int(std::lround(at.x)), int(std::lround(at.y))};
    Cell best = middle;
    double least = std::numeric_limits<double>::infinity();
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const Cell c{middle.x + dx, middle.y + dy};
            if (!map.grid().contains(c) || map.obstacle_at(c) == obstacle || distance(Point(c), at) >= least) continue;
            best = c;
            least = distance(Point(c), at);
        }
    }
    return best;
}

std::vector<OwnStop> stops_on(const Map& map, const Agent& driver, const Rules& rules, std::span<const Waypoint> driven,
                              std::span<const ObstacleId> removed) {
    std::vector<OwnStop> stops;
    const auto add = [&](OwnStop stop) {
        const auto touch = first_touch_on(map, stop.obstacle, driven, standing_radius(driver.body));
        if (!touch) return;
        stop.touch = *touch;
        const Point start(driven.front().x, driven.front().y);
        if (rules.rubble > 0 && !stands_in(map, stop.obstacle, start, driver.body)) stop.rubble = rules.rubble;
        stops.push_back(stop);
    };
    for (const ObstacleId obstacle : to_breach(rules, removed))
        add({.touch = {},
             .obstacle = obstacle,
             .is_breached = true,
             .stay = time_to_breach(driver, map.obstacle(obstacle), rules)});
    for (const TimedOpening& opening : rules.opened)
        add({.touch = {}, .obstacle = opening.obstacle, .opens = opening.at});
    std::ranges::stable_sort(stops, {}, [](const OwnStop& stop) { return stop.touch.time; });
    return stops;
}

}  // namespace

JointSchedule own_schedule(const Map& map, const Agent& driver, const Rules& rules, std::span<const Point> path,
                           std::span<const ObstacleId> removed) {
    const std::vector<Waypoint> driven = timed(path, driver.speed, driver.ready_at);
    const std::vector<OwnStop> stops = stops_on(map, driver, rules, driven, removed);
    JointSchedule schedule;
    const auto reach = [&](Point at, double time) {
        const Waypoint point{at.x, at.y, time};
        if (schedule.ground.empty() || schedule.ground.back() != point) schedule.ground.push_back(point);
    };
    if (driver.ready_at > 0) reach(path.front(), 0);
    double delay = 0;
    auto stop = stops.begin();
    for (std::size_t i = 0; i < driven.size(); ++i) {
        reach(path[i], driven[i].t + delay);
        for (; stop != stops.end() && stop->touch.move == i; ++stop) {
            const Point at = place_of(path, stop->touch);
            const double begun = stop->touch.time + delay;
            reach(at, begun);
            const double gone = std::max(begun + stop->stay, stop->opens);
            delay += gone - begun;
            reach(at, gone);
            delay += stop->rubble;
            reach(at, gone + stop->rubble);
            if (!stop->is_breached) continue;
            schedule.breaches.push_back({stop->obstacle, 0, standing_cell(map, at, stop->obstacle), begun, gone});
        }
    }
    for (TimedBreach& breach : schedule.breaches) {
        breach.entered_at = first_touch(map, breach.obstacle, schedule.ground, driver.body.reach());
        if (breach.entered_at) breach.entered_at = std::max(*breach.entered_at, breach.cleared_at);
    }
    return schedule;
}

}  // namespace waybreaker

// A tour in time. An aircraft waits for nobody, so its tour alone says when it is where.
#pragma once

#include <vector>

#include "flight/target.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// From when it is ready: calls visit(stop, begun, cleared) for each stop, where `cleared` is when its target is gone.
// Returns when the aircraft is at its goal. stay(target): how long it stays there, in units of time.
template <class Stay, class Visit>
double fly(const Agent& aircraft, const Tour& tour, const Stay& stay, const Visit& visit) {
    double time = aircraft.ready_at;
    Point at = aircraft.begin();
    for (const Stop& stop : tour) {
        const double begun = time + distance(at, stop.at) / aircraft.speed;
        time = begun + stay(stop.target);
        visit(stop, begun, time);
        at = stop.at;
    }
    return time + distance(at, aircraft.goal) / aircraft.speed;
}

// The path, with a point for each end of a stay.
template <class Stay>
std::vector<Waypoint> flown(const Agent& aircraft, const Tour& tour, const Stay& stay) {
    std::vector<Waypoint> path;
    const auto add = [&](Point at, double time) { path.push_back({at.x, at.y, time}); };
    add(aircraft.begin(), 0);
    if (aircraft.ready_at > 0) add(aircraft.begin(), aircraft.ready_at);
    const double home = fly(aircraft, tour, stay, [&](const Stop& stop, double begun, double cleared) {
        add(stop.at, begun);
        if (cleared > begun) add(stop.at, cleared);
    });
    add(aircraft.goal, home);
    return path;
}

}  // namespace waybreaker

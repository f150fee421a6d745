// A tour in time. An aircraft waits for nobody, so its tour alone says when it is where.
#pragma once

#include <limits>
#include <vector>

#include "flight/target.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// From when it is ready: calls visit(stop, begun, left) for each stop, where `left` is when its target is gone, or the
// battery full. Returns when the aircraft is at its goal. stay(target): how long it stays there, in units of time.
template <class Stay, class Visit>
double fly_past(const Agent& aircraft, const Tour& tour, const Stay& stay, const Visit& visit) {
    double time = aircraft.ready_at;
    Point at = aircraft.begin();
    for (const Stop& stop : tour) {
        const double begun = time + aircraft.airspace.length(at, stop.at) / aircraft.speed;
        time = begun + (stop.lands() ? aircraft.recharge.value_or(0) : stay(stop.target));
        visit(stop, begun, time);
        at = stop.at;
    }
    return time + aircraft.airspace.length(at, aircraft.goal) / aircraft.speed;
}

// The same, of targets only; infinity if the battery of one that recharges ends before a landing. Any other battery is
// judged by the time that this returns.
template <class Stay, class Visit>
double fly(const Agent& aircraft, const Tour& tour, const Stay& stay, const Visit& visit) {
    if (!aircraft.recharge) return fly_past(aircraft, tour, stay, visit);
    double off = aircraft.ready_at - aircraft.flown;
    bool is_enough = true;
    const auto land = [&](double time) {
        is_enough = is_enough && time - off <= (1 - aircraft.reserve) * aircraft.battery() * (1 + 1e-9);
    };
    const double home = fly_past(aircraft, tour, stay, [&](const Stop& stop, double begun, double left) {
        if (!stop.lands()) return visit(stop, begun, left);
        land(begun);
        off = left;
    });
    land(home);
    return is_enough ? home : std::numeric_limits<double>::infinity();
}

// The path, with a point for each end of a stay, whatever the battery, and for each bend round a zone.
template <class Stay>
std::vector<Waypoint> flown(const Agent& aircraft, const Tour& tour, const Stay& stay) {
    std::vector<Waypoint> path;
    const auto add = [&](Point at, double time) { path.push_back({at.x, at.y, time}); };
    const auto add_leg = [&](Point to, double arrival) {
        const Waypoint from = path.back();
        const std::vector<Point> way = aircraft.airspace.way({from.x, from.y}, to);
        double flown = 0;
        for (std::size_t i = 1; i + 1 < way.size(); ++i) {
            flown += distance(way[i - 1], way[i]);
            add(way[i], from.t + flown / aircraft.speed);
        }
        add(to, arrival);
    };
    add(aircraft.begin(), 0);
    if (aircraft.ready_at > 0) add(aircraft.begin(), aircraft.ready_at);
    const double home = fly_past(aircraft, tour, stay, [&](const Stop& stop, double begun, double left) {
        add_leg(stop.at, begun);
        if (left > begun) add(stop.at, left);
    });
    add_leg(aircraft.goal, home);
    return path;
}

}  // namespace waybreaker

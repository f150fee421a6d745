// Bases: where an aircraft lands on its way, and takes off with a full battery.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// A way from one place to another, by way of these bases.
struct BaseWay {
    std::vector<Cell> landings = {};
    double lasts = 0;  // units of time, with those at the bases
    double flown = 0;  // at its end, since the battery was full, units of time
};

class Bases {
  public:
    // REQUIRES: the agent recharges, and has its airspace. It must outlive this.
    explicit Bases(const Agent& agent);

    // The ways for which the battery is enough, of an aircraft that has flown so long: those that no other beats both
    // in time and in what is left. The earliest first; none where it does not get there.
    std::vector<BaseWay> ways(Point from, double flown, Point to) const;
    bool is_enough(double flown) const { return flown <= full_; }

    // The shortest flight, in units of time, from its start or a base that it gets to, past a place, and on to its goal
    // or a base from which it gets there; with what it has flown by then. Infinity if there is none.
    double least_sortie(Point past) const;

    // The shortest flight from there to its goal, or to a base from which it gets there.
    double least_landing(Point from) const;

  private:
    double flight(Point a, Point b) const { return agent_.airspace.length(a, b) / agent_.speed; }
    std::size_t count() const { return places_.size(); }
    // From one base to another, with the recharging at the end of each flight.
    double chain(std::size_t from, std::size_t to) const { return chains_[from * count() + to]; }
    void add_landings(std::size_t from, std::size_t to, std::vector<Cell>& landings) const;

    const Agent& agent_;
    double recharge_;  // units of time
    double full_;      // the same
    std::vector<Cell> places_;
    std::vector<double> chains_;     // infinity where there is none
    std::vector<std::size_t> next_;  // on the chain from one base to another
    std::vector<char> gets_there_;   // from its start
    std::vector<char> gets_home_;
};

// Of an agent that breaches nothing: the earliest way from its start to its goal. Straight, where it does not recharge,
// or does not get there.
BaseWay way_home(const Agent& agent);
std::vector<Point> route_home(const Agent& agent);
// In time, from 0 on; it stands at its start until it is ready.
std::vector<Waypoint> flight_home(const Agent& agent);

// How long it takes, at least, to fly for that long, with recharging. In units of time.
double with_recharging(const Agent& agent, double flight);

// Where it recharges on its path from when it is ready: wherever it stands at a base for so long and breaches nothing.
std::vector<Recharge> recharges_on(const Agent& agent, std::span<const Waypoint> path,
                                   std::span<const Breach> breaches);
// Whether its battery is enough for a path without waits in the air.
bool keeps_battery(const Agent& agent, std::span<const Waypoint> path, std::span<const Recharge> recharges);

}  // namespace waybreaker

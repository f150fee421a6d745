// Earliest openings: how early aircraft can have breached a set of obstacles, and be home, whoever breaches what in
// which order, and whatever vehicles do. Lower bounds of every schedule.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "model/objective.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

class EarliestOpenings {
  public:
    // All arguments must outlive it.
    EarliestOpenings(const Map& map, const Rules& rules, std::vector<const Agent*> aircraft);

    // In units of time, breaches included; infinity where the aircraft may not breach so many, or not fly so far.
    struct Times {
        double open = 0;  // when the last obstacle is open; 0 where obstacles do not stand in time
        Returns home = {};
    };
    // Never less for more obstacles, as long as the orders of all are looked at: of up to 8 for one aircraft, up to 6
    // for several. Time O(m 3^n) for m aircraft and the first few of n obstacles, O(2^n n^2) for one aircraft;
    // remembered.
    const Times& of(std::span<const ObstacleId> obstacles);

  private:
    // Flights past one obstacle alone, in cells: from the start to it, from there to the goal, and both by way of one
    // cell.
    struct Legs {
        double first;
        double last;
        double whole;
    };
    // Of one aircraft, by subset of the obstacles: when it has breached them all, and when it is at its goal then.
    struct Flights {
        std::vector<double> open;
        std::vector<double> home;
    };
    double stay(std::size_t aircraft, ObstacleId id) const {
        return time_to_breach(*aircraft_[aircraft], map_.obstacle(id), rules_);
    }
    double least_stay(ObstacleId id) const;  // of all
    const Legs& legs(std::size_t aircraft, ObstacleId id);
    Flights flights_of(std::size_t aircraft, std::span<const ObstacleId> obstacles);
    Times times_of(std::span<const ObstacleId> all);
    Times times_of_breached(std::span<const ObstacleId> obstacles);
    void add_single_visits(std::span<const ObstacleId> obstacles, Times& times);

    const Map& map_;
    const Rules& rules_;
    std::vector<const Agent*> aircraft_;
    std::vector<std::map<ObstacleId, Legs>> legs_;  // by aircraft
    std::map<std::vector<ObstacleId>, Times> known_;
};

}  // namespace waybreaker

// Flight limits: what the aircraft fly at least to breach a set of obstacles, whoever breaches what in which order.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "coalition/problem.hpp"

namespace waybreaker::coalition {

class FlightLimits {
  public:
    explicit FlightLimits(const Problem& problem) : problem_(problem), legs_(problem.aircraft().size()) {}

    // Breaches take their time as well. Time O(m 3^n) for m aircraft and the first few of n obstacles; remembered.
    struct Limits {
        double sum = 0;   // of the times when aircraft are at their goals
        double last = 0;  // when the last one is
        double open = 0;  // when the last obstacle is open
    };
    const Limits& of(const Set& set);

  private:
    // Between an aircraft's start, its goal and an obstacle alone; both by way of one cell.
    struct Legs {
        double first = infinity;
        double last = infinity;
        double whole = infinity;
    };
    // By subset of the obstacles: when one aircraft has breached them all, and when it is at its goal then.
    struct Flights {
        std::vector<double> open;
        std::vector<double> home;
    };
    Limits limits_of(const Set& set);
    Flights flights_of(std::size_t aircraft, std::span<const ObstacleId> obstacles);
    const Legs& legs(std::size_t aircraft, ObstacleId id);

    const Problem& problem_;
    std::vector<std::map<ObstacleId, Legs>> legs_;  // by aircraft
    std::map<Set, Limits> known_;
};

}  // namespace waybreaker::coalition

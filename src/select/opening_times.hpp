// Opening times: how early a set of obstacles can be open at all, whatever the ground agent does.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "select/task.hpp"

namespace waybreaker {

// From a cell beside one obstacle to a cell beside another, at least: by their boxes.
double hop(const Box& a, const Box& b);

class OpeningTimes {
  public:
    // The task must outlive it.
    explicit OpeningTimes(const Task& task);
    // As if nobody ever waited: what is proven so holds with waits as well.
    static OpeningTimes at_once(const Task& task);

    // Whether the ground agent may ever have to wait longer than the air agent's detour to a breach cell takes. Not if
    // both start at the same place, the air agent is no slower, and breaches take no time.
    bool matter() const { return matter_; }
    // Whether that is only as if nobody waited.
    bool are_at_once() const { return at_once_; }

    // A lower limit of when the last of them is open, in cells that the ground agent could drive until then: the
    // shortest flight past all of them, ending at any, with all their breach times. Grows with the set. O(2^n n^2) for
    // the first few obstacles of a set, remembered.
    double cells(std::span<const ObstacleId> obstacles);
    // The same of the air agent's whole flight, past those that must be removed as well; where the objective is the
    // flowtime, its whole duration.
    double flight_cells(std::span<const ObstacleId> obstacles);

  private:
    // Flights past one obstacle alone: from the start to it, from there to the goal, and both by way of one cell.
    struct Legs {
        double first;
        double last;
        double whole;
    };
    struct Times {
        double open;
        double done;
    };
    const Legs& legs(ObstacleId id);
    const Times& times(std::span<const ObstacleId> obstacles);
    Times times_of(std::span<const ObstacleId> obstacles);

    const Task& task_;
    bool matter_ = false;
    bool at_once_ = false;
    std::map<ObstacleId, Legs> legs_;
    std::map<std::vector<ObstacleId>, Times> times_;
};

}  // namespace waybreaker

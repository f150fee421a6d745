// Opening times: how early a set of obstacles can be open at all, as the crossing search asks for it.
#pragma once

#include <span>

#include "schedule/earliest_openings.hpp"
#include "select/task.hpp"

namespace waybreaker {

class OpeningTimes {
  public:
    // The task must outlive it.
    explicit OpeningTimes(const Task& task);
    // As if nobody ever waited: what is proven so holds with waits as well.
    static OpeningTimes at_once(const Task& task);

    // Whether the ground agent may ever have to wait longer than the detour to a breach cell takes. Not if breaches
    // take no time, and an aircraft that may breach all that is removed, and fly any distance, starts with it and is no
    // slower.
    bool may_be_late() const { return may_be_late_; }
    // Whether the times of a set count in the objective: it may open late, or the flights that open it may end after
    // the drive, as those of aircraft that do not end where it ends.
    bool matter() const { return matter_; }
    // Whether that is only as if nobody waited.
    bool are_at_once() const { return at_once_; }

    // A lower bound of when the last of them is open, in cells that the ground agent could drive until then. Grows with
    // the set.
    double cells(std::span<const ObstacleId> obstacles);
    // The same of when all aircraft are home, past those that must be removed as well; where the objective is the
    // flowtime, of the sum of their flights.
    double flight_cells(std::span<const ObstacleId> obstacles);

  private:
    const Task& task_;
    EarliestOpenings earliest_;
    bool may_be_late_ = false;
    bool matter_ = false;
    bool at_once_ = false;
};

}  // namespace waybreaker

// Precedence: which stops of aircraft come before which passages of vehicles, and how early all agents finish then.
//
// A vehicle passes an obstacle after an aircraft has breached it; an aircraft waits for nobody. So the graph of who
// waits for whom has two layers and no cycle, and one pass gives the earliest times: along the tours, then along the
// drives. A drive is as late as the worst of its passages, wherever the vehicle waits on it.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "flight/target.hpp"
#include "model/objective.hpp"

namespace waybreaker {

// Where a drive needs a target gone.
struct Passage {
    std::size_t target = 0;
    double due = 0;  // when the vehicle gets there if it never waits
};

// A way of a vehicle, in time.
struct Drive {
    double arrival = 0;  // without a wait
    std::vector<Passage> passages = {};

    // When the vehicle arrives if it waits as long as it must. `cleared`: by target, when it is gone.
    double end(std::span<const double> cleared) const;
};

class Precedence {
  public:
    // When a target without a stop is gone.
    static constexpr double never = 1e15;

    Precedence() = default;
    // `stays`: by aircraft and target, how long it stays until that is gone; infinity if it may not breach it. The
    // agents must outlive this.
    Precedence(std::vector<const Agent*> aircraft, std::size_t targets, std::vector<std::vector<double>> stays);
    // The target is gone at that time, whoever flies.
    void open_by_itself(std::size_t target, double at) { unflown_[target] = at; }

    // A vehicle of that weight, which takes the drive on which it arrives first. If it has none, all finish at
    // infinity.
    void add_vehicle(std::vector<Drive> drives, double weight = 1);

    double stay(std::size_t aircraft, std::size_t target) const { return stays_[aircraft][target]; }
    bool may_breach(std::size_t aircraft, std::size_t target) const { return std::isfinite(stay(aircraft, target)); }
    std::size_t targets() const { return unflown_.size(); }
    // By target, when it is gone. `tours`: of each aircraft.
    std::vector<double> cleared(std::span<const Tour> tours) const { return flights(tours).cleared; }
    // When all finish at the earliest. Time O(stops + passages).
    Finish finish(std::span<const Tour> tours) const;

  private:
    struct Flights {
        std::vector<double> cleared;
        Finish finish;  // of all that wait for nothing
    };
    Flights flights(std::span<const Tour> tours) const;

    std::vector<const Agent*> aircraft_;
    std::vector<std::vector<double>> stays_;
    std::vector<double> unflown_;  // by target: when it is gone without a stop
    struct Driver {
        std::vector<Drive> drives;
        double weight = 1;
    };
    std::vector<Driver> vehicles_;  // that may have to wait
    Finish others_;                 // of the other vehicles
};

}  // namespace waybreaker

// Greedy choice: one removal after the other, each the one that makes the objective smallest as far as one search for
// each vehicle can tell. Each step is the best there is, the whole is not: two obstacles may only gain together.
#pragma once

#include <map>
#include <vector>

#include "coalition/problem.hpp"
#include "coalition/workers.hpp"
#include "schedule/earliest_openings.hpp"
#include "team/fleet.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::coalition {

class Greedy {
  public:
    // All arguments must outlive it. REQUIRES: vehicles pass no blocked corner.
    Greedy(const Problem& problem, Workers& workers);

    // Takes the obstacle that gains most beside those taken before, and what must be removed. Whether there is one.
    bool take_next();
    // Those taken so far.
    const Set& taken() const { return taken_; }
    // Whether a limit has ended a search.
    bool limited() const { return limited_; }

  private:
    // Lower bounds of a vehicle's arrival: with all open that is taken, and with one obstacle more, if that is earlier.
    struct Arrivals {
        double closed = infinity;
        std::map<ObstacleId, double> with = {};
        bool limited = false;
    };
    Arrivals search(std::size_t vehicle, Worker& worker);
    team::Cost cost_with(const Set& more);
    Set useful() const;

    const Problem& problem_;
    Workers& workers_;
    EarliestOpenings openings_;
    std::vector<crossing::Memory> memories_;  // by vehicle
    std::vector<Arrivals> arrivals_;          // by vehicle
    Set taken_;
    double budget_;
    bool limited_ = false;
};

}  // namespace waybreaker::coalition

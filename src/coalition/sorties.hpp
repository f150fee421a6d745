// Sorties: which aircraft breaches what, in which order and from which cells, so that the coalition is done early;
// collisions of vehicles aside.
//
// Aircraft never wait: so their orders alone say when obstacles are open, and each vehicle takes the way on which it
// arrives first then.
#pragma once

#include <cstdint>
#include <vector>

#include "coalition/ways.hpp"
#include "team/fleet.hpp"

namespace waybreaker::coalition {

struct Stop {
    std::size_t target = 0;  // position in the set
    Cell at;
};
using Sortie = std::vector<Stop>;

// A set put in time.
struct Draft {
    Set set;
    std::vector<Sortie> sorties;  // of each aircraft
    Openings openings;            // when each of the set is gone
    std::vector<Way> taken;       // by vehicle: the way that it drives
    team::Cost cost{.missing = 1, .first = infinity, .second = infinity};
};

class SortiePlanner {
  public:
    SortiePlanner(const Problem& problem, Ways& ways) : problem_(problem), ways_(ways) {}

    // The best sorties found for a set: obstacles are inserted in the order in which vehicles come to them, a few of
    // them in every order; then single ones are moved, and cells exchanged, while that gains. Obstacles that nobody
    // drives through are left out, unless they must be removed. The same each time.
    // `worth`: what it should cost less than; else no effort is made.
    Draft plan(Set set, double worth);

    // The paths in time of the aircraft. `begun`: by obstacle, when its breach begins.
    std::vector<team::Path> flights(const Draft& draft, Openings& begun) const;

  private:
    struct Target {
        ObstacleId obstacle;
        std::vector<Cell> cells;  // its boundary
        double stay = 0;
    };

    // A way of a vehicle that has to wait for targets.
    struct Option {
        double arrival;                                     // without a stop
        std::vector<std::pair<std::size_t, double>> gates;  // targets, and when they must be gone for that
    };

    void prepare(const Set& set);
    Draft best_for(const Set& set);
    std::vector<double> openings_of(const std::vector<Sortie>& sorties) const;
    team::Cost cost_of(const std::vector<Sortie>& sorties) const;
    void fill(Draft& draft) const;
    double could_cost(const Draft& draft) const;
    bool find_timed_ways(const Draft& draft);
    bool insert(std::vector<Sortie>& sorties, std::size_t target) const;
    void improve(std::vector<Sortie>& sorties) const;
    bool move_one(std::vector<Sortie>& sorties, team::Cost& least) const;
    bool exchange_cells(std::vector<Sortie>& sorties, team::Cost& least) const;
    static std::vector<Cell> likely_cells(const Target& target, const Agent& aircraft, const Sortie& sortie,
                                          std::size_t at);
    std::vector<std::size_t> by_need() const;

    const Problem& problem_;
    Ways& ways_;
    std::vector<Target> targets_;
    std::vector<std::vector<const Way*>> menus_;  // by vehicle
    // Of vehicles that can gain by a target; and the arrivals of all others.
    std::vector<std::vector<Option>> options_;
    double others_sum_ = 0;
    double others_last_ = 0;
};

}  // namespace waybreaker::coalition

// The vehicles of a team and their paths so far: each planned one keeps clear of all the others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "team/vehicle.hpp"
#include "waybreaker/advanced/safe_interval.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::team {

using Path = std::vector<Waypoint>;

// Cost of a plan: first the vehicles without a path, then the objective, then the other one.
struct Cost {
    std::size_t missing = 0;
    double first = 0;
    double second = 0;
};
// Whether a is better by more than rounding.
bool better(const Cost& a, const Cost& b);

// An empty path is that of a vehicle without one.
Cost cost_of(std::span<const Vehicle> vehicles, std::span<const Path> paths, Objective objective);

// How a vehicle drives, nobody else being there.
SafeIntervalOptions driving(const Ground& ground, const Vehicle& vehicle);
// The path of an agent from when it is ready, and how it gets there.
Path after_approach(const Agent& agent, std::span<const Waypoint> path);

class Fleet {
  public:
    // Vehicles stand at their starts, all without a path. All arguments must outlive it.
    Fleet(const Ground& ground, std::span<const Vehicle> vehicles, const Rules& rules, const Interrupts& interrupts);

    std::size_t size() const { return vehicles_.size(); }
    const Vehicle& vehicle(std::uint32_t i) const { return vehicles_[i]; }
    // Empty if it has none.
    const Path& path(std::uint32_t i) const { return paths_[i]; }
    double arrival(std::uint32_t i) const { return paths_[i].back().t; }
    bool has_path(std::uint32_t i) const { return !paths_[i].empty(); }
    Cost cost() const { return cost_of(vehicles_, paths_, rules_.objective); }

    // When it has to arrive by, at the latest, if the cost is not to become worse than that; those without a path will
    // arrive as early as if they were alone, at best.
    double latest_arrival(const Cost& cost, std::uint32_t i) const;

    // Gives it the best path that is found past all the others and ends earlier than that; false if there is none.
    // REQUIRES: it has no path.
    bool plan(std::uint32_t i, double arrive_before);
    // Takes its path away: it stands at its start for a while, in which the others leave it room.
    void withdraw(std::uint32_t i);
    // Gives it a path that keeps clear of all the others' and of nobody's start.
    void put(std::uint32_t i, const Path& path);
    // The vehicles that it would meet, were it to drive as if it were alone.
    std::vector<std::uint32_t> in_its_way(std::uint32_t i) const;
    // Leaves out the times at which all of them stand and nothing opens: one may wait for a start that was kept free
    // for long, the others for it. REQUIRES: all have a path.
    void skip_standstill();
    // Its start was passed by others before it could leave: they will have to leave it more time.
    void hold_longer(std::uint32_t i) { hold_[i] *= 2; }
    // Whether any was to be left more time.
    bool hold_as_at_first();

  private:
    void stand_at_start(std::uint32_t i);
    SafeIntervalOptions options_for(std::uint32_t i) const;

    const Ground& ground_;
    std::span<const Vehicle> vehicles_;
    const Rules& rules_;
    const Interrupts& interrupts_;
    Traffic traffic_;
    SafeIntervalSearcher searcher_;
    std::vector<Path> paths_;
    std::vector<double> hold_;  // how long its start is kept free of others while it has no path
};

}  // namespace waybreaker::team

// Many vehicles that are alike, in lockstep: at each moment all stand at cell centres, and by the next each has stepped
// to a cell beside its own, or waited.
//
// Coarse: no vehicle goes at any angle, or waits for less than a step. In return, where vehicles crowd each other, all
// have a plan after milliseconds, and a way past all others takes microseconds. What is found serves as a first plan.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lockstep/improvement.hpp"

namespace waybreaker::lockstep {

struct Trip {
    Cell start;
    Cell goal;
};

// Routes on which the centres of no two discs of that body are nearer than `apart`; all stay at their goals. None if
// that is more than a cell, if there are too many cells or vehicles, if there is no way for one of them, or if none are
// found after a while. `due` ends the search, or, once there are routes, what makes them better.
std::optional<std::vector<std::vector<Cell>>> move_in_lockstep(const OpenedMap& map, const Body& body, double apart,
                                                               std::span<const Trip> trips, Aim aim,
                                                               const std::function<bool()>& due);

}  // namespace waybreaker::lockstep

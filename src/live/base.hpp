// Base: what an agent is bound to do before a new plan can tell it anything else.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "live/position.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::live {

// Timed points from now to the decision point, where the agent is free.
using Base = std::vector<Waypoint>;

// What stands by now, and when what is going to open opens.
struct Ground {
    const Map& map;
    std::span<const TimedOpening> openings;

    // Whether a body meets nothing that stands on that path; else when it first does.
    std::optional<double> first_hit(const std::vector<Waypoint>& path, const Body& body) const;
};

// Where a ground agent may decide, the best first: the next bend at a cell centre after `decided`, or the first place
// before it where it stands, no earlier than it is ready; then cells near where it is at `decided` and a little later.
// Only ways that are clear; the first `most` of them.
std::vector<Base> bases_of(const Ground& ground, const Agent& agent, const Position& position, double decided,
                           std::size_t most);

// The best of each that has one.
std::vector<Base> first_of(const std::vector<std::vector<Base>>& choices);

// One for each agent, so that nobody meets anybody: of those given, the first that do. `stay`: whether they stand at
// their ends until all have got there. Empty where there are none.
std::vector<Base> without_meetings(const Map& map, double separation, bool stay, std::span<const Agent> agents,
                                   const std::vector<std::vector<Base>>& choices);

}  // namespace waybreaker::live

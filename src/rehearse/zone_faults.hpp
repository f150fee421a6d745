// Whether agents were in zones that they keep out of. By geometry of its own.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "rehearse/trail.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::rehearsal {

// What overlaps a zone by less touches, in cells: corners are rounded in planning.
inline constexpr double zone_touching = 2e-3;

// The first zone that an agent was in, as a line; empty if none.
std::optional<std::string> zone_fault(std::span<const Zone> zones, const Trail& trail);

}  // namespace waybreaker::rehearsal

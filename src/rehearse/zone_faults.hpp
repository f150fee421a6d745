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

// What an agent had to do with zones.
struct ZoneFaults {
    std::optional<std::string> fault = {};  // the first zone that it was in while that held, as a line
    bool caught = false;  // it was in one, not yet forbidden, when that began to hold; until it is out that is no fault
};
ZoneFaults zone_faults(std::span<const Zone> zones, const Trail& trail);

}  // namespace waybreaker::rehearsal

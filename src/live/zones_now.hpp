// Zones with a window, as a mission under way meets them: those that hold now. Agents keep to their bases for a moment
// only; what zones do later is asked when the rest is planned.
#pragma once

#include <optional>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::live {

// With the airspaces that the zones leave that hold at that time.
Mission in_airspace_at(const Map& map, Mission mission, double time);

// What vehicles meet.
struct Closed {
    const Map& map() const { return closed ? *closed : open; }

    const Map& open;
    std::optional<Map> closed;           // with an obstacle for each zone; empty where there is none
    std::vector<TimedOpening> openings;  // of those that are over some time
};
// The map must outlive it.
Closed closed_at(const Map& map, const Mission& mission, double time);

}  // namespace waybreaker::live

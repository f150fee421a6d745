// A mission with zones, as planning sees it: cells that vehicles keep out of are blocked for good, aircraft have their
// airspace, and what cannot be removed for a zone is protected. Zones with a window are only validated here; when they
// hold is asked above (mission/in_windows.hpp).
#pragma once

#include <optional>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// Throws InputError, naming the zone, if one is not valid, holds for somebody who is not there or only for some of
// several alike, has an agent's start or goal in it (with a window: while the agent must be there), or leaves an
// aircraft no way or what must be removed out of reach.
// REQUIRES: a mission that is valid but for its zones.
void validate_zones(const Map& map, const Mission& mission);

// Whether a zone is one for that agent, whenever it holds.
bool holds_for(const Zone& zone, const Agent& agent);

// Gives aircraft the airspace that the zones of the mission without a window leave them.
void set_airspaces(const Map& map, Mission& mission);

// With an obstacle more, the last one: the cells that reach into a zone for vehicles, free ones and those of obstacles
// that open by themselves. All others stay. Empty where there are no such cells.
std::optional<Map> closed_to_vehicles(const Map& map, const Mission& mission);

// Throws InputError, naming the zone, if a polygon is none, or all have too many corners together.
void validate_polygons(const std::vector<Zone>& zones);

class InZones {
  public:
    // Both must outlive it. REQUIRES: valid zones.
    InZones(const Map& map, const Mission& mission);

    // That which is closed to vehicles.
    const Map& map() const { return closed_ ? *closed_ : map_; }
    // Without zones.
    const Mission& mission() const { return zoned_ ? *zoned_ : mission_; }

  private:
    const Map& map_;
    const Mission& mission_;
    std::optional<Map> closed_;
    std::optional<Mission> zoned_;
};

}  // namespace waybreaker

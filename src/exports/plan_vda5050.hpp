// Orders for vehicles by VDA 5050 3.0, the interface between fleet controls and mobile robots.
//
//     {"zoneSets": [{...}, ...], "orders": [{...}, ...]}
//
// Each is a message of its topic to one vehicle, which its serialNumber names by the agent's id. A vehicle's first
// order has the whole way: what it may drive at once is base, the rest horizon. Its updates follow in their order, each
// with the next part (io/path_parts.hpp) as base, from the decision point on; their timestamps are when the plan has
// the vehicle set out. A zone set has a RELEASE zone for each obstacle that is opened.
#pragma once

#include <string>

#include "exports/placed_plan.hpp"

namespace waybreaker::exports {

// Positions are metres of the map's frame (io/map_frame.hpp). Throws InputError if the map does not say how large a
// cell is.
std::string plan_vda5050(const PlacedPlan& placed, const Mission& mission);

}  // namespace waybreaker::exports

// Orders for vehicles by VDA 5050 3.0, the interface between fleet controls and mobile robots.
//
//     {"zoneSets": [{...}, ...], "instantActions": [], "orders": [{...}, ...]}
//
// Each is a message of its topic to one vehicle, which its serialNumber names by the agent's id. A vehicle's first
// order has the whole way: what it may drive at once is base, the rest horizon. Its updates follow in their order, each
// with the next part (io/path_parts.hpp) as base, from the decision point on; their timestamps are when the plan has
// the vehicle set out. A zone set has a RELEASE zone for each obstacle that opens on the way, and a BLOCKED one for
// each zone that the vehicle keeps out of.
//
// A base once sent cannot be taken back. So a plan that revises another has a `cancelOrder` for each vehicle and new
// orders, whose first base ends at the decision point of the revision.
#pragma once

#include <string>

#include "exports/placed_plan.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::exports {

// Positions are metres of the map's frame (io/map_frame.hpp). Throws InputError if the map does not say how large a
// cell is, a vehicle's id cannot be part of a topic, or one begins in a hole of a zone.
std::string plan_vda5050(const PlacedPlan& placed, const Mission& mission);

}  // namespace waybreaker::exports

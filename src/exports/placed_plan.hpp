// A plan as the field knows it: on earth, at a time of a day, at a height.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::exports {

// REQUIRES: the plan is one for this map, and both outlive it.
struct PlacedPlan {
    const Plan& plan;
    const io::MapFile& map;
    site::ToLonLat to_lon_lat = {};
    std::int64_t starts_at = 0;           // seconds since 1970. A unit of the plan's time counts as a second.
    std::optional<double> altitude = {};  // of flights, metres above the place of take-off
    std::span<const Zone> zones = {};     // of the mission
};

// Throws InputError, naming the format, if the map does not say where it lies on earth.
void require_place(const PlacedPlan& placed, std::string_view format);

// What people call the obstacle: its name, or "obstacle 17".
std::string obstacle_name(const PlacedPlan& placed, ObstacleId obstacle);

// Whether an agent keeps out of it.
bool holds_for(const Zone& zone, const Itinerary& agent);

// For formats whose areas have no holes. Throws InputError if the agent's path begins in a hole of a zone that holds
// for it.
void require_no_hole(const PlacedPlan& placed, const Itinerary& agent, std::string_view format);

// Who breaches it.
std::string breached_by(const Plan& plan, const Breach& breach);

// When the aircraft begins to stay for it.
double begun_at(const Plan& plan, const Breach& breach);

}  // namespace waybreaker::exports

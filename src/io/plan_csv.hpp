// The timed waypoints of a plan as CSV, a line each, for spreadsheets and scripts.
//
//     agent,kind,t,x,y,map_x,map_y,lon,lat,breaches
//     air,air,0,256,434,390212.4,5820101.9,13.381,52.521,
//     air,air,53.14,238,384,390169.2,5820221.9,13.38,52.522,129
//
// x and y are cells, map_x and map_y metres in the map's frame (map_frame.hpp); lon and lat are empty where the map
// does not say where it lies; `breaches` is the obstacle that the air agent opens there, at the end of its stay.
#pragma once

#include <string>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

std::string plan_csv(const Plan& plan, const MapFile& map, const site::ToLonLat& to_lon_lat);

}  // namespace waybreaker::io

// The timed waypoints of a plan as CSV, a line each, for spreadsheets and scripts.
//
//     agent,kind,t,x,y,map_x,map_y,lon,lat,breaches,area_m2,time_unit,map_crs
//     air,air,0,256,434,390212.4,5820101.9,13.381,52.521,,,s,EPSG:32633
//     air,air,53.14,238,384,390169.2,5820221.9,13.38,52.522,129,307.2,s,EPSG:32633
//
// t is in time_unit, x and y are cells, map_x and map_y metres in the map's frame (map_frame.hpp): coordinates of
// map_crs, where the map has a coordinate system. lon and lat are empty where the map does not say where it lies;
// `breaches` is the obstacle that the air agent opens there, at the end of its stay, and area_m2 its area.
#pragma once

#include <string>

#include "io/export_units.hpp"
#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

std::string plan_csv(const Plan& plan, const MapFile& map, const site::ToLonLat& to_lon_lat,
                     const ExportUnits& units = {});

}  // namespace waybreaker::io

// Zones that a file of its own says: --zones FILE.
#pragma once

#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::apps {

// In cells of the map. Throws InputError if the file is no collection of zones, or has longitudes and latitudes where
// the map does not say where it lies.
std::vector<Zone> read_zones_file(const std::string& path, const io::MapFile& map);

// That a zone with times leaves no plan, as far as is known. `or_time`: the search was cut short.
std::string barred_text(const BarredBy& by, const std::vector<Zone>& zones, bool or_time);

}  // namespace waybreaker::apps

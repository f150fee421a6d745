#include "zone_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geotiff/georeference.hpp"
#include "io/output_file.hpp"
#include "io/zones_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {

namespace {

std::vector<Zone> valid(std::vector<Zone> zones, const std::string& path) {
    try {
        for (std::size_t i = 0; i < zones.size(); ++i) validate(zones[i], i + 1);
    } catch (const InputError& error) {
        throw InputError(io::input_name(path), 0, error.what());
    }
    return zones;
}

}  // namespace

std::vector<Zone> read_zones_file(const std::string& path, const io::MapFile& map) {
    io::ZoneCollection given = io::parse_zones(io::read_whole(path, io::max_zones_bytes), io::input_name(path));
    if (given.in_cells || given.zones.empty()) return valid(std::move(given.zones), path);
    if (!map.georeference) {
        throw InputError(fmt::format(
            "{}: is in longitude and latitude, and {} does not say where on Earth it lies; give cells, and \"crs\": "
            "\"cells\" beside \"features\"",
            io::input_name(path), map.source));
    }
    const geotiff::FromLonLat to_cells(*map.georeference);
    for (Zone& zone : given.zones) {
        for (std::vector<Point>& ring : zone.polygon) ring = to_cells(std::move(ring));
    }
    return valid(std::move(given.zones), path);
}

std::string barred_text(const BarredBy& by, const std::vector<Zone>& zones, bool or_time) {
    return fmt::format(
        "no plan was found, nor that there is none: {} stands in the way of {} at {:g}; other times, or a zone "
        "less{}, may help",
        name_of(zones[by.zone - 1], by.zone), by.agent, by.at, or_time ? ", or more time" : "");
}

}  // namespace waybreaker::apps

// Cells to longitude and latitude, and back.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "site/georeference.hpp"
#include "waybreaker/cell.hpp"

class OGRCoordinateTransformation;

namespace waybreaker::geotiff {

// For people, e.g. "WGS 84 / UTM zone 33N".
std::string crs_name(const site::Georeference& place);
// For programs, e.g. "EPSG:32633"; the name where no authority has a code for it.
std::string crs_code(const site::Georeference& place);

// EPSG's code of the UTM zone of WGS84 around a place, without the exceptions around Norway: they change the zone's
// name, but hardly any length.
int utm_code(double longitude, double latitude);

// Transforms points of a map to WGS84 degrees. Not thread-safe.
class ToLonLat {
  public:
    // Throws InputError if there is no transformation from that coordinate system.
    explicit ToLonLat(const site::Georeference& place);
    ~ToLonLat();
    ToLonLat(const ToLonLat&) = delete;
    ToLonLat& operator=(const ToLonLat&) = delete;

    // Longitude and latitude of a point in cell units (integer = cell centre).
    std::array<double, 2> operator()(double x, double y) const;

  private:
    std::array<double, 6> transform_;
    std::unique_ptr<OGRCoordinateTransformation> to_wgs84_;
};

// The inverse. Not thread-safe.
class FromLonLat {
  public:
    explicit FromLonLat(const site::Georeference& place);
    ~FromLonLat();
    FromLonLat(const FromLonLat&) = delete;
    FromLonLat& operator=(const FromLonLat&) = delete;

    // Points in cell units of points in WGS84 degrees (x is the longitude); not finite where there are none.
    std::vector<Point> operator()(std::vector<Point> lon_lats) const;

  private:
    std::array<double, 6> transform_;
    std::unique_ptr<OGRCoordinateTransformation> from_wgs84_;
};

// For programs without projections: [a, b, c, d, e, f] so that a point x, y of a map, in cell units, has the longitude
// a x + b y + c and the latitude d x + e y + f. Good to a cell everywhere on the map, or there is none.
std::optional<std::array<double, 6>> affine_to_lon_lat(const site::Georeference& place, int width, int height);

// West, south, east, north of the smallest box that holds a map; across 180 degrees west is above east, as in RFC 7946,
// section 5.2. Empty where a part of it has no longitudes and latitudes.
std::optional<std::array<double, 4>> lon_lat_box(const site::Georeference& place, int width, int height);

// ToLonLat for code without GDAL; empty for a map without a georeference.
site::ToLonLat lon_lat_of(const std::optional<site::Georeference>& place);

}  // namespace waybreaker::geotiff

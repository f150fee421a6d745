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

namespace waybreaker::geo {

// For people, e.g. "WGS 84 / UTM zone 33N".
std::string crs_name(const site::Georeference& place);

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

// ToLonLat for code without GDAL; empty for a map without a georeference.
site::ToLonLat lon_lat_of(const std::optional<site::Georeference>& place);

}  // namespace waybreaker::geo

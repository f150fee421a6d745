// Where a map lies on the ground.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "waybreaker/cell.hpp"

class OGRCoordinateTransformation;

namespace waybreaker::geo {

struct Georeference {
    std::string crs;  // well-known text
    // GDAL's affine transform from cell corner coordinates (column, row) to the coordinate system.
    std::array<double, 6> transform{0, 1, 0, 0, 0, 1};
    std::string crs_name() const;  // for people, e.g. "WGS 84 / UTM zone 33N"
    // Of a point in cell units (integer = cell centre), WGS84 degrees. For many points see ToLonLat.
    std::array<double, 2> lon_lat(double x, double y) const;
};

// Takes points of a map to WGS84 degrees. Not for two threads at once.
class ToLonLat {
  public:
    // Throws InputError if there is no way from that coordinate system.
    explicit ToLonLat(const Georeference& place);
    ~ToLonLat();
    ToLonLat(const ToLonLat&) = delete;
    ToLonLat& operator=(const ToLonLat&) = delete;

    // Longitude and latitude of a point in cell units (integer = cell centre).
    std::array<double, 2> operator()(double x, double y) const;

  private:
    std::array<double, 6> transform_;
    std::unique_ptr<OGRCoordinateTransformation> to_wgs84_;
};

// The way back. Not for two threads at once.
class FromLonLat {
  public:
    explicit FromLonLat(const Georeference& place);
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
std::optional<std::array<double, 6>> affine_to_lon_lat(const Georeference& place, int width, int height);

}  // namespace waybreaker::geo

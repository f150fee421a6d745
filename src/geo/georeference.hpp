// Where a map lies on the ground.
#pragma once

#include <array>
#include <memory>
#include <string>

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

}  // namespace waybreaker::geo

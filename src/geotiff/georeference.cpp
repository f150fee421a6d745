#include "geotiff/georeference.hpp"

#include <gdal.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geotiff/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

// Both in (east, north) order.
OGRSpatialReference system_of(const site::Georeference& place) {
    OGRSpatialReference system(place.crs.c_str());
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

OGRSpatialReference degrees() {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return wgs84;
}

}  // namespace

std::string crs_name(const site::Georeference& place) {
    const GdalScope gdal;
    const OGRSpatialReference system(place.crs.c_str());
    const char* name = system.GetName();
    return name ? name : "";
}

std::string crs_code(const site::Georeference& place) {
    const GdalScope gdal;
    const OGRSpatialReference system(place.crs.c_str());
    const char* authority = system.GetAuthorityName(nullptr);
    const char* code = system.GetAuthorityCode(nullptr);
    return authority && code ? std::string(authority) + ":" + code : crs_name(place);
}

int utm_code(double longitude, double latitude) {
    const int zone = std::clamp(int(std::floor((longitude + 180) / 6)) + 1, 1, 60);
    return (latitude >= 0 ? 32600 : 32700) + zone;
}

ToLonLat::ToLonLat(const site::Georeference& place) : transform_(place.transform) {
    const GdalScope gdal;
    const OGRSpatialReference from = system_of(place);
    const OGRSpatialReference to = degrees();
    to_wgs84_.reset(OGRCreateCoordinateTransformation(&from, &to));
    if (!to_wgs84_) throw InputError("the map's coordinate system has no longitudes and latitudes: " + gdal.failure());
}

ToLonLat::~ToLonLat() = default;

std::array<double, 2> ToLonLat::operator()(double x, double y) const {
    const GdalScope gdal;
    // Cell centres are integers, GDAL counts from the corner of the upper-left cell.
    const double column = x + 0.5;
    const double row = y + 0.5;
    double east = transform_[0] + column * transform_[1] + row * transform_[2];
    double north = transform_[3] + column * transform_[4] + row * transform_[5];
    if (!to_wgs84_->Transform(1, &east, &north)) {
        throw InputError("no longitude and latitude for cell " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                         gdal.failure());
    }
    return {east, north};
}

FromLonLat::FromLonLat(const site::Georeference& place) : transform_(place.transform) {
    const GdalScope gdal;
    const OGRSpatialReference from = degrees();
    const OGRSpatialReference to = system_of(place);
    from_wgs84_.reset(OGRCreateCoordinateTransformation(&from, &to));
}

FromLonLat::~FromLonLat() = default;

std::vector<Point> FromLonLat::operator()(std::vector<Point> lon_lats) const {
    const GdalScope gdal;
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    std::array<double, 6> transform = transform_;  // GDAL only reads it
    std::array<double, 6> to_cells{};
    if (!from_wgs84_ || !GDALInvGeoTransform(transform.data(), to_cells.data())) {
        std::fill(lon_lats.begin(), lon_lats.end(), Point(nowhere, nowhere));
        return lon_lats;
    }
    std::vector<double> east;
    std::vector<double> north;
    for (const Point& point : lon_lats) {
        east.push_back(point.x);
        north.push_back(point.y);
    }
    // Where it fails it leaves infinity.
    from_wgs84_->Transform(int(lon_lats.size()), east.data(), north.data());
    for (std::size_t i = 0; i < lon_lats.size(); ++i) {
        lon_lats[i] = {to_cells[0] + east[i] * to_cells[1] + north[i] * to_cells[2] - 0.5,
                       to_cells[3] + east[i] * to_cells[4] + north[i] * to_cells[5] - 0.5};
    }
    return lon_lats;
}

std::optional<std::array<double, 6>> affine_to_lon_lat(const site::Georeference& place, int width, int height) try {
    // The best fit to three by three points, from side to side; so regular that its equations are solved beforehand.
    const ToLonLat to_lon_lat(place);
    const Point half{width / 2.0, height / 2.0};
    const Point middle{half.x - 0.5, half.y - 0.5};
    std::array<std::array<double, 3>, 2> fit{};  // of longitude and latitude: by x, by y, in the middle
    for (const int v : {-1, 0, 1}) {
        for (const int u : {-1, 0, 1}) {
            const std::array<double, 2> exact = to_lon_lat(middle.x + u * half.x, middle.y + v * half.y);
            for (std::size_t i = 0; i < 2; ++i) {
                fit[i][0] += u * exact[i] / (6 * half.x);
                fit[i][1] += v * exact[i] / (6 * half.y);
                fit[i][2] += exact[i] / 9;
            }
        }
    }
    const double cell_area = std::abs(fit[0][0] * fit[1][1] - fit[0][1] * fit[1][0]);  // in square degrees
    const auto [a, b, at_longitude] = fit[0];
    const auto [d, e, at_latitude] = fit[1];
    for (const int v : {-1, 0, 1}) {
        for (const int u : {-1, 0, 1}) {
            const auto [longitude, latitude] = to_lon_lat(middle.x + u * half.x, middle.y + v * half.y);
            const double east = longitude - (a * u * half.x + b * v * half.y + at_longitude);
            const double north = latitude - (d * u * half.x + e * v * half.y + at_latitude);
            const double off = std::hypot(e * east - b * north, a * north - d * east) / cell_area;  // in cells
            if (!(off <= 1)) return std::nullopt;
        }
    }
    return std::array<double, 6>{a, b, at_longitude - a * middle.x - b * middle.y,
                                 d, e, at_latitude - d * middle.x - e * middle.y};
} catch (const InputError&) {
    return std::nullopt;
}

std::optional<std::array<double, 4>> lon_lat_box(const site::Georeference& place, int width, int height) try {
    // Parallels bend: along a side the extreme may lie between its ends.
    constexpr int steps = 20;
    const ToLonLat to_lon_lat(place);
    const double middle = to_lon_lat((width - 1) / 2.0, (height - 1) / 2.0)[0];
    std::array<double, 4> box{middle, 90, middle, -90};
    const auto include = [&](double u, double v) {
        const auto [longitude, latitude] = to_lon_lat(u * width - 0.5, v * height - 0.5);
        const double turned = middle + std::remainder(longitude - middle, 360);
        box = {std::min(box[0], turned), std::min(box[1], latitude), std::max(box[2], turned),
               std::max(box[3], latitude)};
    };
    for (int i = 0; i <= steps; ++i) {
        const double share = double(i) / steps;
        for (const double side : {0.0, 1.0}) {
            include(share, side);
            include(side, share);
        }
    }
    if (!std::all_of(box.begin(), box.end(), [](double edge) { return std::isfinite(edge); })) return std::nullopt;
    if (box[0] < -180) box[0] += 360;
    if (box[2] > 180) box[2] -= 360;
    return box;
} catch (const InputError&) {
    return std::nullopt;
}

site::ToLonLat lon_lat_of(const std::optional<site::Georeference>& place) {
    if (!place) return {};
    return [to_lon_lat = std::make_shared<const ToLonLat>(*place)](Point p) { return (*to_lon_lat)(p.x, p.y); };
}

}  // namespace waybreaker::geotiff

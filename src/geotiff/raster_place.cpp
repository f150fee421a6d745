#include "geotiff/raster_place.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "geotiff/gdal_scope.hpp"
#include "geotiff/georeference.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

// Cells may deviate from squares by this share of their side.
constexpr double square_tolerance = 1e-3;

// A length on the ground may deviate from what it is in the coordinate system by this share. UTM zones and the grids of
// countries stay within it.
constexpr double most_stretch = 0.01;

using Transform = std::array<double, 6>;

// A cell on the ground, in metres.
struct Side {
    double east;
    double north;
};

// To a nanometre: the file holds the upper-left corner, and the way from there and back rounds.
double as_written(double metres) {
    constexpr double nanometres = 1e9;
    constexpr double most = 1e6;  // beyond, a number has no nanometres
    return std::abs(metres) < most ? std::round(metres * nanometres) / nanometres + 0.0 : metres;
}

// The distance between two places in degrees that lie close together, on the ellipsoid of WGS84.
double metres_between(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    constexpr double equator = 6378137;
    constexpr double eccentricity_squared = 0.00669437999014;
    constexpr double degree = std::numbers::pi / 180;
    const double latitude = (a[1] + b[1]) / 2 * degree;
    const double bulge = 1 - eccentricity_squared * std::pow(std::sin(latitude), 2);
    const double across = equator / std::sqrt(bulge);
    const double along = across * (1 - eccentricity_squared) / bulge;
    const double turned = std::remainder(b[0] - a[0], 360) * degree;
    return std::hypot(across * std::cos(latitude) * turned, along * (b[1] - a[1]) * degree);
}

std::unique_ptr<const ToLonLat> lon_lat_from(const site::Georeference& place) try {
    return std::make_unique<ToLonLat>(place);
} catch (const InputError&) {
    return nullptr;
}

// Empty where a point, in cell units, has no longitude and latitude.
std::optional<std::array<double, 2>> lon_lat_at(const ToLonLat& to_lon_lat, double x, double y) try {
    const std::array<double, 2> place = to_lon_lat(x, y);
    return std::isfinite(place[0]) && std::isfinite(place[1]) ? std::optional(place) : std::nullopt;
} catch (const InputError&) {
    return std::nullopt;
}

// The cell around a point.
std::optional<Side> on_the_ground(const ToLonLat& to_lon_lat, double x, double y) {
    constexpr double half = 0.5;
    const auto west = lon_lat_at(to_lon_lat, x - half, y);
    const auto east = lon_lat_at(to_lon_lat, x + half, y);
    const auto north = lon_lat_at(to_lon_lat, x, y - half);
    const auto south = lon_lat_at(to_lon_lat, x, y + half);
    if (!west || !east || !north || !south) return std::nullopt;
    return Side{metres_between(*west, *east), metres_between(*north, *south)};
}

// The EPSG code of the UTM zone around a place, or of the polar system beyond the last; "326ZZ" where that is unknown.
std::string metric_system(const std::optional<std::array<double, 2>>& lon_lat) {
    if (!lon_lat) return "EPSG:326ZZ, ZZ being its UTM zone";
    const auto [longitude, latitude] = *lon_lat;
    constexpr double last_zones = 84;
    if (std::abs(latitude) > last_zones) return latitude > 0 ? "EPSG:32661" : "EPSG:32761";
    return fmt::format("EPSG:{}", utm_code(longitude, latitude));
}

InputError must_be_projected(const std::string& name, const std::string& what,
                             const std::optional<std::array<double, 2>>& lon_lat) {
    return {name, 0, fmt::format("{}; project it with 'gdalwarp -r near -t_srs {}'", what, metric_system(lon_lat))};
}

// Refuses cells in degrees. The middle of the map is where its zone is.
[[noreturn]] void refuse_degrees(GDALDataset& file, const Transform& transform, const std::string& name) {
    const double longitude = transform[0] + file.GetRasterXSize() * transform[1] / 2;
    const double latitude = transform[3] + file.GetRasterYSize() * transform[5] / 2;
    const bool on_earth = std::abs(longitude) <= 360 && std::abs(latitude) <= 90;
    throw must_be_projected(
        name, "has cells in degrees, which are not square on the ground",
        on_earth ? std::optional(std::array{std::remainder(longitude, 360), latitude}) : std::nullopt);
}

// Refuses coordinate systems that stretch lengths, in the middle of the map or at a corner.
void require_true_lengths(const ToLonLat& to_lon_lat, const site::Georeference& place, double cell_size, int width,
                          int height, const std::string& name) {
    const auto stretch = [cell_size](const Side& side) {
        return std::max(std::abs(side.east / cell_size - 1), std::abs(side.north / cell_size - 1));
    };
    const double right = width - 1;
    const double low = height - 1;
    std::optional<Side> worst;
    for (const auto& [x, y] : {std::array{right / 2, low / 2}, {0.0, 0.0}, {right, 0.0}, {0.0, low}, {right, low}}) {
        const std::optional<Side> side = on_the_ground(to_lon_lat, x, y);
        if (side && (!worst || stretch(*side) > stretch(*worst))) worst = side;
    }
    if (!worst || stretch(*worst) <= most_stretch) return;
    throw must_be_projected(name,
                            fmt::format("has cells of {:.6g} m in {}, which are {:.3g} x {:.3g} m on the ground",
                                        cell_size, crs_name(place), worst->east, worst->north),
                            lon_lat_at(to_lon_lat, right / 2, low / 2));
}

Transform checked_transform(GDALDataset& file, const std::string& name) {
    Transform transform{};
    file.GetGeoTransform(transform.data());
    const auto [west, cell_x, skew_x, north, skew_y, cell_y] = transform;
    if (!std::all_of(transform.begin(), transform.end(), [](double t) { return std::isfinite(t); })) {
        throw InputError(name, 0, "has a georeference that is not a number; give it one with 'gdal_edit.py -a_ullr'");
    }
    if (skew_x != 0 || skew_y != 0 || !(cell_x > 0) || !(cell_y < 0)) {
        throw InputError(name, 0, "is rotated or not north-up; straighten it with 'gdalwarp -r near'");
    }
    if (!(std::abs(cell_x + cell_y) <= square_tolerance * cell_x)) {
        throw InputError(
            name, 0,
            fmt::format("has cells of {:.6g} x {:.6g}, cells must be square; resample it with 'gdalwarp -r near -tr'",
                        cell_x, -cell_y));
    }
    return transform;
}

std::string well_known_text(const OGRSpatialReference& system) {
    char* text = nullptr;
    system.exportToWkt(&text);
    std::string result = text ? text : "";
    CPLFree(text);
    return result;
}

}  // namespace

RasterPlace read_place(GDALDataset& file, const std::string& name) {
    RasterPlace place;
    Transform transform{};
    if (file.GetGeoTransform(transform.data()) != CE_None) return place;
    transform = checked_transform(file, name);
    const OGRSpatialReference* system = file.GetSpatialRef();
    if (system && system->IsGeographic()) refuse_degrees(file, transform, name);
    const double unit = system ? system->GetLinearUnits() : 1;
    place.cell_size = transform[1] * unit;
    if (system) {
        const site::Georeference found{well_known_text(*system), transform};
        if (const auto to_lon_lat = lon_lat_from(found)) {
            require_true_lengths(*to_lon_lat, found, place.cell_size, file.GetRasterXSize(), file.GetRasterYSize(),
                                 name);
            place.georeference = found;
            return place;
        }
    }
    const double south = transform[3] + file.GetRasterYSize() * transform[5];
    if (std::isfinite(south)) place.origin = {as_written(unit * transform[0]), as_written(unit * south)};
    return place;
}

void write_place(GDALDataset& file, const RasterPlace& place) {
    const auto [west, south] = place.origin.value_or(std::array<double, 2>{});
    const double north = south + file.GetRasterYSize() * place.cell_size;
    Transform transform{west, place.cell_size, 0, north, 0, -place.cell_size};
    if (place.georeference) {
        transform = place.georeference->transform;
        const OGRSpatialReference system(place.georeference->crs.c_str());
        file.SetSpatialRef(&system);
    }
    file.SetGeoTransform(transform.data());
}

}  // namespace waybreaker::geotiff

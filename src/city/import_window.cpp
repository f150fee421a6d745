#include "city/import_window.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "geotiff/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

constexpr double widest = 100000;  // metres of one UTM zone

OGRSpatialReference utm_at(double longitude, double latitude) {
    OGRSpatialReference system;
    system.SetWellKnownGeogCS("WGS84");
    system.importFromEPSG(geotiff::utm_code(longitude, latitude));
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

void check_cell(double cell) {
    if (!(cell >= 0.01 && cell <= 1000)) {
        throw OptionError("cell", fmt::format("{}: expected a cell size from 0.01 to 1000 metres", cell));
    }
}

int checked_cells(const ImportOptions& options) {
    if (!(std::abs(options.longitude) <= 180) || !(std::abs(options.latitude) <= 80)) {
        throw OptionError("center", fmt::format("{},{}: expected LON,LAT in degrees, longitude within 180 of 0 and "
                                                "latitude within 80 (there are no UTM zones beyond)",
                                                options.longitude, options.latitude));
    }
    check_cell(options.cell);
    const int limit = int(std::sqrt(double(max_cells)));
    const double cells = std::round(options.size / options.cell);
    if (!(cells >= 1 && cells <= limit)) {
        throw OptionError("size", fmt::format("{}: with cells of {} m a window can be {} to {} m wide", options.size,
                                              options.cell, options.cell, options.cell * limit));
    }
    if (!(options.size <= widest)) {
        throw OptionError("size",
                          fmt::format("{}: a window of one UTM zone can be up to {} m wide", options.size, widest));
    }
    return int(cells);
}

std::unique_ptr<OGRCoordinateTransformation> to_utm(const OGRSpatialReference& utm, const geotiff::GdalScope& gdal) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    std::unique_ptr<OGRCoordinateTransformation> result(OGRCreateCoordinateTransformation(&wgs84, &utm));
    if (!result) throw InputError("cannot project to UTM (is the package proj-data installed?): " + gdal.failure());
    return result;
}

CellWindow window_at(const OGRSpatialReference& utm, double west, double north, int width, int height, double cell,
                     std::array<double, 2> center) {
    CellWindow result{{utm, {}}, width, height, {}, center};
    result.window.bounds.MinX = west;
    result.window.bounds.MaxX = west + width * cell;
    result.window.bounds.MinY = north - height * cell;
    result.window.bounds.MaxY = north;
    char* text = nullptr;
    utm.exportToWkt(&text);
    result.georeference = {text ? text : "", {west, cell, 0, north, 0, -cell}};
    CPLFree(text);
    return result;
}

CellWindow window_around(const ImportOptions& options) {
    const int cells = checked_cells(options);
    const geotiff::GdalScope gdal;
    const OGRSpatialReference utm = utm_at(options.longitude, options.latitude);
    double east = options.longitude;
    double north = options.latitude;
    if (!to_utm(utm, gdal)->Transform(1, &east, &north)) {
        throw InputError("cannot project to UTM (is the package proj-data installed?): " + gdal.failure());
    }
    const double half = cells * options.cell / 2;
    return window_at(utm, east - half, north + half, cells, cells, options.cell, {options.longitude, options.latitude});
}

CellWindow window_of_box(const std::array<double, 4>& box, double cell) {
    const auto [west, south, east, north] = box;
    const auto refuse = [&](const char* reason) {
        throw OptionError("bbox", fmt::format("{},{},{},{}: {}", west, south, east, north, reason));
    };
    if (!(std::abs(west) <= 180 && std::abs(east) <= 180 && std::abs(south) <= 80 && std::abs(north) <= 80)) {
        refuse("expected WEST,SOUTH,EAST,NORTH in degrees, latitudes within 80");
    }
    // Across 180 degrees west is above east (RFC 7946, section 5.2).
    const double end = east > west ? east : east + 360;
    constexpr double half_the_earth = 180;
    if (!(end - west < half_the_earth && south < north)) {
        refuse("west must be below east, but for a box across 180 degrees, and south below north");
    }
    check_cell(cell);
    const geotiff::GdalScope gdal;
    const std::array<double, 2> center{std::remainder((west + end) / 2, 360), (south + north) / 2};
    const OGRSpatialReference utm = utm_at(center[0], center[1]);
    OGREnvelope bounds;
    if (!to_utm(utm, gdal)->TransformBounds(west, south, end, north, &bounds.MinX, &bounds.MinY, &bounds.MaxX,
                                            &bounds.MaxY, 21)) {
        refuse("cannot be projected to UTM");
    }
    const double width = std::max(std::round((bounds.MaxX - bounds.MinX) / cell), 1.0);
    const double height = std::max(std::round((bounds.MaxY - bounds.MinY) / cell), 1.0);
    if (width * cell > widest || height * cell > widest) refuse("is wider than the 100 km of one UTM zone's window");
    if (width > max_side || height > max_side || width * height > double(max_cells)) {
        refuse("has too many cells; give larger cells");
    }
    return window_at(utm, bounds.MinX, bounds.MaxY, int(width), int(height), cell, center);
}

}  // namespace

CellWindow import_window(const ImportOptions& options) {
    return options.box ? window_of_box(*options.box, options.cell) : window_around(options);
}

CellWindow part_of(const CellWindow& whole, int x, int y, int width, int height) {
    const std::array<double, 6>& transform = whole.georeference.transform;
    const double cell = transform[1];
    const std::array<double, 2> center =
        geotiff::ToLonLat(whole.georeference)(x + (width - 1) / 2.0, y + (height - 1) / 2.0);
    return window_at(whole.window.system, transform[0] + x * cell, transform[3] - y * cell, width, height, cell,
                     center);
}

CellWindow window_of(const site::Georeference& place, int width, int height) {
    const std::array<double, 2> center = geotiff::ToLonLat(place)((width - 1) / 2.0, (height - 1) / 2.0);
    CellWindow window{{OGRSpatialReference(place.crs.c_str()), {}}, width, height, place, center};
    window.window.system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::array<double, 6>& transform = place.transform;
    window.window.bounds.MinX = transform[0];
    window.window.bounds.MaxX = transform[0] + width * transform[1];
    window.window.bounds.MinY = transform[3] + height * transform[5];
    window.window.bounds.MaxY = transform[3];
    return window;
}

}  // namespace waybreaker::city

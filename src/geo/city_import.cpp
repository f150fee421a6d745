#include "geo/city_import.hpp"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_map>

#include "geo/buildings.hpp"
#include "geo/gdal_scope.hpp"
#include "map/label.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

struct CellWindow {
    Window window;
    int cells = 0;  // on each side
    Georeference georeference;
};

// UTM without the exceptions around Norway: they change names, not lengths to speak of.
OGRSpatialReference utm_at(double longitude, double latitude) {
    OGRSpatialReference system;
    system.SetWellKnownGeogCS("WGS84");
    const int zone = std::min(int(std::floor((longitude + 180) / 6)) + 1, 60);
    system.importFromEPSG((latitude >= 0 ? 32600 : 32700) + zone);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

int checked_cells(const ImportOptions& options) {
    if (!(std::abs(options.longitude) <= 180) || !(std::abs(options.latitude) <= 80)) {
        throw InputError(
            fmt::format("--center {},{}: expected LON,LAT in degrees, longitude within 180 of 0 and "
                        "latitude within 80 (there are no UTM zones beyond)",
                        options.longitude, options.latitude));
    }
    if (!(options.cell >= 0.01 && options.cell <= 1000)) {
        throw InputError(fmt::format("--cell {}: expected a cell size from 0.01 to 1000 metres", options.cell));
    }
    const int limit = int(std::sqrt(double(max_cells)));
    const double cells = std::round(options.size / options.cell);
    if (!(cells >= 1 && cells <= limit)) {
        throw InputError(fmt::format("--size {}: with cells of {} m a window can be {} to {} m wide", options.size,
                                     options.cell, options.cell, options.cell * limit));
    }
    if (!(options.size <= 100000)) {
        throw InputError(fmt::format("--size {}: a window of one UTM zone can be up to 100000 m wide", options.size));
    }
    return int(cells);
}

CellWindow window_around(const ImportOptions& options) {
    const int cells = checked_cells(options);
    const GdalScope gdal;
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const OGRSpatialReference utm = utm_at(options.longitude, options.latitude);
    const std::unique_ptr<OGRCoordinateTransformation> to_utm(OGRCreateCoordinateTransformation(&wgs84, &utm));
    double east = options.longitude;
    double north = options.latitude;
    if (!to_utm || !to_utm->Transform(1, &east, &north)) {
        throw InputError("cannot project to UTM (is the package proj-data installed?): " + gdal.failure());
    }
    const double half = cells * options.cell / 2;
    CellWindow result{{utm, {}}, cells, {}};
    result.window.bounds.MinX = east - half;
    result.window.bounds.MaxX = east + half;
    result.window.bounds.MinY = north - half;
    result.window.bounds.MaxY = north + half;
    char* text = nullptr;
    utm.exportToWkt(&text);
    result.georeference = {text ? text : "", {east - half, options.cell, 0, north + half, 0, -options.cell}};
    CPLFree(text);
    return result;
}

// For each cell the number, from 1, of the building that covers its centre, 0 for none.
std::vector<std::uint32_t> rasterise(const std::vector<Building>& buildings, const CellWindow& window) {
    const GdalScope gdal;
    GDALRegister_MEM();
    std::vector<std::uint32_t> labels(std::size_t(window.cells) * std::size_t(window.cells), 0);
    CPLStringList band;
    band.SetNameValue("DATAPOINTER", fmt::format("{}", fmt::ptr(labels.data())).c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    const GDALDatasetUniquePtr raster(driver->Create("", window.cells, window.cells, 0, GDT_UInt32, nullptr));
    raster->AddBand(GDT_UInt32, band.List());
    std::array<double, 6> transform = window.georeference.transform;
    raster->SetGeoTransform(transform.data());

    // GDAL lets the last one win.
    std::vector<OGRGeometryH> shapes;
    std::vector<double> numbers;
    for (std::size_t i = buildings.size(); i-- > 0;) {
        shapes.push_back(OGRGeometry::ToHandle(buildings[i].shape.get()));
        numbers.push_back(double(i + 1));
    }
    const int only_band = 1;
    const CPLErr outcome =
        GDALRasterizeGeometries(GDALDataset::ToHandle(raster.get()), 1, &only_band, int(shapes.size()), shapes.data(),
                                nullptr, nullptr, numbers.data(), nullptr, nullptr, nullptr);
    if (outcome != CE_None) throw InputError("the buildings cannot be rasterised: " + gdal.failure());
    return labels;
}

// Joins touching buildings (4-connected, as the paper does): each takes the source id of the building that owns most of
// its cells, of the first one among equals.
Map merged(const std::vector<std::uint32_t>& labels, int cells, std::span<const ObstacleAttributes> buildings) {
    Grid grid(cells, cells);
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            if (labels[std::size_t(y) * std::size_t(cells) + std::size_t(x)] != 0) grid.set_blocked({x, y}, true);
        }
    }
    std::vector<std::uint32_t> components = label_components(grid, Connectivity::four);
    std::unordered_map<std::uint64_t, std::uint32_t> shares;  // cells by component and building
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != 0) ++shares[std::uint64_t{components[i]} << 32 | labels[i]];
    }
    struct Owner {
        std::uint32_t cells = 0;
        std::uint32_t building = 0;
    };
    std::vector<Owner> owners;
    for (const auto& [key, count] : shares) {
        const auto component = std::size_t(key >> 32);
        const auto building = std::uint32_t(key);
        if (owners.size() <= component) owners.resize(component + 1);
        Owner& owner = owners[component];
        if (count > owner.cells || (count == owner.cells && building < owner.building)) owner = {count, building};
    }
    std::vector<ObstacleAttributes> attributes;
    for (const Owner& owner : owners) attributes.push_back(buildings[owner.building]);
    return Map::from_labels(cells, cells, std::move(components), attributes);
}

std::string title_of(const std::string& source, const ImportOptions& options, int cells) {
    std::string name = std::filesystem::path(source).filename().string();
    name.resize(std::min(name.find('.'), name.size()));
    return fmt::format("{}, {:.0f} m around {:.4f}, {:.4f}", name, cells * options.cell, options.longitude,
                       options.latitude);
}

}  // namespace

ImportReport import_city(const std::string& source, const ImportOptions& options) {
    const CellWindow window = window_around(options);
    const Buildings found = read_buildings(source, window.window);
    std::vector<ObstacleAttributes> attributes(1);
    double area = 0;
    for (const Building& building : found.buildings) {
        attributes.push_back({.source_id = building.source_id});
        area += building.area;
    }
    std::vector<std::uint32_t> labels = rasterise(found.buildings, window);
    const int cells = window.cells;
    return {.tiff = {.map = options.merge_touching ? merged(labels, cells, attributes)
                                                   : Map::from_labels(cells, cells, std::move(labels), attributes),
                     .cell_size = options.cell,
                     .georeference = window.georeference,
                     .attribution = found.from_osm ? "(c) OpenStreetMap contributors, ODbL 1.0" : "",
                     .title = title_of(source, options, cells)},
            .buildings = found.buildings.size(),
            .area = area};
}

}  // namespace waybreaker::geo

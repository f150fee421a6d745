#include "geo/city_import.hpp"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "geo/footprints.hpp"
#include "geo/gdal_scope.hpp"
#include "geo/import_window.hpp"
#include "geo/scenery.hpp"
#include "map/label.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

// A footprint as a window sees it.
struct Seen {
    const Footprint* footprint;
    double area;  // inside the window
};

// For each cell the number, from 1, of the footprint that covers its centre, 0 for none.
std::vector<std::uint32_t> rasterise(const std::vector<Seen>& seen, const CellWindow& window) {
    const GdalScope gdal;
    GDALRegister_MEM();
    std::vector<std::uint32_t> labels(std::size_t(window.width) * std::size_t(window.height), 0);
    CPLStringList band;
    band.SetNameValue("DATAPOINTER", fmt::format("{}", fmt::ptr(labels.data())).c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    const GDALDatasetUniquePtr raster(driver->Create("", window.width, window.height, 0, GDT_UInt32, nullptr));
    raster->AddBand(GDT_UInt32, band.List());
    std::array<double, 6> transform = window.georeference.transform;
    raster->SetGeoTransform(transform.data());

    // With GDAL the last one wins.
    std::vector<OGRGeometryH> shapes;
    std::vector<double> numbers;
    for (std::size_t i = seen.size(); i-- > 0;) {
        shapes.push_back(OGRGeometry::ToHandle(seen[i].footprint->shape.get()));
        numbers.push_back(double(i + 1));
    }
    const int only_band = 1;
    const CPLErr outcome =
        GDALRasterizeGeometries(GDALDataset::ToHandle(raster.get()), 1, &only_band, int(shapes.size()), shapes.data(),
                                nullptr, nullptr, numbers.data(), nullptr, nullptr, nullptr);
    if (outcome != CE_None) throw InputError("the buildings cannot be rasterised: " + gdal.failure());
    return labels;
}

ObstacleAttributes attributes_of(const Seen& seen, const ObstacleChoice& choice) {
    ObstacleAttributes attributes = seen.footprint->attributes;
    if (choice.weight.of == "area") attributes.weight = seen.area * choice.weight.factor;
    if (choice.breach_time.of == "area") attributes.breach_time = seen.area * choice.breach_time.factor;
    return attributes;
}

// What label maps are made of.
struct Labelled {
    std::vector<std::uint32_t> labels;
    std::vector<ObstacleAttributes> attributes;  // by label, entry 0 unused
    site::LabelNames names;
};

// One label for each footprint.
Labelled labelled(std::vector<std::uint32_t> labels, const std::vector<Seen>& seen, const ObstacleChoice& choice) {
    Labelled result{.labels = std::move(labels), .attributes = std::vector<ObstacleAttributes>(1), .names = {}};
    for (const Seen& one : seen) {
        const std::string& name = one.footprint->name;
        if (!name.empty()) result.names.emplace(std::uint32_t(result.attributes.size()), name);
        result.attributes.push_back(attributes_of(one, choice));
    }
    return result;
}

// Joins touching footprints (4-connected, as the paper does): each takes the source id of the one that owns most of its
// cells, of the first one among equals, and likewise the name of one that has a name. What one of them forbids holds
// for all; what they cost, where it is known, adds up.
Labelled merged(const Labelled& footprints, int width, int height, bool weighed) {
    const std::vector<std::uint32_t>& labels = footprints.labels;
    Grid grid(width, height);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != 0) grid.set_blocked({int(i % std::size_t(width)), int(i / std::size_t(width))}, true);
    }
    Labelled result{label_components(grid, Connectivity::four), std::vector<ObstacleAttributes>(1), {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> shares;  // cells by component and footprint
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] != 0) ++shares[{result.labels[i], labels[i]}];
    }
    std::uint32_t most = 0;
    std::uint32_t most_named = 0;
    for (const auto& [key, cells] : shares) {
        const auto [component, label] = key;
        const ObstacleAttributes& part = footprints.attributes[label];
        if (component == result.attributes.size()) {
            result.attributes.push_back(part);
            most = cells;
            most_named = 0;
        } else {
            ObstacleAttributes& whole = result.attributes.back();
            whole.destructible = whole.destructible && part.destructible;
            if (weighed) whole.weight += part.weight;
            whole.breach_time += part.breach_time;
            if (cells > most) {
                most = cells;
                whole.source_id = part.source_id;
            }
        }
        const auto name = footprints.names.find(label);
        if (name != footprints.names.end() && cells > most_named) {
            most_named = cells;
            result.names[component] = name->second;
        }
    }
    return result;
}

std::string title_of(const std::string& source, const CellWindow& window, double cell) {
    std::string name = std::filesystem::path(source).filename().string();
    name.resize(std::min(name.find('.'), name.size()));
    const std::string size = window.width == window.height
                                 ? fmt::format("{:.0f} m", window.width * cell)
                                 : fmt::format("{:.0f} x {:.0f} m", window.width * cell, window.height * cell);
    return fmt::format("{}, {} around {:.4f}, {:.4f}", name, size, window.center[0], window.center[1]);
}

// A source, read.
struct Material {
    Footprints footprints;
    std::vector<Sight> scenery;
    double covered = 1;
};

// The share of the window that the source has data of: of the box it states, or else of the one around what was found.
double covered_share(const Material& material, const OGREnvelope& window) {
    OGREnvelope data = material.footprints.extent;
    const auto merge = [&data](const OGRGeometry& shape) {
        OGREnvelope box;
        shape.getEnvelope(&box);
        data.Merge(box);
    };
    if (!data.IsInit()) {
        for (const Footprint& footprint : material.footprints.list) merge(*footprint.shape);
        for (const Sight& sight : material.scenery) merge(*sight.shape);
    }
    if (!data.Intersects(window)) return 0;
    data.Intersect(window);
    return (data.MaxX - data.MinX) * (data.MaxY - data.MinY) /
           ((window.MaxX - window.MinX) * (window.MaxY - window.MinY));
}

Material read_in_order(const std::string& source, const Window& window, const ImportOptions& options) {
    Material material{.footprints = read_footprints(source, window, options.choice, options.cell), .scenery = {}};
    if (options.background) material.scenery = read_scenery(source, window);
    material.covered = covered_share(material, window.bounds);
    return material;
}

Material read(const std::string& source, const Window& window, const ImportOptions& options) {
    try {
        return read_in_order(source, window, options);
    } catch (const NodesOutOfOrder&) {
        const AnyOrderOfNodes slow;
        return read_in_order(source, window, options);
    }
}

ImportReport report_of(const Material& material, const std::vector<Seen>& seen, const CellWindow& window,
                       const std::string& source, const ImportOptions& options) {
    double area = 0;
    for (const Seen& one : seen) area += one.area;
    Labelled cells = labelled(rasterise(seen, window), seen, options.choice);
    if (options.merge_touching) {
        cells = merged(cells, window.width, window.height, !options.choice.weight.of.empty());
    }
    if (!options.names) cells.names.clear();
    std::vector<site::NamedCell> named = site::named_cells(std::move(cells.names), cells.labels);
    LabelTiff tiff{.map = Map::from_labels(window.width, window.height, std::move(cells.labels), cells.attributes),
                   .cell_size = options.cell,
                   .georeference = window.georeference,
                   .attribution = material.footprints.from_osm ? "(c) OpenStreetMap contributors, ODbL 1.0" : "",
                   .title = title_of(source, window, options.cell),
                   .background = background_within(material.scenery, window.window.bounds, options.cell)};
    tiff.names = site::obstacle_names(tiff.map, std::move(named));
    return {.tiff = std::move(tiff), .buildings = seen.size(), .area = area, .covered = material.covered};
}

std::vector<Seen> seen_in(const Footprints& footprints, const OGREnvelope& bounds) {
    const GdalScope gdal;
    std::vector<Seen> seen;
    for (const Footprint& footprint : footprints.list) {
        const double area = area_inside(*footprint.shape, bounds);
        if (area > 0) seen.push_back({&footprint, area});
    }
    return seen;
}

}  // namespace

ImportReport import_city(const std::string& source, const ImportOptions& options) {
    const CellWindow window = import_window(options);
    const Material material = read(source, window.window, options);
    std::vector<Seen> seen;
    for (const Footprint& footprint : material.footprints.list) seen.push_back({&footprint, footprint.area});
    return report_of(material, seen, window, source, options);
}

std::size_t import_tiles(const std::string& source, const ImportOptions& options, double side,
                         const std::function<void(const ImportTile&)>& visit) {
    const CellWindow window = import_window(options);
    const double cells = std::round(side / options.cell);
    const int least = std::min(window.width, window.height);
    if (!(cells >= 1 && cells <= least)) {
        throw InputError(fmt::format("--tile {}: the window has {} x {} m, and cells have {} m: no such tile fits",
                                     side, window.width * options.cell, window.height * options.cell, options.cell));
    }
    const Material material = read(source, window.window, options);
    const int tile = int(cells);
    for (int row = 0; row < window.height / tile; ++row) {
        for (int column = 0; column < window.width / tile; ++column) {
            const CellWindow part = part_of(window, column * tile, row * tile, tile, tile);
            const std::vector<Seen> seen = seen_in(material.footprints, part.window.bounds);
            if (seen.empty()) continue;
            const ImportReport report = report_of(material, seen, part, source, options);
            if (!report.tiff.map.obstacles().empty()) visit({column, row, report});
        }
    }
    return std::size_t(window.width / tile) * std::size_t(window.height / tile);
}

}  // namespace waybreaker::geo

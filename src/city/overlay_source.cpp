#include "city/overlay_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "city/features.hpp"
#include "city/footprints.hpp"
#include "city/import_window.hpp"
#include "city/label_raster.hpp"
#include "city/vector_source.hpp"
#include "core/in_quotes.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

constexpr double widest_line = 10000;  // metres of a line; above, `width` is in other units

struct Thing {
    std::vector<Geometry> areas = {};  // in the window's system
    std::vector<Geometry> lines = {};  // whose strips are among the areas
    std::string name = {};
    ObstacleAttributes attributes = {};
};

// What does not become a thing.
struct LeftOut {
    std::size_t shapeless = 0;
    std::size_t points = 0;  // of no width
};

// Makes things of the features of a source.
class OverlayReader {
  public:
    OverlayReader(const CellWindow& window, const OverlaySource& source, const OverlayCosts& costs)
        : window_(window), source_(source), costs_(costs) {}

    void see(const Feature& feature) {
        if (!feature.geometry) return void(++left_out.shapeless);
        Thing thing;
        const double said = feature.tags.number("width").value_or(0);
        take(*feature.geometry, said > 0 && said <= widest_line ? said : source_.width, thing);
        if (thing.areas.empty()) return;
        if (const std::string* const name = feature.tags.find("name")) thing.name = labels::clean_name(*name);
        const auto weight = quantity_of(costs_.weight, feature, thing, least_weight, most_weight);
        const auto breach_time = quantity_of(costs_.breach_time, feature, thing, 0, most_breach_time);
        says_weight = says_weight || weight;
        says_breach_time = says_breach_time || breach_time;
        thing.attributes = {
            .source_id = feature.source_id, .weight = weight.value_or(1), .breach_time = breach_time.value_or(0)};
        things.push_back(std::move(thing));
    }

    std::vector<Thing> things;
    LeftOut left_out;
    bool says_weight = false;  // some thing
    bool says_breach_time = false;

  private:
    // Areas as they are, lines and points as wide as they are.
    void take(const OGRGeometry& shape, double width, Thing& thing) {
        const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
        if (is_area(type)) return thing.areas.emplace_back(shape.clone()), void();
        if (is_line(type)) {
            const double cell = window_.georeference.transform[1];
            constexpr int quarter_circle = 4;  // corners
            if (Geometry strip{shape.Buffer(std::max(width, cell) / 2, quarter_circle)}) {
                thing.areas.push_back(std::move(strip));
                thing.lines.emplace_back(shape.clone());
            }
            return;
        }
        if (!(width > 0)) return void(++left_out.points);
        if (Geometry disc{shape.Buffer(width / 2)}) thing.areas.push_back(std::move(disc));
    }

    std::optional<double> quantity_of(const Quantity& quantity, const Feature& feature, const Thing& thing,
                                      double least, double most) const {
        if (quantity.of.empty()) return std::nullopt;
        double value = 0;
        if (quantity.of == "area") {
            for (const Geometry& area : thing.areas) value += area_inside(*area, window_.window.bounds);
        } else {
            value = feature.tags.number(quantity.of).value_or(0);
        }
        return value > 0 ? std::optional(std::clamp(value * quantity.factor, least, most)) : std::nullopt;
    }

    const CellWindow& window_;
    const OverlaySource& source_;
    const OverlayCosts& costs_;
};

// Everything that has a place.
FeatureQuery everything(const OGRSpatialReference& system) {
    FeatureQuery query{.system = system};
    query.points.emplace();
    query.lines.emplace();
    query.areas.emplace();
    query.obstacles = true;
    return query;
}

// GeoJSON is in degrees, says GDAL, whatever its numbers are: what lies nowhere is not just beside the map.
void require_degrees_of(const std::string& source) {
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    visit_features(source, everything(degrees), [&source](const Feature& feature) {
        OGREnvelope box;
        if (!feature.geometry) return;
        feature.geometry->getEnvelope(&box);
        require_degrees(box, source);
    });
}

std::vector<std::uint32_t> rasterise(const std::vector<Thing>& things, site::OverlayUse use, const CellWindow& window) {
    std::vector<std::uint32_t> labels(std::size_t(window.width) * std::size_t(window.height), 0);
    std::vector<Paint> areas;
    std::vector<Paint> lines;
    for (std::size_t i = things.size(); i-- > 0;) {
        const auto label = std::uint32_t(i + 1);
        for (const Geometry& area : things[i].areas) areas.push_back({area.get(), label});
        for (const Geometry& line : things[i].lines) lines.push_back({line.get(), label});
    }
    // What opens the way opens all cells that its line touches, as ways do.
    if (use == site::OverlayUse::free) paint(lines, Cover::touched, window, labels);
    paint(areas, Cover::centre, window, labels);
    return labels;
}

void note(const LeftOut& left_out, std::size_t things, std::vector<std::string>& notes) {
    if (const std::size_t count = left_out.points; count > 0) {
        notes.push_back(fmt::format("{}; a width makes a disc of {}",
                                    count == 1 ? "1 point is left out" : fmt::format("{} points are left out", count),
                                    count == 1 ? "it" : "each"));
    }
    if (const std::size_t count = left_out.shapeless; count > 0) {
        notes.push_back(fmt::format("{} left out: {} no coordinates, or such as are no numbers",
                                    count == 1 ? "1 feature is" : fmt::format("{} features are", count),
                                    count == 1 ? "it has" : "they have"));
    }
    if (things == 0) notes.emplace_back("nothing of it lies on the map");
}

void note_unsaid(const Quantity& quantity, const char* otherwise, std::vector<std::string>& notes) {
    if (quantity.of.empty() || quantity.of == "area") return;
    notes.push_back(
        fmt::format("nothing of it says a number above 0 as {}: each {}", in_quotes(quantity.of), otherwise));
}

// What captions call the overlay of a file: its name up to the first dot.
std::string name_of(const std::string& file) {
    std::string name = labels::clean_name(std::filesystem::path(file).filename().string());
    name.resize(std::min(name.find('.'), name.size()));
    return name;
}

}  // namespace

ReadOverlay read_overlay(const OverlaySource& source, const site::Georeference& place, int width, int height,
                         const OverlayCosts& costs) {
    const CellWindow window = window_of(place, width, height);
    OverlayReader reader(window, source, costs);
    FeatureQuery query = everything(window.window.system);
    query.bounds = window.window.bounds;
    visit_features(source.file, query, [&reader](const Feature& feature) { reader.see(feature); });
    std::vector<Thing>& things = reader.things;
    if (things.empty()) require_degrees_of(source.file);
    site::LabelLayer layer{.width = window.width,
                           .height = window.height,
                           .labels = rasterise(things, source.use, window),
                           .attributes = std::vector<ObstacleAttributes>(1)};
    OverlayReport report{.file = source.file, .use = source.use};
    std::vector<bool> seen(things.size() + 1, false);
    for (const std::uint32_t label : layer.labels) {
        if (label == 0) continue;
        ++report.cells;
        if (!seen[label]) ++report.things;
        seen[label] = true;
    }
    for (Thing& thing : things) {
        if (!thing.name.empty()) layer.names.emplace(std::uint32_t(layer.attributes.size()), std::move(thing.name));
        layer.attributes.push_back(thing.attributes);
    }
    note(reader.left_out, report.things, report.notes);
    const bool is_removable = source.use == site::OverlayUse::debris || source.use == site::OverlayUse::wall;
    if (is_removable && !things.empty()) {
        if (!reader.says_weight) note_unsaid(costs.weight, "weighs 1", report.notes);
        if (!reader.says_breach_time) note_unsaid(costs.breach_time, "takes no time of its own", report.notes);
    }
    return {{.name = name_of(source.file), .use = source.use, .things = std::move(layer)}, std::move(report)};
}

OverlayReport lay_over(const OverlaySource& source, const site::Georeference& place, const OverlayCosts& costs,
                       site::DescribedMap& map) {
    ReadOverlay read = read_overlay(source, place, map.map.width(), map.map.height(), costs);
    if (std::string doubt = site::doubt(map.annotations, read.overlay); !doubt.empty()) {
        read.report.notes.push_back(std::move(doubt));
    }
    map = site::laid_over(map.map, std::move(map.annotations), read.overlay);
    return std::move(read.report);
}

}  // namespace waybreaker::city

#include "city/no_fly.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "city/features.hpp"
#include "city/import_window.hpp"
#include "city/vector_source.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

constexpr int quarter_of_circle = 8;  // corners
constexpr double coarsest = 16;       // cells by which outlines are simplified at most
constexpr double beyond = 2;          // cells, so that no zone has a corner on the edge of the map

// https://wiki.openstreetmap.org/wiki/ [Key:aeroway], [Tag:amenity=prison], [Key:military], [Tag:landuse=military].
// Bunkers and trenches are mostly ruins.
const std::vector<TagFilter>& kept_clear() {
    static const std::vector<TagFilter> filters{{"aeroway", {"aerodrome", "heliport", "helipad"}},
                                                {"amenity", {"prison"}},
                                                {"landuse", {"military"}},
                                                {"military",
                                                 {"airfield", "barracks", "base", "danger_area", "naval_base",
                                                  "nuclear_explosion_site", "range", "training_area"}}};
    return filters;
}

struct Cleared {
    std::string name;
    Geometry shape;  // with its clearance
};

// "Heliport Krems", else what it is.
std::string name_of(const TagSet& tags) {
    for (const char* const key : {"name", "ref"}) {
        const std::string* const name = tags.find(key);
        if (name != nullptr && !labels::clean_name(*name).empty()) return labels::clean_name(*name);
    }
    for (const TagFilter& filter : kept_clear()) {
        if (!tags.matches(filter)) continue;
        std::string value = *tags.find(filter.key);
        std::ranges::replace(value, '_', ' ');
        return value == "military" || filter.key != "military" ? value : "military " + value;
    }
    return "";
}

OGREnvelope grown(OGREnvelope bounds, double by) {
    bounds.MinX -= by;
    bounds.MinY -= by;
    bounds.MaxX += by;
    bounds.MaxY += by;
    return bounds;
}

std::vector<Cleared> places_in(const std::string& source, const Window& window, double clearance) {
    std::vector<Cleared> places;
    FeatureQuery query{.system = window.system, .bounds = grown(window.bounds, clearance)};
    query.points = query.areas = kept_clear();
    visit_features(source, query, [&](const Feature& feature) {
        if (!feature.geometry || !feature.tags.matches_any(kept_clear())) return;
        Geometry shape(feature.geometry->Buffer(clearance, quarter_of_circle));
        if (shape && !shape->IsEmpty()) places.push_back({name_of(feature.tags), std::move(shape)});
    });
    return places;
}

std::vector<Point> ring_of(const OGRLinearRing& ring, const std::array<double, 6>& transform) {
    std::vector<Point> corners;
    for (int i = 0; i + 1 < ring.getNumPoints(); ++i)
        corners.emplace_back((ring.getX(i) - transform[0]) / transform[1] - 0.5,
                             (ring.getY(i) - transform[3]) / transform[5] - 0.5);
    return corners;
}

void add_zones(const OGRGeometry& shape, const std::string& name, const std::array<double, 6>& transform,
               std::vector<Zone>& zones) {
    if (const auto type = wkbFlatten(shape.getGeometryType()); type == wkbPolygon) {
        const OGRPolygon& polygon = *shape.toPolygon();
        Zone zone{.kind = ZoneKind::no_fly, .name = name};
        for (const OGRLinearRing* const ring : polygon) zone.polygon.push_back(ring_of(*ring, transform));
        if (!zone.polygon.empty() && zone.polygon.front().size() >= 3) zones.push_back(std::move(zone));
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
        for (const OGRGeometry* const part : *shape.toGeometryCollection()) add_zones(*part, name, transform, zones);
    }
}

std::size_t corners_of(const std::vector<Zone>& zones) {
    std::size_t count = 0;
    for (const Zone& zone : zones) {
        for (const std::vector<Point>& ring : zone.polygon) count += ring.size();
    }
    return count;
}

}  // namespace

std::vector<Zone> no_fly_zones(const std::string& source, const ImportOptions& options, double clearance) {
    const CellWindow cells = import_window(options);
    const geotiff::GdalScope gdal;
    const double edge = beyond * options.cell;
    const OGRPolygon frame = rectangle(grown(cells.window.bounds, edge));
    const std::vector<Cleared> places = places_in(source, cells.window, clearance);
    for (double tolerance = options.cell / 2; tolerance <= coarsest * options.cell; tolerance *= 2) {
        std::vector<Zone> zones;
        for (const Cleared& place : places) {
            const Geometry inside(place.shape->Intersection(&frame));
            const Geometry simple(inside ? inside->SimplifyPreserveTopology(tolerance) : nullptr);
            if (simple) add_zones(*simple, place.name, cells.georeference.transform, zones);
        }
        if (corners_of(zones) <= most_zone_corners) return zones;
    }
    throw refusal(source, "has more no-fly zones in the window than can be planned with; import a smaller one");
}

}  // namespace waybreaker::city

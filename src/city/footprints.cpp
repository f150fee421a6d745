#include "city/footprints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "city/filter_use.hpp"
#include "city/ground_rules.hpp"
#include "city/premises.hpp"
#include "city/tag_set.hpp"
#include "city/vector_source.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

constexpr auto no_polygons = "has no polygons; buildings are expected as polygons";

using Shape = site::Background::Shape;

const std::vector<TagFilter>& buildings() {
    static const std::vector<TagFilter> filters{{.key = "building"}};
    return filters;
}

// A building that is a line is an unclosed outline.
std::vector<TagFilter> filters_of(const ObstacleChoice& choice, Shape shape) {
    std::vector<TagFilter> filters = choice.obstacles.empty() ? buildings() : choice.obstacles;
    if (shape == Shape::line) std::erase_if(filters, [](const TagFilter& filter) { return filter.key == "building"; });
    return filters;
}

// Which features are obstacles. By default buildings; of a layer that knows no such tag everything is one.
bool is_obstacle(const Feature& feature, const ObstacleChoice& choice) {
    const bool usual = choice.obstacles.empty();
    if (usual && feature.of_building_layer) return true;
    return feature.tags.matches_any(filters_of(choice, feature.shape)) &&
           (!usual || !choice.only_in_the_way || stands_in_the_way(feature.tags));
}

FeatureQuery query_of(const ObstacleChoice& choice, const OGRSpatialReference& system) {
    FeatureQuery query{.system = system};
    query.areas = filters_of(choice, Shape::area);
    if (choice.wants_lines()) query.lines = filters_of(choice, Shape::line);
    query.layer = choice.layer;
    query.buildings = choice.obstacles.empty();
    query.obstacles = true;
    return query;
}

OGRSpatialReference degrees() {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    return wgs84;
}

ObstacleAttributes attributes_of(const Feature& feature, const ObstacleChoice& choice) {
    const TagSet& tags = feature.tags;
    const auto number = [&](const Quantity& quantity) {
        const std::optional<double> value =
            quantity.of.empty() || quantity.of == "area" ? std::nullopt : tags.number(quantity.of);
        return value && *value > 0 ? std::optional(*value * quantity.factor) : std::nullopt;
    };
    return {.destructible = (choice.destructible.empty() || tags.matches_any(choice.destructible)) &&
                            !tags.matches_any(choice.protect),
            .source_id = feature.source_id,
            .weight = number(choice.weight).value_or(1),
            .breach_time = number(choice.breach_time).value_or(0)};
}

// Its name, else its address.
std::string name_of(const TagSet& tags) {
    for (const char* key : {"name", "addr:housename"}) {
        if (const std::string* const text = tags.find(key)) {
            std::string name = labels::clean_name(*text);
            if (!name.empty()) return name;
        }
    }
    const std::string* const street = tags.find("addr:street");
    const std::string* const number = tags.find("addr:housenumber");
    return street && number ? labels::clean_name(*street + " " + *number) : "";
}

// Not measured yet.
Footprint footprint_of(Feature feature, const ObstacleChoice& choice) {
    Footprint footprint{.shape = std::move(feature.geometry),
                        .attributes = attributes_of(feature, choice),
                        .name = name_of(feature.tags),
                        .kind = choice.obstacles.empty() ? site::ObstacleKind::building : site::ObstacleKind::unknown,
                        .sheltered = feature.tags.matches_any(choice.shelter),
                        .tags = kept_tags(feature.tags)};
    if (footprint.sheltered) footprint.attributes.destructible = false;
    return footprint;
}

// Makes a strip of a line; false if nothing lies in the window.
bool place(Footprint& footprint, const Window& window, double line_width) {
    const geotiff::GdalScope gdal;
    if (is_line(footprint.shape->getGeometryType())) footprint.shape.reset(footprint.shape->Buffer(line_width / 2));
    footprint.area = footprint.shape ? area_inside(*footprint.shape, window.bounds) : 0;
    return footprint.area > 0;
}

// For error messages, if the window contains none of them.
std::string whereabouts(const ObstacleChoice& choice, const std::string& source) {
    OGREnvelope everywhere;
    visit_features(source, query_of(choice, degrees()), [&](const Feature& feature) {
        if (!feature.geometry || !is_obstacle(feature, choice)) return;
        OGREnvelope box;
        feature.geometry->getEnvelope(&box);
        everywhere.Merge(box);
    });
    if (!everywhere.IsInit()) return "nor anywhere else";
    require_degrees(everywhere, source);
    return fmt::format("its {} lie between {:.4f},{:.4f} and {:.4f},{:.4f} (LON,LAT)",
                       choice.obstacles.empty() ? "buildings" : "obstacles of that kind", everywhere.MinX,
                       everywhere.MinY, everywhere.MaxX, everywhere.MaxY);
}

// Grounds say for their buildings what these need not say.
void see_premises(const std::string& source, const ObstacleChoice& choice, FilterUse& use) {
    const std::vector<TagFilter> filters = premises_filters(choice);
    FeatureQuery query{.system = degrees()};
    query.points = query.areas = filters;
    visit_features(source, query, [&](const Feature& feature) {
        const auto premises = premises_of(feature.tags, feature.shape, filters);
        if (feature.geometry && premises) use.see(*premises);
    });
}

// A filter without a match in the window may have one elsewhere: searches the whole source.
void require_matches(const ObstacleChoice& choice, const std::string& source, FilterUse& use) {
    if (use.all_used()) return;
    visit_features(source, query_of(choice, degrees()), [&](const Feature& feature) {
        if (feature.geometry && is_obstacle(feature, choice)) use.see(feature.tags);
    });
    if (!choice.premises.empty() && !use.all_used()) see_premises(source, choice, use);
    use.require_all(source);
}

}  // namespace

double area_inside(const OGRGeometry& shape, const OGREnvelope& bounds) {
    const auto area = [](const OGRGeometry& g) {
        return OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&g)));
    };
    OGREnvelope box;
    shape.getEnvelope(&box);
    if (bounds.Contains(box)) return area(shape);
    if (!bounds.Intersects(box)) return 0;
    const OGRPolygon window = rectangle(bounds);
    const std::unique_ptr<OGRGeometry> valid(shape.MakeValid());
    const std::unique_ptr<OGRGeometry> part(valid ? valid->Intersection(&window) : nullptr);
    return part ? area(*part) : 0;
}

OGREnvelope visit_buildings(const std::string& source, const std::function<void(const OGRGeometry& outline)>& visit) {
    const ObstacleChoice choice{.only_in_the_way = true};
    const FeatureReport report = visit_features(source, query_of(choice, degrees()), [&](const Feature& feature) {
        if (feature.geometry && is_obstacle(feature, choice)) visit(*feature.geometry);
    });
    if (!report.any_layer) throw refusal(source, no_polygons);
    return report.extent;
}

Footprints read_footprints(const std::string& source, const Window& window, const ObstacleChoice& choice, double cell) {
    Footprints result;
    std::vector<Footprint> strips;
    FilterUse use(choice);
    FeatureQuery query = query_of(choice, window.system);
    query.bounds = window.bounds;
    FeatureReport report = visit_features(source, query, [&](Feature feature) {
        if (!is_obstacle(feature, choice)) return;
        if (!feature.geometry) {
            ++result.shapeless;
            return;
        }
        use.see(feature.tags);
        std::vector<Footprint>& list = feature.shape == Shape::line ? strips : result.list;
        Footprint footprint = footprint_of(std::move(feature), choice);
        if (place(footprint, window, std::max(choice.wall_width, cell))) list.push_back(std::move(footprint));
    });
    if (!report.any_layer) throw refusal(source, no_polygons);
    require_matches(choice, source, use);
    std::move(strips.begin(), strips.end(), std::back_inserter(result.list));
    result.from_osm = report.from_osm;
    result.extent = report.extent;
    result.data = std::move(report.data);
    for (CutArea& area : report.cut) {
        if (is_obstacle({.tags = area.tags}, choice)) result.cut.push_back(std::move(area));
    }
    result.defects = std::move(report.defects);
    return result;
}

InputError nothing_in_window(const std::string& source, const ObstacleChoice& choice) {
    return refusal(source, fmt::format("has no {} in the window; {}",
                                       choice.obstacles.empty() ? "building" : "obstacle of that kind",
                                       whereabouts(choice, source)));
}

}  // namespace waybreaker::city

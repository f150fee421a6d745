#include "geo/scenery.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geo/feature_tags.hpp"
#include "geo/gdal_scope.hpp"
#include "geo/obstacle_names.hpp"

namespace waybreaker::geo {
namespace {

using Kind = site::Background::Kind;
using Shape = site::Background::Shape;

// Features of a shape with a tag are scenery.
struct Rule {
    Kind kind;
    int rank;
    std::vector<Shape> shapes;
    TagFilter filter;
    bool only_named = false;  // excludes ways across courtyards, and pavements on both sides of streets
};

// The first matching rule applies.
const std::vector<Rule>& rules() {
    static const std::vector<Rule> all{
        {Kind::street,
         0,
         {Shape::line},
         {"highway",
          {"motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link", "secondary",
           "secondary_link"}}},
        {Kind::street, 1, {Shape::line}, {"highway", {"tertiary", "tertiary_link"}}},
        {Kind::street,
         2,
         {Shape::line},
         {"highway", {"unclassified", "residential", "living_street", "pedestrian", "road"}}},
        {Kind::street, 2, {Shape::area}, {"highway", {"pedestrian"}}, true},
        {Kind::street,
         3,
         {Shape::line},
         {"highway", {"service", "track", "footway", "path", "cycleway", "steps", "bridleway"}},
         true},
        {Kind::rail, 0, {Shape::line}, {"railway", {"rail", "light_rail", "narrow_gauge", "monorail", "funicular"}}},
        {Kind::rail, 1, {Shape::line}, {"railway", {"subway", "tram"}}},
        {Kind::water, 0, {Shape::area}, {"natural", {"water"}}},
        {Kind::water, 0, {Shape::area}, {"waterway", {"riverbank", "dock"}}},
        {Kind::water, 0, {Shape::area}, {"landuse", {"reservoir", "basin"}}},
        {Kind::water, 0, {Shape::line}, {"waterway", {"river", "canal"}}},
        {Kind::water, 0, {Shape::line}, {"natural", {"coastline"}}},
        {Kind::water, 2, {Shape::line}, {"waterway", {"stream"}}},
        {Kind::green, 1, {Shape::area}, {"leisure", {"park", "garden", "golf_course", "nature_reserve"}}},
        {Kind::green, 1, {Shape::area}, {"natural", {"wood", "scrub", "heath", "grassland"}}},
        {Kind::green, 1, {Shape::area}, {"landuse", {"forest", "cemetery", "recreation_ground", "village_green"}}},
        {Kind::green, 3, {Shape::area}, {"landuse", {"grass", "meadow", "allotments", "orchard", "vineyard"}}},
        {Kind::place, 0, {Shape::point}, {"place", {"city", "town", "borough", "suburb", "village", "island"}}, true},
        {Kind::place,
         2,
         {Shape::point, Shape::area},
         {"place", {"quarter", "neighbourhood", "square", "hamlet", "islet", "locality"}},
         true}};
    return all;
}

std::vector<TagFilter> all_filters() {
    std::vector<TagFilter> filters;
    for (const Rule& rule : rules()) {
        const bool known = std::any_of(filters.begin(), filters.end(),
                                       [&](const TagFilter& filter) { return filter.key == rule.filter.key; });
        if (!known) filters.push_back({.key = rule.filter.key});
    }
    return filters;
}

std::optional<Shape> shape_of(const OGRFeature& feature) {
    const OGRGeometry* geometry = feature.GetGeometryRef();
    if (geometry == nullptr) return std::nullopt;
    const OGRwkbGeometryType type = geometry->getGeometryType();
    if (is_area(type)) return Shape::area;
    if (is_line(type)) return Shape::line;
    return wkbFlatten(type) == wkbPoint ? std::optional(Shape::point) : std::nullopt;
}

// One layer of the source.
class SceneryLayer {
  public:
    SceneryLayer(OGRLayer& layer, const Window& window, const std::string& source)
        : tags_(layer), window_(window), to_window_(transformation(system_of(layer, source), window.system)) {
        // If GDAL's OSM driver skips points, ways lose them too.
        if (wkbFlatten(layer.GetGeomType()) != wkbPoint) {
            const OGREnvelope bounds = bounds_in(system_of(layer, source), window, source);
            layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
        }
        layer.SetAttributeFilter(tags_.condition(all_filters()).c_str());
    }

    std::optional<Sight> sight(OGRFeature& feature) const {
        const std::optional<Shape> shape = shape_of(feature);
        if (!shape || says(feature, "tunnel")) return std::nullopt;
        for (const Rule& rule : rules()) {
            if (std::find(rule.shapes.begin(), rule.shapes.end(), *shape) == rule.shapes.end()) continue;
            const std::optional<std::string> type = tags_.value(feature, rule.filter.key);
            if (type && rule.filter.accepts(*type)) return sight(feature, rule, *type);
        }
        return std::nullopt;
    }

  private:
    bool says(const OGRFeature& feature, const char* key) const {
        return tags_.value(feature, key).value_or("no") != "no";
    }

    std::optional<Sight> sight(OGRFeature& feature, const Rule& rule, const std::string& type) const {
        const std::string name = clean_name(tags_.value(feature, "name").value_or(""));
        const bool siding = rule.kind == Kind::rail && says(feature, "service");
        if ((rule.only_named && name.empty()) || siding) return std::nullopt;
        const GdalScope gdal;
        std::unique_ptr<OGRGeometry> shape(feature.StealGeometry());
        if (shape->transform(to_window_.get()) != OGRERR_NONE) return std::nullopt;
        shape.reset(shape->getLinearGeometry());
        OGREnvelope box;
        shape->getEnvelope(&box);
        if (!window_.bounds.Intersects(box)) return std::nullopt;
        return Sight{rule.kind, rule.rank, type, name, std::move(shape)};
    }

    FeatureTags tags_;
    const Window& window_;
    Transformation to_window_;
};

bool can_have_scenery(OGRLayer& layer) {
    const FeatureTags tags(layer);
    const std::vector<TagFilter> filters = all_filters();
    return std::any_of(filters.begin(), filters.end(),
                       [&](const TagFilter& filter) { return tags.can_have(filter.key); });
}

// By layer, of those that say where they lie. In OpenStreetMap's files without the layers of relations that are not
// areas.
std::map<const OGRLayer*, SceneryLayer> layers_of(GDALDataset& file, const Window& window, const std::string& source) {
    const bool osm = EQUAL(file.GetDriverName(), "OSM");
    if (osm) {
        file.ReleaseResultSet(file.ExecuteSQL("SET interest_layers = points,lines,multipolygons", nullptr, nullptr));
    }
    std::map<const OGRLayer*, SceneryLayer> layers;
    for (OGRLayer* layer : file.GetLayers()) {
        const std::string name = layer->GetName();
        const bool wanted = !osm || name == "points" || name == "lines" || name == "multipolygons";
        if (wanted && layer->GetSpatialRef() != nullptr && can_have_scenery(*layer)) {
            layers.emplace(std::piecewise_construct, std::forward_as_tuple(layer),
                           std::forward_as_tuple(*layer, window, source));
        }
    }
    return layers;
}

}  // namespace

std::vector<Sight> read_scenery(const std::string& source, const Window& window) {
    const GDALDatasetUniquePtr file = open_source(source);
    const GdalScope gdal;
    const std::map<const OGRLayer*, SceneryLayer> layers = layers_of(*file, window, source);
    std::vector<Sight> scenery;
    if (layers.empty()) return scenery;
    for (const GDALDataset::FeatureLayerPair& read : file->GetFeatures()) {
        const auto layer = layers.find(read.layer);
        if (layer == layers.end()) continue;
        if (std::optional<Sight> sight = layer->second.sight(*read.feature)) scenery.push_back(std::move(*sight));
    }
    require_read(gdal, source);
    return scenery;
}

}  // namespace waybreaker::geo

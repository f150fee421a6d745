#include "geo/footprints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geo/feature_tags.hpp"
#include "geo/gdal_scope.hpp"
#include "geo/obstacle_names.hpp"
#include "geo/vector_source.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

// What a layer is read for.
enum class Kind { areas, lines };

bool is_of(Kind kind, OGRwkbGeometryType type) {
    return kind == Kind::areas ? is_area(type) : is_line(type);
}

std::vector<OGRLayer*> layers_of(GDALDataset& file, Kind kind) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : file.GetLayers()) {
        const OGRwkbGeometryType type = layer->GetGeomType();
        if (is_of(kind, type) || wkbFlatten(type) == wkbUnknown) layers.push_back(layer);
    }
    // The OSM driver sorts a file's objects into five layers at once and would hoard those nobody reads. Other lines
    // than those of its layer `lines` come in layers of relations.
    if (EQUAL(file.GetDriverName(), "OSM")) {
        const char* const name = kind == Kind::areas ? "multipolygons" : "lines";
        std::erase_if(layers, [&](OGRLayer* layer) { return !EQUAL(layer->GetName(), name); });
        const std::string only = std::string("SET interest_layers = ") + name;
        file.ReleaseResultSet(file.ExecuteSQL(only.c_str(), nullptr, nullptr));
    }
    return layers;
}

const std::vector<TagFilter>& buildings() {
    static const std::vector<TagFilter> filters{{.key = "building"}};
    return filters;
}

// Which features of a layer are obstacles. By default buildings; in a layer that knows no such tag everything is one.
class Selection {
  public:
    Selection(const FeatureTags& tags, const ObstacleChoice& choice, Kind kind)
        : tags_(tags), kind_(kind), filters_(choice.obstacles.empty() ? buildings() : choice.obstacles) {
        all_ = choice.obstacles.empty() && !tags.can_have("building");
        // A building that is a line is one that nobody has closed.
        if (kind == Kind::lines)
            std::erase_if(filters_, [](const TagFilter& filter) { return filter.key == "building"; });
    }

    std::string condition() const { return all_ ? "" : tags_.condition(filters_); }

    bool takes(const OGRFeature& feature) const {
        const OGRGeometry* shape = feature.GetGeometryRef();
        return shape && is_of(kind_, shape->getGeometryType()) && (all_ || tags_.matches_any(feature, filters_));
    }

  private:
    const FeatureTags& tags_;
    Kind kind_;
    std::vector<TagFilter> filters_;
    bool all_;
};

// Calls visit(feature, tags) for the obstacles of a layer.
template <typename Visit>
void for_each_obstacle(OGRLayer& layer, Kind kind, const ObstacleChoice& choice, const std::string& source,
                       Visit visit) {
    const GdalScope gdal;
    const FeatureTags tags(layer);
    const Selection selection(tags, choice, kind);
    // Not for speed alone: GDAL's OSM driver takes the outer way of any relation for a part of that relation, so that a
    // building whose outline also bounds, say, its lowest storey (the Empire State Building) is lost; unless the
    // relation itself does not pass this filter.
    const std::string condition = selection.condition();
    layer.SetAttributeFilter(condition.empty() ? nullptr : condition.c_str());
    for (const OGRFeatureUniquePtr& feature : layer) {
        if (selection.takes(*feature)) visit(*feature, tags);
    }
    if (gdal.failed()) throw refusal(source, "is damaged or cut short: " + gdal.failure());
}

ObstacleAttributes attributes_of(const OGRFeature& feature, const FeatureTags& tags, const ObstacleChoice& choice) {
    const auto number = [&](const Quantity& quantity) {
        const std::optional<double> value =
            quantity.of.empty() || quantity.of == "area" ? std::nullopt : tags.number(feature, quantity.of);
        return value && *value > 0 ? std::optional(*value * quantity.factor) : std::nullopt;
    };
    return {.destructible = (choice.destructible.empty() || tags.matches_any(feature, choice.destructible)) &&
                            !tags.matches_any(feature, choice.protect),
            .source_id = tags.source_id(feature),
            .weight = number(choice.weight).value_or(1),
            .breach_time = number(choice.breach_time).value_or(0)};
}

// What people call it: its own name, else its address.
std::string name_of(const OGRFeature& feature, const FeatureTags& tags) {
    for (const char* key : {"name", "addr:housename"}) {
        if (const std::optional<std::string> text = tags.value(feature, key)) {
            std::string name = clean_name(*text);
            if (!name.empty()) return name;
        }
    }
    const std::optional<std::string> street = tags.value(feature, "addr:street");
    const std::optional<std::string> number = tags.value(feature, "addr:housenumber");
    return street && number ? clean_name(*street + " " + *number) : "";
}

// The obstacles of a layer whose bounding boxes meet `bounds`, in the layer's own coordinates, not measured yet.
std::vector<Footprint> scan(OGRLayer& layer, Kind kind, const ObstacleChoice& choice, const OGREnvelope& bounds,
                            const std::string& source) {
    std::vector<Footprint> found;
    layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
    for_each_obstacle(layer, kind, choice, source, [&](OGRFeature& feature, const FeatureTags& tags) {
        Footprint& footprint = found.emplace_back();
        footprint.attributes = attributes_of(feature, tags, choice);
        footprint.name = name_of(feature, tags);
        footprint.shape.reset(feature.StealGeometry());
    });
    return found;
}

// Moves footprints into the window's system, makes strips of lines, measures all and drops those outside; also what
// cannot be projected, which reaches too far around the globe to be an obstacle.
std::vector<Footprint> placed(std::vector<Footprint> footprints, const OGRSpatialReference& system,
                              const Window& window, double line_width) {
    const GdalScope gdal;
    const Transformation to_window = transformation(system, window.system);
    std::erase_if(footprints, [&](Footprint& footprint) {
        if (footprint.shape->transform(to_window.get()) != OGRERR_NONE) return true;
        footprint.shape.reset(footprint.shape->getLinearGeometry());
        if (footprint.shape && is_line(footprint.shape->getGeometryType())) {
            footprint.shape.reset(footprint.shape->Buffer(line_width / 2));
        }
        footprint.area = footprint.shape ? area_inside(*footprint.shape, window.bounds) : 0;
        return !(footprint.area > 0);
    });
    return footprints;
}

// For somebody whose window missed them all.
std::string whereabouts(const std::vector<Kind>& kinds, const ObstacleChoice& choice, const std::string& source) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    OGREnvelope everywhere;
    for (const Kind kind : kinds) {
        const GDALDatasetUniquePtr file = open_source(source);
        for (OGRLayer* layer : layers_of(*file, kind)) {
            OGREnvelope extent;
            for_each_obstacle(*layer, kind, choice, source, [&](const OGRFeature& feature, const FeatureTags&) {
                OGREnvelope box;
                feature.GetGeometryRef()->getEnvelope(&box);
                extent.Merge(box);
            });
            if (!extent.IsInit()) continue;
            if (const auto box = transformed(extent, *layer->GetSpatialRef(), wgs84)) everywhere.Merge(*box);
        }
    }
    if (!everywhere.IsInit()) return "nor anywhere else";
    return fmt::format("its {} lie between {:.4f},{:.4f} and {:.4f},{:.4f} (LON,LAT)",
                       choice.obstacles.empty() ? "buildings" : "obstacles of that kind", everywhere.MinX,
                       everywhere.MinY, everywhere.MaxX, everywhere.MaxY);
}

// Appends what one scan finds; false if the source has no layer of that kind.
bool read(Kind kind, const std::string& source, const Window& window, const ObstacleChoice& choice, double line_width,
          Footprints& result) {
    const GDALDatasetUniquePtr file = open_source(source);
    const std::vector<OGRLayer*> layers = layers_of(*file, kind);
    for (OGRLayer* layer : layers) {
        const OGRSpatialReference& system = system_of(*layer, source);
        const OGREnvelope bounds = bounds_in(system, window, source);
        for (Footprint& footprint : placed(scan(*layer, kind, choice, bounds, source), system, window, line_width)) {
            result.list.push_back(std::move(footprint));
        }
        result.from_osm = result.from_osm || FeatureTags(*layer).from_osm();
    }
    return !layers.empty();
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

Footprints read_footprints(const std::string& source, const Window& window, const ObstacleChoice& choice, double cell) {
    std::vector<Kind> kinds{Kind::areas};
    if (choice.wants_lines()) kinds.push_back(Kind::lines);
    Footprints result;
    bool any = false;
    for (const Kind kind : kinds) {
        any = read(kind, source, window, choice, std::max(choice.wall_width, cell), result) || any;
    }
    if (!any) throw refusal(source, "has no polygons; buildings are expected as polygons");
    if (result.list.empty()) {
        throw refusal(source, fmt::format("has no {} in the window; {}",
                                          choice.obstacles.empty() ? "building" : "obstacle of that kind",
                                          whereabouts(kinds, choice, source)));
    }
    return result;
}

}  // namespace waybreaker::geo

#include "city/footprints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "city/feature_tags.hpp"
#include "city/filter_use.hpp"
#include "city/ground_rules.hpp"
#include "city/premises.hpp"
#include "city/vector_source.hpp"
#include "core/in_quotes.hpp"
#include "geotiff/gdal_scope.hpp"
#include "geotiff/obstacle_names.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {
namespace {

constexpr auto no_polygons = "has no polygons; buildings are expected as polygons";

// What a layer is read for.
enum class Shapes { areas, lines };

bool is_of(Shapes kind, OGRwkbGeometryType type) {
    return kind == Shapes::areas ? is_area(type) : is_line(type);
}

std::string names_of(const std::vector<OGRLayer*>& layers) {
    constexpr std::size_t most = 12;
    std::string names;
    for (std::size_t i = 0; i < std::min(layers.size(), most); ++i) {
        names += fmt::format("{}{}", i == 0 ? "" : ", ", layers[i]->GetName());
    }
    return names + (layers.size() > most ? ", ..." : "");
}

// In a source of several layers, such as a folder of shapefiles, those that know what a building is hold the buildings;
// else the user has to say which.
void choose_buildings(std::vector<OGRLayer*>& layers, const std::string& source) {
    if (layers.size() < 2) return;
    const auto knows = [](OGRLayer* layer) { return FeatureTags(*layer).can_have("building"); };
    if (std::any_of(layers.begin(), layers.end(), knows)) {
        std::erase_if(layers, [&](OGRLayer* layer) { return !knows(layer); });
        return;
    }
    throw refusal(source,
                  fmt::format("has {} layers of areas ({}) and none says what is a building; name one by --layer",
                              layers.size(), names_of(layers)));
}

// The layer of that name alone.
void choose_layer(std::vector<OGRLayer*>& layers, const std::string& name, const std::string& source) {
    const std::vector<OGRLayer*> all = layers;
    std::erase_if(layers, [&](OGRLayer* layer) { return layer->GetName() != name; });
    if (!layers.empty()) return;
    throw refusal(source, fmt::format("has no layer {}; it has {}", in_quotes(name), names_of(all)));
}

std::vector<OGRLayer*> layers_of(GDALDataset& file, Shapes kind, const ObstacleChoice& choice,
                                 const std::string& source) {
    std::vector<OGRLayer*> layers(file.GetLayers().begin(), file.GetLayers().end());
    if (!choice.layer.empty()) choose_layer(layers, choice.layer, source);
    std::erase_if(layers, [&](OGRLayer* layer) {
        const OGRwkbGeometryType type = layer->GetGeomType();
        return !is_of(kind, type) && wkbFlatten(type) != wkbUnknown;
    });
    // The OSM driver sorts a file's objects into five layers at once and would buffer those that are not read. Other
    // lines than those of its layer `lines` come in layers of relations.
    if (EQUAL(file.GetDriverName(), "OSM")) {
        const char* const name = kind == Shapes::areas ? "multipolygons" : "lines";
        std::erase_if(layers, [&](OGRLayer* layer) { return !EQUAL(layer->GetName(), name); });
        const std::string only = std::string("SET interest_layers = ") + name;
        file.ReleaseResultSet(file.ExecuteSQL(only.c_str(), nullptr, nullptr));
    }
    if (choice.obstacles.empty()) choose_buildings(layers, source);
    return layers;
}

const std::vector<TagFilter>& buildings() {
    static const std::vector<TagFilter> filters{{.key = "building"}};
    return filters;
}

// Whether all coordinates of a shape are numbers.
class AllNumbers : public OGRDefaultConstGeometryVisitor {
  public:
    static bool in(const OGRGeometry& shape) {
        AllNumbers numbers;
        shape.accept(&numbers);
        return numbers.all_;
    }
    using OGRDefaultConstGeometryVisitor::visit;
    void visit(const OGRPoint* point) override {
        all_ = all_ && std::isfinite(point->getX()) && std::isfinite(point->getY());
    }

  private:
    bool all_ = true;
};

// Which features of a layer are obstacles. By default buildings; in a layer that knows no such tag everything is one.
class Selection {
  public:
    Selection(const FeatureTags& tags, const ObstacleChoice& choice, Shapes kind)
        : tags_(tags),
          kind_(kind),
          filters_(choice.obstacles.empty() ? buildings() : choice.obstacles),
          only_in_the_way_(choice.only_in_the_way && choice.obstacles.empty()) {
        all_ = choice.obstacles.empty() && !tags.can_have("building");
        // A building that is a line is an unclosed outline.
        if (kind == Shapes::lines)
            std::erase_if(filters_, [](const TagFilter& filter) { return filter.key == "building"; });
    }

    std::string condition() const { return all_ ? "" : tags_.condition(filters_); }

    bool takes(const OGRFeature& feature) const {
        const OGRGeometry* shape = feature.GetGeometryRef();
        return shape && is_of(kind_, shape->getGeometryType()) && wants(feature);
    }

    // Whether it would be one, had it coordinates that are numbers. Without any it is no line: it would count twice.
    bool misses(const OGRFeature& feature) const {
        const OGRGeometry* shape = feature.GetGeometryRef();
        if (!shape || shape->IsEmpty()) return kind_ == Shapes::areas && wants(feature);
        return is_of(kind_, shape->getGeometryType()) && !AllNumbers::in(*shape) && wants(feature);
    }

  private:
    bool wants(const OGRFeature& feature) const {
        if (all_) return true;
        return tags_.matches_any(feature, filters_) && (!only_in_the_way_ || stands_in_the_way(tags_.all(feature)));
    }

    const FeatureTags& tags_;
    Shapes kind_;
    std::vector<TagFilter> filters_;
    bool all_;
    bool only_in_the_way_;
};

// Calls visit(feature, tags) for the obstacles of a layer; gives the number of those without a shape.
template <typename Visit>
std::size_t for_each_obstacle(OGRLayer& layer, Shapes kind, const ObstacleChoice& choice, const std::string& source,
                              Visit visit) {
    const geotiff::GdalScope gdal;
    const FeatureTags tags(layer);
    const Selection selection(tags, choice, kind);
    // Not only for speed: GDAL's OSM driver takes the outer way of any relation for a part of that relation, so that a
    // building whose outline also bounds, say, its lowest storey (the Empire State Building) is lost; unless the
    // relation itself does not pass this filter.
    const std::string condition = selection.condition();
    layer.SetAttributeFilter(condition.empty() ? nullptr : condition.c_str());
    std::size_t shapeless = 0;
    for (const OGRFeatureUniquePtr& feature : layer) {
        if (selection.misses(*feature)) {
            ++shapeless;
        } else if (selection.takes(*feature)) {
            visit(*feature, tags);
        }
    }
    require_read(gdal, source);
    return shapeless;
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

// Its name, else its address.
std::string name_of(const OGRFeature& feature, const FeatureTags& tags) {
    for (const char* key : {"name", "addr:housename"}) {
        if (const std::optional<std::string> text = tags.value(feature, key)) {
            std::string name = geotiff::clean_name(*text);
            if (!name.empty()) return name;
        }
    }
    const std::optional<std::string> street = tags.value(feature, "addr:street");
    const std::optional<std::string> number = tags.value(feature, "addr:housenumber");
    return street && number ? geotiff::clean_name(*street + " " + *number) : "";
}

// Whether GDAL finds what lies in a box without reading the rest. It passes over what has no coordinates, which only
// matters where OpenStreetMap's nodes do not see to them.
bool finds_places(OGRLayer& layer, GDALDataset& file) {
    return EQUAL(file.GetDriverName(), "OSM") || layer.TestCapability(OLCFastSpatialFilter);
}

// The obstacles of a layer whose bounding boxes meet `bounds`, in the layer's own coordinates, not measured yet.
std::vector<Footprint> scan(OGRLayer& layer, Shapes kind, const ObstacleChoice& choice, const OGREnvelope& bounds,
                            const std::string& source, FilterUse& use, bool filtered, std::size_t& shapeless) {
    std::vector<Footprint> found;
    if (filtered) layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
    shapeless += for_each_obstacle(layer, kind, choice, source, [&](OGRFeature& feature, const FeatureTags& tags) {
        OGREnvelope box;
        feature.GetGeometryRef()->getEnvelope(&box);
        if (!bounds.Intersects(box)) return;
        use.see(feature, tags);
        Footprint& footprint = found.emplace_back();
        footprint.attributes = attributes_of(feature, tags, choice);
        footprint.name = name_of(feature, tags);
        footprint.kind = choice.obstacles.empty() ? site::ObstacleKind::building : site::ObstacleKind::unknown;
        footprint.tags = tags.kept(feature);
        footprint.sheltered = tags.matches_any(feature, choice.shelter);
        if (footprint.sheltered) footprint.attributes.destructible = false;
        footprint.shape.reset(feature.StealGeometry());
    });
    return found;
}

// Moves footprints into the window's system, makes strips of lines, measures all and drops those outside; also what
// cannot be projected, which reaches too far around the globe to be an obstacle.
std::vector<Footprint> placed(std::vector<Footprint> footprints, const OGRSpatialReference& system,
                              const Window& window, double line_width) {
    const geotiff::GdalScope gdal;
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

// For error messages, if the window contains none of them.
std::string whereabouts(const std::vector<Shapes>& kinds, const ObstacleChoice& choice, const std::string& source) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    OGREnvelope everywhere;
    for (const Shapes kind : kinds) {
        const GDALDatasetUniquePtr file = open_source(source);
        for (OGRLayer* layer : layers_of(*file, kind, choice, source)) {
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
    require_degrees(everywhere, source);
    return fmt::format("its {} lie between {:.4f},{:.4f} and {:.4f},{:.4f} (LON,LAT)",
                       choice.obstacles.empty() ? "buildings" : "obstacles of that kind", everywhere.MinX,
                       everywhere.MinY, everywhere.MaxX, everywhere.MaxY);
}

// Grounds say for their buildings what these need not say.
void see_premises(const std::string& source, const ObstacleChoice& choice, FilterUse& use) {
    const GDALDatasetUniquePtr file = open_source(source);
    const geotiff::GdalScope gdal;
    if (EQUAL(file->GetDriverName(), "OSM")) {
        file->ReleaseResultSet(file->ExecuteSQL("SET interest_layers = points,multipolygons", nullptr, nullptr));
    }
    const std::vector<TagFilter> filters = premises_filters(choice);
    for (const GDALDataset::FeatureLayerPair& read : file->GetFeatures()) {
        const OGRGeometry* geometry = read.feature->GetGeometryRef();
        const auto shape = geometry ? shape_of(geometry->getGeometryType()) : std::nullopt;
        const auto premises =
            shape ? premises_of(FeatureTags(*read.layer).all(*read.feature), *shape, filters) : std::nullopt;
        if (premises) use.see(*premises);
    }
    require_read(gdal, source);
}

// A filter without a match in the window may have one elsewhere: searches the whole source.
void require_matches(const std::vector<Shapes>& kinds, const ObstacleChoice& choice, const std::string& source,
                     FilterUse& use) {
    for (const Shapes kind : kinds) {
        if (use.all_used()) return;
        const GDALDatasetUniquePtr file = open_source(source);
        for (OGRLayer* layer : layers_of(*file, kind, choice, source)) {
            for_each_obstacle(*layer, kind, choice, source,
                              [&](const OGRFeature& feature, const FeatureTags& tags) { use.see(feature, tags); });
        }
    }
    if (!choice.premises.empty() && !use.all_used()) see_premises(source, choice, use);
    use.require_all(source);
}

// The part of the world that the source has data of, as far as it says so without being read.
OGREnvelope extent_of(GDALDataset& file, const OGRSpatialReference& target) {
    const geotiff::GdalScope gdal;
    const bool osm = EQUAL(file.GetDriverName(), "OSM");
    OGREnvelope all;
    for (OGRLayer* layer : file.GetLayers()) {
        OGREnvelope extent;
        const OGRSpatialReference* system = layer->GetSpatialRef();
        if (!system || layer->GetExtent(&extent, osm ? FALSE : TRUE) != OGRERR_NONE) continue;
        if (const auto box = transformed(extent, *system, target)) all.Merge(*box);
    }
    return all;
}

// Appends what one scan finds; false if the source has no layer of that kind.
bool read(Shapes kind, const std::string& source, const Window& window, const ObstacleChoice& choice, double line_width,
          FilterUse& use, Footprints& result) {
    const GDALDatasetUniquePtr file = open_source(source);
    const std::vector<OGRLayer*> layers = layers_of(*file, kind, choice, source);
    result.extent.Merge(extent_of(*file, window.system));
    for (OGRLayer* layer : layers) {
        const OGRSpatialReference& system = system_of(*layer, source);
        const OGREnvelope bounds = bounds_in(system, window, source);
        for (Footprint& footprint :
             placed(scan(*layer, kind, choice, bounds, source, use, finds_places(*layer, *file), result.shapeless),
                    system, window, line_width)) {
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

OGREnvelope visit_buildings(const std::string& source, const std::function<void(const OGRGeometry& outline)>& visit) {
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    const ObstacleChoice choice{.only_in_the_way = true};
    const GDALDatasetUniquePtr file = open_source(source);
    const std::vector<OGRLayer*> layers = layers_of(*file, Shapes::areas, choice, source);
    if (layers.empty()) throw refusal(source, no_polygons);
    for (OGRLayer* layer : layers) {
        const Transformation to_degrees = transformation(system_of(*layer, source), degrees);
        for_each_obstacle(*layer, Shapes::areas, choice, source, [&](OGRFeature& feature, const FeatureTags&) {
            const geotiff::GdalScope gdal;  // what cannot be transformed is left out, as an import does
            if (feature.GetGeometryRef()->transform(to_degrees.get()) == OGRERR_NONE) visit(*feature.GetGeometryRef());
        });
    }
    return extent_of(*file, degrees);
}

Footprints read_footprints(const std::string& source, const Window& window, const ObstacleChoice& choice, double cell) {
    std::vector<Shapes> kinds{Shapes::areas};
    if (choice.wants_lines()) kinds.push_back(Shapes::lines);
    Footprints result;
    FilterUse use(choice);
    bool any = false;
    for (const Shapes kind : kinds) {
        any = read(kind, source, window, choice, std::max(choice.wall_width, cell), use, result) || any;
    }
    if (!any) throw refusal(source, no_polygons);
    require_matches(kinds, choice, source, use);
    if (result.list.empty()) {
        throw refusal(source, fmt::format("has no {} in the window; {}",
                                          choice.obstacles.empty() ? "building" : "obstacle of that kind",
                                          whereabouts(kinds, choice, source)));
    }
    return result;
}

}  // namespace waybreaker::city

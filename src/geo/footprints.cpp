#include "geo/footprints.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <optional>

#include "geo/feature_tags.hpp"
#include "geo/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

InputError refusal(const std::string& source, const std::string& message) {
    return InputError(source + ": " + message);
}

// GDAL finds out about compressed files by the prefix of their path only.
std::string gdal_path(const std::string& source) {
    std::array<unsigned char, 2> magic{};
    if (VSILFILE* file = VSIFOpenL(source.c_str(), "rb")) {
        VSIFReadL(magic.data(), 1, magic.size(), file);
        VSIFCloseL(file);
    }
    const bool gzip = magic == std::array<unsigned char, 2>{0x1f, 0x8b};
    return gzip ? "/vsigzip/" + source : source;
}

GDALDatasetUniquePtr open_source(const std::string& source) {
    const GdalScope gdal;
    GDALAllRegister();
    GDALDatasetUniquePtr file(GDALDataset::Open(gdal_path(source).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    if (file) return file;
    VSIStatBufL status;
    if (VSIStatL(source.c_str(), &status) != 0) throw refusal(source, "no such file");
    throw refusal(source, "cannot be read as map data (.osm.pbf, .osm, .osm.gz, shapefile, GeoJSON, ...)" +
                              (gdal.failed() ? ": " + gdal.failure() : std::string()));
}

bool is_area(OGRwkbGeometryType type) {
    return OGR_GT_IsSubClassOf(type, wkbCurvePolygon) || OGR_GT_IsSubClassOf(type, wkbMultiSurface);
}

bool is_line(OGRwkbGeometryType type) {
    return OGR_GT_IsSubClassOf(type, wkbCurve) || OGR_GT_IsSubClassOf(type, wkbMultiCurve);
}

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

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

// Between coordinates in (east, north) order, whatever order the system's authority prefers.
Transformation transformation(OGRSpatialReference from, OGRSpatialReference to) {
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

// The smallest box that holds the transformed one; the whole breadth of the world if it crosses the date line.
std::optional<OGREnvelope> transformed(const OGREnvelope& box, const OGRSpatialReference& from,
                                       const OGRSpatialReference& to) {
    const GdalScope gdal;
    const Transformation forth = transformation(from, to);
    OGREnvelope result;
    if (!forth || !forth->TransformBounds(box.MinX, box.MinY, box.MaxX, box.MaxY, &result.MinX, &result.MinY,
                                          &result.MaxX, &result.MaxY, 21)) {
        return std::nullopt;
    }
    if (result.MinX > result.MaxX) {
        result.MinX = -180;
        result.MaxX = 180;
    }
    return result;
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

// The obstacles of a layer whose bounding boxes meet `bounds`, in the layer's own coordinates, not measured yet.
std::vector<Footprint> scan(OGRLayer& layer, Kind kind, const ObstacleChoice& choice, const OGREnvelope& bounds,
                            const std::string& source) {
    std::vector<Footprint> found;
    layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
    for_each_obstacle(layer, kind, choice, source, [&](OGRFeature& feature, const FeatureTags& tags) {
        Footprint& footprint = found.emplace_back();
        footprint.attributes = attributes_of(feature, tags, choice);
        footprint.shape.reset(feature.StealGeometry());
    });
    return found;
}

OGRPolygon rectangle(const OGREnvelope& bounds) {
    OGRLinearRing ring;
    ring.addPoint(bounds.MinX, bounds.MinY);
    ring.addPoint(bounds.MaxX, bounds.MinY);
    ring.addPoint(bounds.MaxX, bounds.MaxY);
    ring.addPoint(bounds.MinX, bounds.MaxY);
    ring.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&ring);
    return polygon;
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

const OGRSpatialReference& system_of(OGRLayer& layer, const std::string& source) {
    if (const OGRSpatialReference* system = layer.GetSpatialRef()) return *system;
    throw refusal(source,
                  "does not say its coordinate system; name it with 'ogr2ogr -a_srs EPSG:4326' (or what it is)");
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
        const auto bounds = transformed(window.bounds, window.system, system);
        if (!bounds) {
            throw refusal(source,
                          "its coordinate system cannot be reached from " + std::string(window.system.GetName()));
        }
        for (Footprint& footprint : placed(scan(*layer, kind, choice, *bounds, source), system, window, line_width)) {
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

#include "geo/buildings.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <optional>
#include <string_view>

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

std::vector<OGRLayer*> layers_with_areas(GDALDataset& file, const std::string& source) {
    std::vector<OGRLayer*> layers;
    for (OGRLayer* layer : file.GetLayers()) {
        const OGRwkbGeometryType type = layer->GetGeomType();
        if (is_area(type) || wkbFlatten(type) == wkbUnknown) layers.push_back(layer);
    }
    if (layers.empty()) throw refusal(source, "has no polygons; buildings are expected as polygons");
    // The OSM driver sorts a file's objects into five layers at once and would hoard those nobody reads.
    if (EQUAL(file.GetDriverName(), "OSM")) {
        file.ReleaseResultSet(file.ExecuteSQL("SET interest_layers = multipolygons", nullptr, nullptr));
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

// Which attributes of a layer speak of buildings; -1 where it has none such.
class Attributes {
  public:
    explicit Attributes(OGRLayer& layer)
        : building_(layer.GetLayerDefn()->GetFieldIndex("building")),
          way_(layer.GetLayerDefn()->GetFieldIndex("osm_way_id")),
          osm_(layer.GetLayerDefn()->GetFieldIndex("osm_id")) {}

    bool say_building() const { return building_ >= 0; }
    bool from_osm() const { return way_ >= 0 || osm_ >= 0; }

    bool is_building(const OGRFeature& feature) const {
        if (building_ < 0) return true;
        return feature.IsFieldSetAndNotNull(building_) && std::string_view(feature.GetFieldAsString(building_)) != "no";
    }

    // GDAL's OSM driver gives ways and relations a field each; elsewhere osm_id is what it is.
    std::int64_t source_id(const OGRFeature& feature) const {
        if (way_ >= 0 && feature.IsFieldSetAndNotNull(way_)) return feature.GetFieldAsInteger64(way_);
        if (osm_ < 0 || !feature.IsFieldSetAndNotNull(osm_)) return 0;
        const std::int64_t id = feature.GetFieldAsInteger64(osm_);
        return way_ >= 0 ? -id : id;
    }

  private:
    int building_;
    int way_;
    int osm_;
};

// Calls visit(feature) for the buildings of a layer.
template <typename Visit>
void for_each_building(OGRLayer& layer, const std::string& source, Visit visit) {
    const GdalScope gdal;
    const Attributes attributes(layer);
    // Not for speed alone: GDAL's OSM driver takes the outer way of any relation for a part of that relation, so that a
    // building whose outline also bounds, say, its lowest storey (the Empire State Building) is lost; unless the
    // relation itself does not pass this filter.
    if (attributes.say_building()) layer.SetAttributeFilter("building IS NOT NULL");
    for (const OGRFeatureUniquePtr& feature : layer) {
        const OGRGeometry* shape = feature->GetGeometryRef();
        if (shape && is_area(shape->getGeometryType()) && attributes.is_building(*feature)) visit(*feature);
    }
    if (gdal.failed()) throw refusal(source, "is damaged or cut short: " + gdal.failure());
}

// The buildings of a layer whose bounding boxes meet `bounds`, in the layer's own coordinates, not measured yet.
std::vector<Building> scan(OGRLayer& layer, const OGREnvelope& bounds, const std::string& source) {
    const Attributes attributes(layer);
    std::vector<Building> buildings;
    layer.SetSpatialFilterRect(bounds.MinX, bounds.MinY, bounds.MaxX, bounds.MaxY);
    for_each_building(layer, source, [&](OGRFeature& feature) {
        Building& building = buildings.emplace_back();
        building.shape.reset(feature.StealGeometry());
        building.source_id = attributes.source_id(feature);
    });
    return buildings;
}

double area_inside(const OGRGeometry& shape, const OGRPolygon& window, const OGREnvelope& bounds) {
    const auto area = [](const OGRGeometry& g) {
        return OGR_G_Area(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(&g)));
    };
    OGREnvelope box;
    shape.getEnvelope(&box);
    if (bounds.Contains(box)) return area(shape);
    if (!bounds.Intersects(box)) return 0;
    const std::unique_ptr<OGRGeometry> valid(shape.MakeValid());
    const std::unique_ptr<OGRGeometry> part(valid ? valid->Intersection(&window) : nullptr);
    return part ? area(*part) : 0;
}

// Moves the buildings into the window's system, measures them and drops those outside; also what cannot be projected,
// which reaches too far around the globe to be a building.
std::vector<Building> placed(std::vector<Building> buildings, const OGRSpatialReference& system, const Window& window) {
    const GdalScope gdal;
    const Transformation to_window = transformation(system, window.system);
    const OGREnvelope& bounds = window.bounds;
    OGRLinearRing ring;
    ring.addPoint(bounds.MinX, bounds.MinY);
    ring.addPoint(bounds.MaxX, bounds.MinY);
    ring.addPoint(bounds.MaxX, bounds.MaxY);
    ring.addPoint(bounds.MinX, bounds.MaxY);
    ring.closeRings();
    OGRPolygon square;
    square.addRing(&ring);
    std::erase_if(buildings, [&](Building& building) {
        if (building.shape->transform(to_window.get()) != OGRERR_NONE) return true;
        building.shape.reset(building.shape->getLinearGeometry());
        building.area = building.shape ? area_inside(*building.shape, square, bounds) : 0;
        return !(building.area > 0);
    });
    return buildings;
}

const OGRSpatialReference& system_of(OGRLayer& layer, const std::string& source) {
    if (const OGRSpatialReference* system = layer.GetSpatialRef()) return *system;
    throw refusal(source,
                  "does not say its coordinate system; name it with 'ogr2ogr -a_srs EPSG:4326' (or what it is)");
}

// For somebody whose window missed them all.
std::string whereabouts(const std::vector<OGRLayer*>& layers, const std::string& source) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    OGREnvelope everywhere;
    for (OGRLayer* layer : layers) {
        OGREnvelope extent;
        layer->SetSpatialFilter(nullptr);
        for_each_building(*layer, source, [&](const OGRFeature& feature) {
            OGREnvelope box;
            feature.GetGeometryRef()->getEnvelope(&box);
            extent.Merge(box);
        });
        if (!extent.IsInit()) continue;
        if (const auto box = transformed(extent, *layer->GetSpatialRef(), wgs84)) everywhere.Merge(*box);
    }
    if (!everywhere.IsInit()) return "nor anywhere else";
    return fmt::format("its buildings lie between {:.4f},{:.4f} and {:.4f},{:.4f} (LON,LAT)", everywhere.MinX,
                       everywhere.MinY, everywhere.MaxX, everywhere.MaxY);
}

}  // namespace

Buildings read_buildings(const std::string& source, const Window& window) {
    const GDALDatasetUniquePtr file = open_source(source);
    const std::vector<OGRLayer*> layers = layers_with_areas(*file, source);
    Buildings result;
    for (OGRLayer* layer : layers) {
        const OGRSpatialReference& system = system_of(*layer, source);
        const auto bounds = transformed(window.bounds, window.system, system);
        if (!bounds)
            throw refusal(source,
                          "its coordinate system cannot be reached from " + std::string(window.system.GetName()));
        for (Building& building : placed(scan(*layer, *bounds, source), system, window)) {
            result.buildings.push_back(std::move(building));
        }
        result.from_osm = result.from_osm || Attributes(*layer).from_osm();
    }
    if (result.buildings.empty())
        throw refusal(source, "has no building in the window; " + whereabouts(layers, source));
    return result;
}

}  // namespace waybreaker::geo

#include "geo/vector_source.hpp"

#include <array>

#include "geo/gdal_scope.hpp"

namespace waybreaker::geo {
namespace {

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

}  // namespace

InputError refusal(const std::string& source, const std::string& message) {
    return InputError(source + ": " + message);
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

Transformation transformation(OGRSpatialReference from, OGRSpatialReference to) {
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

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

OGREnvelope bounds_in(const OGRSpatialReference& system, const Window& window, const std::string& source) {
    if (const auto bounds = transformed(window.bounds, window.system, system)) return *bounds;
    throw refusal(source, "its coordinate system cannot be reached from " + std::string(window.system.GetName()));
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

const OGRSpatialReference& system_of(OGRLayer& layer, const std::string& source) {
    if (const OGRSpatialReference* system = layer.GetSpatialRef()) return *system;
    throw refusal(source,
                  "does not say its coordinate system; name it with 'ogr2ogr -a_srs EPSG:4326' (or what it is)");
}

}  // namespace waybreaker::geo

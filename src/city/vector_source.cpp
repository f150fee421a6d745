#include "city/vector_source.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "city/sent_source.hpp"
#include "geotiff/file_kind.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

// The first bytes of what GDAL has under a path.
std::string first_bytes(const std::string& path, std::size_t bytes) {
    std::string head(bytes, '\0');
    std::size_t length = 0;
    if (VSILFILE* file = VSIFOpenL(path.c_str(), "rb")) {
        length = VSIFReadL(head.data(), 1, head.size(), file);
        VSIFCloseL(file);
    }
    head.resize(length);
    return head;
}

// As GDAL reads it, which finds out about compressed files by the prefix of their path only.
std::string unpacked(const std::string& source) {
    return is_gzip(source) ? "/vsigzip/" + source : source;
}

std::optional<geotiff::FileKind> kind_of(const std::string& source) {
    constexpr std::size_t enough = std::size_t{1} << 16;
    return geotiff::file_kind(head_of(source, enough));
}

// What GDAL says that tells its users nothing, in words.
std::string in_words(const std::string& failure) {
    return failure.find("cpl_vsil_gzip") == std::string::npos ? failure : "its gzip data ends too early";
}

// What GDAL did not read.
InputError unreadable(const std::string& source, const geotiff::GdalScope& gdal) {
    using enum geotiff::FileKind::Reader;
    const std::optional<geotiff::FileKind> kind = kind_of(source);
    if (kind && kind->reader == map) {
        return refusal(source, "is " + kind->what +
                                   ", not map data with outlines: if it shows which cells are blocked, "
                                   "it is a map as it is");
    }
    if (kind && kind->reader == perhaps_import) return refusal(source, geotiff::description(*kind));
    const char* const formats = SentSource::is_path(source) ? ".osm.pbf, .osm, .osm.gz, GeoJSON"
                                                            : ".osm.pbf, .osm, .osm.gz, shapefile, GeoJSON, ...";
    return refusal(source, fmt::format("cannot be read as map data ({}){}", formats,
                                       gdal.failed() ? ": " + in_words(gdal.failure()) : std::string()));
}

}  // namespace

InputError refusal(const std::string& source, const std::string& message) {
    return InputError(source + ": " + message);
}

std::string head_of(const std::string& source, std::size_t bytes) {
    const geotiff::GdalScope gdal;
    return first_bytes(unpacked(source), bytes);
}

bool is_gzip(const std::string& source) {
    return first_bytes(source, 2) == "\x1f\x8b";
}

bool ends_early(const std::string& source) {
    if (!is_gzip(source)) return false;
    const geotiff::GdalScope gdal;
    VSILFILE* const file = VSIFOpenL(("/vsigzip/" + source).c_str(), "rb");
    if (file == nullptr) return true;
    std::string piece(std::size_t{1} << 16, '\0');
    while (VSIFReadL(piece.data(), 1, piece.size(), file) > 0) {
    }
    VSIFCloseL(file);
    return gdal.failed();
}

GDALDatasetUniquePtr open_source(const std::string& source) {
    VSIStatBufL status;
    if (VSIStatL(source.c_str(), &status) != 0) throw refusal(source, "no such file");
    const bool folder = VSI_ISDIR(status.st_mode);
    if (!folder) {
        const std::optional<geotiff::FileKind> kind = kind_of(source);
        if (kind && kind->reader == geotiff::FileKind::Reader::neither)
            throw refusal(source, geotiff::description(*kind));
    }
    const geotiff::GdalScope gdal;
    GDALAllRegister();
    const bool sent = SentSource::is_path(source);
    // Others open files and addresses that their data names.
    constexpr std::array<const char*, 2> harmless{"GeoJSON", nullptr};
    GDALDatasetUniquePtr file(GDALDataset::Open(unpacked(source).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                sent ? harmless.data() : nullptr));
    if (file) return file;
    if (folder) throw refusal(source, "is a folder that is no map data as a whole; name one of its files");
    throw unreadable(source, gdal);
}

void require_read(const geotiff::GdalScope& gdal, const std::string& source) {
    if (gdal.failed()) throw refusal(source, "is damaged or cut short: " + in_words(gdal.failure()));
}

bool is_area(OGRwkbGeometryType type) {
    return OGR_GT_IsSubClassOf(type, wkbCurvePolygon) || OGR_GT_IsSubClassOf(type, wkbMultiSurface);
}

bool is_line(OGRwkbGeometryType type) {
    return OGR_GT_IsSubClassOf(type, wkbCurve) || OGR_GT_IsSubClassOf(type, wkbMultiCurve);
}

std::optional<site::Background::Shape> shape_of(OGRwkbGeometryType type) {
    using enum site::Background::Shape;
    if (is_area(type)) return area;
    if (is_line(type)) return line;
    return wkbFlatten(type) == wkbPoint ? std::optional(point) : std::nullopt;
}

Transformation transformation(OGRSpatialReference from, OGRSpatialReference to) {
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

std::optional<OGREnvelope> transformed(const OGREnvelope& box, const OGRSpatialReference& from,
                                       const OGRSpatialReference& to) {
    const geotiff::GdalScope gdal;
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

void require_degrees(const OGREnvelope& box, const std::string& source) {
    const bool on_globe = box.MinX >= -360 && box.MaxX <= 360 && box.MinY >= -90 && box.MaxY <= 90;
    if (on_globe) return;
    throw refusal(source, fmt::format("its coordinates are not longitude and latitude ({:.7g}, {:.7g}), as GeoJSON has "
                                      "them; convert them with 'ogr2ogr -s_srs EPSG:25833 -t_srs EPSG:4326 "
                                      "degrees.geojson FILE', where EPSG:25833 is the system they are in",
                                      box.MinX, box.MinY));
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

std::unique_ptr<OGRGeometry> outline_of(const OGREnvelope& box, const OGRSpatialReference& from,
                                        const OGRSpatialReference& to) {
    constexpr double parts = 20;  // of a side
    std::unique_ptr<OGRGeometry> outline(rectangle(box).clone());
    outline->segmentize(std::max(box.MaxX - box.MinX, box.MaxY - box.MinY) / parts);
    const Transformation forth = transformation(from, to);
    if (!forth || outline->transform(forth.get()) != OGRERR_NONE) return nullptr;
    return outline;
}

}  // namespace waybreaker::city

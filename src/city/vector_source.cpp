#include "city/vector_source.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "city/sent_source.hpp"
#include "geotiff/file_kind.hpp"
#include "geotiff/gdal_scope.hpp"
#include "geotiff/xml_root.hpp"

namespace waybreaker::city {
namespace {

constexpr const char* index_option = "OSM_USE_CUSTOM_INDEXING";

// The first bytes of a file, decompressed if the path says so.
std::string head_of(const std::string& path, std::size_t bytes) {
    std::string head(bytes, '\0');
    std::size_t length = 0;
    if (VSILFILE* file = VSIFOpenL(path.c_str(), "rb")) {
        length = VSIFReadL(head.data(), 1, head.size(), file);
        VSIFCloseL(file);
    }
    head.resize(length);
    return head;
}

bool is_gzip(const std::string& source) {
    return head_of(source, 2) == "\x1f\x8b";
}

// As GDAL reads it, which finds out about compressed files by the prefix of their path only.
std::string unpacked(const std::string& source) {
    return is_gzip(source) ? "/vsigzip/" + source : source;
}

// GDAL finds out about OpenStreetMap's XML only if its root is in the first kilobyte.
std::string gdal_path(const std::string& source) {
    constexpr std::size_t longest_prologue = std::size_t{1} << 20;
    constexpr std::size_t seen_by_gdal = 1000;
    const geotiff::GdalScope gdal;
    const std::string path = unpacked(source);
    const std::string head = head_of(path, longest_prologue);
    const std::optional<geotiff::XmlRoot> root = geotiff::xml_root(head);
    return root && root->name == "osm" && root->at > seen_by_gdal
               ? "/vsisubfile/" + std::to_string(root->at) + "," + path
               : path;
}

std::optional<geotiff::FileKind> kind_of(const std::string& source) {
    constexpr std::size_t enough = std::size_t{1} << 16;
    const geotiff::GdalScope gdal;
    return geotiff::file_kind(head_of(unpacked(source), enough));
}

// What GDAL says that tells its users nothing, in words.
std::string in_words(const std::string& failure) {
    const auto says = [&failure](std::string_view part) { return failure.find(part) != std::string::npos; };
    if (says("cpl_vsil_gzip")) return "its gzip data ends too early";
    if (says("UNIQUE constraint failed")) {
        return "it holds objects twice, as several queries of Overpass in one do; ask for each once: '(._;>;); out;'";
    }
    return failure;
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
    constexpr std::array<const char*, 3> harmless{"OSM", "GeoJSON", nullptr};
    GDALDatasetUniquePtr file(GDALDataset::Open(gdal_path(source).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                sent ? harmless.data() : nullptr));
    if (file) return file;
    if (folder) throw refusal(source, "is a folder that is no map data as a whole; name one of its files");
    throw unreadable(source, gdal);
}

AnyOrderOfNodes::AnyOrderOfNodes() {
    if (const char* former = CPLGetThreadLocalConfigOption(index_option, nullptr)) former_ = former;
    CPLSetThreadLocalConfigOption(index_option, "NO");
}

AnyOrderOfNodes::~AnyOrderOfNodes() {
    CPLSetThreadLocalConfigOption(index_option, former_ ? former_->c_str() : nullptr);
}

void require_read(const geotiff::GdalScope& gdal, const std::string& source) {
    if (!gdal.failed()) return;
    const std::string failure = gdal.failure();
    const std::string message = source + ": is damaged or cut short: " + in_words(failure);
    if (failure.find(index_option) != std::string::npos) throw NodesOutOfOrder(message);
    throw InputError(message);
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

}  // namespace waybreaker::city

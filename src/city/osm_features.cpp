#include "city/osm_features.hpp"

#include <cpl_vsi.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

#include "city/vector_source.hpp"
#include "geotiff/file_kind.hpp"
#include "geotiff/gdal_scope.hpp"

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;

// Of comments before the root of XML.
constexpr std::size_t longest_prologue = std::size_t{1} << 20;

// A file that has no name and is gone with this object.
class NamelessFile {
  public:
    NamelessFile() : descriptor_(memfd_create("osm", MFD_CLOEXEC)) {}
    ~NamelessFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

    bool append(const char* bytes, std::size_t count) const {
        while (count > 0) {
            const ssize_t written = write(descriptor_, bytes, count);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            bytes += written;
            count -= std::size_t(written);
        }
        return true;
    }

  private:
    int descriptor_;
};

// A copy of what GDAL has under a path; null if there is no place for it.
std::shared_ptr<const NamelessFile> copy_of(const std::string& gdal_path) {
    auto copy = std::make_shared<NamelessFile>();
    VSILFILE* const file = VSIFOpenL(gdal_path.c_str(), "rb");
    bool whole = file != nullptr;
    std::string piece(std::size_t{1} << 20, '\0');
    for (std::size_t count = 1; whole && count > 0;) {
        count = VSIFReadL(piece.data(), 1, piece.size(), file);
        whole = copy->append(piece.data(), count);
    }
    if (file != nullptr) VSIFCloseL(file);
    return whole ? copy : nullptr;
}

std::optional<osm::Keys> keys_of(const std::optional<std::vector<TagFilter>>& filters) {
    if (!filters) return std::nullopt;
    osm::Keys keys;
    for (const TagFilter& filter : *filters) {
        if (filter.key == "*") return osm::Keys();
        keys.any_of.push_back(filter.key);
    }
    return keys;
}

OGRLineString string_of(const osm::Line& line) {
    OGRLineString string;
    string.setNumPoints(int(line.size()), FALSE);
    for (std::size_t i = 0; i < line.size(); ++i) string.setPoint(int(i), line[i].longitude, line[i].latitude);
    return string;
}

std::unique_ptr<OGRGeometry> polygon_of(const osm::Polygon& rings) {
    auto polygon = std::make_unique<OGRPolygon>();
    for (const osm::Line& line : rings) {
        auto ring = std::make_unique<OGRLinearRing>();
        const OGRLineString string = string_of(line);
        ring->addSubLineString(&string);
        polygon->addRingDirectly(ring.release());
    }
    return polygon;
}

std::unique_ptr<OGRGeometry> geometry_of(const osm::Feature& feature) {
    if (feature.shape == osm::Shape::point) {
        return std::make_unique<OGRPoint>(feature.line.front().longitude, feature.line.front().latitude);
    }
    if (feature.shape == osm::Shape::line) return std::make_unique<OGRLineString>(string_of(feature.line));
    if (feature.polygons.size() == 1) return polygon_of(feature.polygons.front());
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const osm::Polygon& polygon : feature.polygons) all->addGeometryDirectly(polygon_of(polygon).release());
    return all;
}

Shape shape_of(osm::Shape shape) {
    if (shape == osm::Shape::point) return Shape::point;
    return shape == osm::Shape::line ? Shape::line : Shape::area;
}

OGREnvelope envelope_of(const osm::Box& box) {
    OGREnvelope envelope;
    envelope.Merge(box.west, box.south);
    envelope.Merge(box.east, box.north);
    return envelope;
}

// From degrees into the system of a query.
class Placing {
  public:
    explicit Placing(const OGRSpatialReference& system) {
        degrees_.SetWellKnownGeogCS("WGS84");
        transformation_ = transformation(degrees_, system);
    }

    const OGRSpatialReference& degrees() const { return degrees_; }

    // False if it cannot be projected, as it reaches too far around the globe.
    bool place(OGRGeometry& shape) const {
        const geotiff::GdalScope gdal;
        return shape.transform(transformation_.get()) == OGRERR_NONE;
    }

    std::vector<Line> place(const std::vector<osm::Line>& lines) const {
        std::vector<Line> placed;
        for (const osm::Line& line : lines) {
            OGRLineString string = string_of(line);
            if (!place(string)) continue;
            Line& points = placed.emplace_back();
            for (const OGRPoint& point : string) points.emplace_back(point.getX(), point.getY());
        }
        return placed;
    }

  private:
    OGRSpatialReference degrees_;
    Transformation transformation_;
};

}  // namespace

std::optional<OsmSource> osm_source(const std::string& source) {
    const std::optional<geotiff::OsmFormat> format = geotiff::osm_format(head_of(source, longest_prologue));
    if (!format) return std::nullopt;
    OsmSource found{source, {std::filesystem::absolute(source).string(), std::string(geotiff::name_of(*format))}};
    const bool packed = is_gzip(source);
    // Only text is unpacked while it is read.
    const bool unpack = packed && *format == geotiff::OsmFormat::pbf;
    if (packed && !unpack) found.file.format += ".gz";
    if (unpack || source.starts_with("/vsi")) {
        const std::shared_ptr<const NamelessFile> copy = copy_of(unpack ? "/vsigzip/" + source : source);
        if (!copy) throw refusal(source, "cannot be read, or there is no memory for it");
        found.file.path = copy->path();
        found.kept = copy;
    }
    return found;
}

FeatureReport visit_osm(const OsmSource& source, const FeatureQuery& query, const std::function<void(Feature)>& visit) {
    if (!query.layer.empty()) throw refusal(source.name, "is OpenStreetMap data, which has no layers");
    const Placing placing(query.system);
    osm::Query wanted{keys_of(query.points), keys_of(query.lines), keys_of(query.areas)};
    if (query.bounds) {
        const OGREnvelope box = bounds_in(placing.degrees(), {query.system, *query.bounds}, source.name);
        wanted.box = osm::Box{box.MinX, box.MinY, box.MaxX, box.MaxY};
    }
    FeatureReport report{.from_osm = true, .any_layer = true};
    const osm::Visitor visitor{
        [&](osm::Feature feature) {
            std::unique_ptr<OGRGeometry> geometry = geometry_of(feature);
            if (!placing.place(*geometry)) return;
            visit({shape_of(feature.shape), TagSet(std::move(feature.tags)), feature.source_id, std::move(geometry)});
        },
        [&](osm::CutArea area) {
            report.cut.push_back(
                {TagSet(std::move(area.tags)), area.source_id, placing.place(area.outer), placing.place(area.inner)});
        }};
    try {
        osm::Report read = osm::visit(source.file, wanted, visitor);
        report.defects = std::move(read.defects);
        if (read.stated) {
            const OGREnvelope box = envelope_of(*read.stated);
            if (const auto extent = transformed(box, placing.degrees(), query.system)) report.extent = *extent;
        }
        if (const std::optional<osm::Box> data = read.stated ? read.stated : read.nodes) {
            report.data = outline_of(envelope_of(*data), placing.degrees(), query.system);
        }
    } catch (const osm::ReadError& error) {
        throw refusal(source.name,
                      "is damaged or cut short: " +
                          (ends_early(source.name) ? "its gzip data ends too early" : std::string(error.what())));
    }
    return report;
}

}  // namespace waybreaker::city

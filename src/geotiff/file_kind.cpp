#include "geotiff/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/byte_order_mark.hpp"
#include "core/in_quotes.hpp"
#include "geotiff/xml_root.hpp"

namespace waybreaker::geotiff {
namespace {

using namespace std::string_view_literals;
using enum FileKind::Reader;

// What the first bytes alone say.
struct Signature {
    std::string_view bytes;
    const char* what;
    const char* remedy;
    FileKind::Reader reader;
};

constexpr std::array signatures{
    Signature{"BZh", "packed with bzip2", "unpack it with 'bunzip2 -k'", neither},
    Signature{"\xfd"
              "7zXZ",
              "packed with xz", "unpack it with 'unxz -k'", neither},
    Signature{"\x28\xb5\x2f\xfd", "packed with Zstandard", "unpack it with 'unzstd -k'", neither},
    Signature{"7z\xbc\xaf\x27\x1c", "a 7z archive", "unpack it and name a file in it", neither},
    Signature{"\x1f\x8b", "packed with gzip",
              "waybreaker import reads map data as it is; a map is unpacked with 'gunzip -k'", perhaps_import},
    Signature{"PK\x03\x04", "a ZIP archive", "unpack it and name a file in it, or a folder of shapefiles",
              perhaps_import},
    Signature{"\xff\xe0\x04o5m2", "OpenStreetMap data (o5m)", "", import},
    Signature{"\xff\xe0\x04o5c2", "OpenStreetMap changes in the format o5c",
              "apply them to an extract with 'osmium apply-changes'", neither},
    Signature{"PAR1", "Parquet, which this GDAL does not read",
              "convert it to GeoPackage or GeoJSON, with DuckDB or QGIS for one", perhaps_import},
    Signature{"\xff\xfe", "text in UTF-16", "save it in UTF-8", neither},
    Signature{"\xfe\xff", "text in UTF-16", "save it in UTF-8", neither},
    Signature{"\0\0\x27\x0a"sv, "a shapefile", "", import},
    Signature{"SQLite format 3\0"sv, "GeoPackage or another database", "", import},
    Signature{"fgb\x03", "FlatGeobuf", "", import},
    Signature{"II*\0"sv, "a TIFF", "", map},
    Signature{"MM\0*"sv, "a TIFF", "", map},
    Signature{"II+\0"sv, "a TIFF", "", map},
    Signature{"MM\0+"sv, "a TIFF", "", map},
    Signature{"\x89PNG", "a picture (PNG)", "", map},
    Signature{"type octile", "a MovingAI map", "", map},
    Signature{"\xff\xd8\xff", "a picture (JPEG), whose greys are not exact", "save it as PNG", neither}};

// Of OpenStreetMap's PBF: the length of the first block's header, then its type.
bool is_pbf(std::string_view head) {
    return head.size() > 6 && head.substr(4).starts_with("\x0a\x09OSMHeader");
}

bool is_netpbm(std::string_view head) {
    return head.size() > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '6' && (std::isspace(head[2]) != 0);
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return result;
}

std::optional<FileKind> markup_kind(std::string_view head) {
    const std::string_view text = without_byte_order_mark(head);
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const auto root = xml_root(head);
    const std::string name = root ? lower(root->name) : "";
    const std::string_view local = std::string_view(name).substr(name.find(':') + 1);
    if (lower(text.substr(first, 14)) == "<!doctype html" || name == "html" || name == "head" || name == "body") {
        return FileKind{"a web page (HTML)", "has the download failed? A browser shows what it says", neither};
    }
    if (name == "error") return FileKind{"the error message of a server", "has the download failed?", neither};
    if (name == "osm" || name == "osmchange") return FileKind{"OpenStreetMap data", "", import};
    if (name == "root") return FileKind{"XML as the authors' program has it", "", map};
    if (name == "kml") return FileKind{"KML", "", import};
    if (name == "gpx") return FileKind{"GPX, which holds no areas", "", import};
    if (local == "featurecollection" || local == "citymodel") return FileKind{"GML", "", import};
    if (name == "ogrvrtdatasource") return FileKind{"a virtual source of GDAL", "", import};
    if (name == "vrtdataset") {
        return FileKind{"a virtual raster, which only names others",
                        "write it out with 'gdal_translate IN.vrt OUT.tif'", neither};
    }
    return std::nullopt;
}

std::optional<FileKind> json_kind(std::string_view head) {
    const std::string_view text = without_byte_order_mark(head);
    const std::size_t first = text.find_first_not_of(" \t\r\n\x1e");
    if (first == std::string_view::npos || (text[first] != '{' && text[first] != '[')) return std::nullopt;
    const auto has = [text](std::string_view word) { return text.find(word) != std::string_view::npos; };
    if (has("\"waybreaker-plan/")) return FileKind{"a plan file", "name the map that it was made for", neither};
    if (has("\"waybreaker-mission/")) {
        return FileKind{"a mission file", "name its map, and this file as the mission", neither};
    }
    if (has("\"elements\"") && (has("\"osm3s\"") || has("Overpass"))) {
        return FileKind{"JSON of the Overpass API",
                        "ask for XML: begin the query with [out:xml], end it with (._;>;); out;", neither};
    }
    for (const std::string_view type :
         {"\"FeatureCollection\"", "\"Feature\"", "\"Topology\"", "\"Polygon\"", "\"MultiPolygon\"", "\"LineString\"",
          "\"MultiLineString\"", "\"Point\"", "\"MultiPoint\"", "\"GeometryCollection\""}) {
        if (has(type)) return FileKind{"GeoJSON", "", import};
    }
    // The YAML of a ROS map may stand in braces.
    if (!has("\"") || (has("image") && has("resolution"))) return std::nullopt;
    return FileKind{"JSON, but no GeoJSON", "has the download failed? It begins with " + in_quotes(text.substr(first)),
                    perhaps_import};
}

}  // namespace

std::optional<FileKind> file_kind(std::string_view head) {
    if (head.empty()) return FileKind{"empty", "has the download failed?", neither};
    const auto* const known = std::ranges::find_if(
        signatures, [head](const Signature& signature) { return head.starts_with(signature.bytes); });
    if (known != signatures.end()) return FileKind{known->what, known->remedy, known->reader};
    if (is_pbf(head)) return FileKind{"OpenStreetMap data (PBF)", "", import};
    if (is_netpbm(head)) return FileKind{"a picture (netpbm)", "", map};
    if (auto markup = markup_kind(head)) return markup;
    return json_kind(head);
}

std::optional<OsmFormat> osm_format(std::string_view head) {
    if (is_pbf(head)) return OsmFormat::pbf;
    if (head.starts_with("\xff\xe0\x04o5m2")) return OsmFormat::o5m;
    const std::optional<XmlRoot> root = xml_root(head);
    if (root && root->name == "osm") return OsmFormat::osm;
    return root && root->name == "osmChange" ? std::optional(OsmFormat::osc) : std::nullopt;
}

std::string_view name_of(OsmFormat format) {
    switch (format) {
        case OsmFormat::osm:
            return "osm";
        case OsmFormat::osc:
            return "osc";
        case OsmFormat::pbf:
            return "pbf";
        case OsmFormat::o5m:
            return "o5m";
    }
    return "";
}

std::string description(const FileKind& kind) {
    return "is " + kind.what + (kind.remedy.empty() ? "" : ": " + kind.remedy);
}

}  // namespace waybreaker::geotiff

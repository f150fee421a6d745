// What a file is, by its first bytes, so that who names the wrong one learns what to do with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace waybreaker::geotiff {

struct FileKind {
    // Who reads it: `import` (map data), the commands that take a map, or neither. `perhaps_import`: GDAL may be able
    // to.
    enum class Reader { import, perhaps_import, map, neither };

    std::string what;    // "a web page (HTML)"
    std::string remedy;  // of what nobody reads
    Reader reader = Reader::neither;
};

// Empty if nothing is known by these bytes.
std::optional<FileKind> file_kind(std::string_view head);

// How OpenStreetMap's own data is written: XML, changes in XML, protocol buffers, or o5m.
enum class OsmFormat { osm, osc, pbf, o5m };
std::optional<OsmFormat> osm_format(std::string_view head);
// "osm", "osc", "pbf" or "o5m".
std::string_view name_of(OsmFormat format);

// "is a web page (HTML): ...": what it is, and the remedy.
std::string description(const FileKind& kind);

}  // namespace waybreaker::geotiff

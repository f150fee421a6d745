// Features of OpenStreetMap data as libosmium reads it: nodes with tags, ways, and areas of closed ways and of
// multipolygon relations.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace waybreaker::osm {

// Degrees of longitude and latitude, WGS84.
struct Place {
    double longitude;
    double latitude;
};

using Line = std::vector<Place>;
using Polygon = std::vector<Line>;  // the outer ring, then the holes; all closed
using Tags = std::vector<std::pair<std::string, std::string>>;

struct Box {
    double west;
    double south;
    double east;
    double north;
};

enum class Shape { point, line, area };

struct Feature {
    Shape shape;
    std::int64_t source_id = 0;  // nodes and ways positive, relations negative
    Tags tags = {};
    Line line = {};                   // of a line; a point has one place
    std::vector<Polygon> polygons{};  // of an area
};

// A multipolygon whose rings do not close with the ways that the data has: the edge of the data cuts it.
struct CutArea {
    std::int64_t source_id = 0;  // negative
    Tags tags = {};
    std::vector<Line> outer = {};  // in the direction of the source
    std::vector<Line> inner = {};
};

// Features of a shape are wanted that have one of the keys; any at all if there are none.
struct Keys {
    std::vector<std::string> any_of = {};
};

struct Query {
    std::optional<Keys> points = {};
    std::optional<Keys> lines = {};
    std::optional<Keys> areas = {};
    std::optional<Box> box = {};  // only features whose bounding boxes meet it
};

// Called in this order: points in the source's order; areas of relations; lines and areas of ways. A closed way can be
// both, first an area.
struct Visitor {
    std::function<void(Feature)> feature;
    std::function<void(CutArea)> cut = [](const CutArea&) {};
};

// What was visited and is not as it should be.
struct Defects {
    std::vector<std::int64_t> lacking_nodes = {};  // ways without some of their nodes; visited as what is left of them
    std::vector<std::int64_t> crossing = {};       // relations whose rings cross; their areas are filled by turns
};

struct Report {
    std::optional<Box> stated = {};  // what the file says it has the data of
    std::optional<Box> nodes = {};   // around all of them, if ways were wanted
    Defects defects = {};
};

// How a file is written: "osm" (XML), "osc" (changes in XML), "pbf" or "o5m"; ".gz" behind it if it is packed.
struct File {
    std::string path;
    std::string format;
};

// A file that is damaged, or not what its format says.
class ReadError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// Reads PBF up to three times in little memory, and others once.
Report visit(const File& file, const Query& query, const Visitor& visitor);

}  // namespace waybreaker::osm

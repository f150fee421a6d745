#include "mapfile/map_writer.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "authors/authors_xml_writer.hpp"
#include "geotiff/georeference.hpp"
#include "geotiff/label_tiff.hpp"
#include "io/map_frame.hpp"
#include "io/map_geojson.hpp"
#include "mapfile/grey_image.hpp"
#include "mapfile/ros_map.hpp"
#include "site/unknown_ground.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::mapfile {
namespace {

namespace fs = std::filesystem;

// As ROS map savers write them.
constexpr std::uint8_t blocked_grey = 0;
constexpr std::uint8_t unknown_grey = 205;
constexpr std::uint8_t free_grey = 254;
constexpr std::uint8_t white = 255;

// What a format holds besides which cells are blocked.
struct Format {
    std::string_view extension;
    const char* name;
    bool obstacles;  // which cell belongs to which, their source ids and names, what cannot be destroyed
    bool place;      // coordinate system
    bool origin;     // in a robot's frame
    bool cell_size;
    bool mission;  // start, goal, search options
    bool title;
    bool attribution;
    bool background;
};

constexpr std::array<Format, 9> formats{{
    {".map", "MovingAI map", false, false, false, false, false, false, false, false},
    {".xml", "XML task file", false, false, false, true, true, true, false, false},
    {".tif", "GeoTIFF", true, true, true, true, false, true, true, true},
    {".tiff", "GeoTIFF", true, true, true, true, false, true, true, true},
    {".geojson", "GeoJSON", true, true, false, false, false, true, true, false},
    {".yaml", "ROS map", false, false, true, true, false, false, false, false},
    {".yml", "ROS map", false, false, true, true, false, false, false, false},
    {".png", "PNG", false, false, false, false, false, false, false, false},
    {".pgm", "PGM", false, false, false, false, false, false, false, false},
}};

const Format& format_of(const std::string& path) {
    const std::string extension = fs::path(path).extension().string();
    const auto* const found = std::ranges::find(formats, extension, &Format::extension);
    if (found != formats.end()) return *found;
    std::string known;
    for (const Format& format : formats) known += (known.empty() ? "" : ", ") + std::string(format.extension);
    throw InputError(path + ": the name says no format for a map; end it in one of " + known);
}

// The blocked cells, those of unknown space apart.
RosCells ros_cells_of(const io::MapFile& file) {
    const std::vector<bool> unknown = site::unknown_obstacles(file.map, file.annotations.tags);
    const Map& map = file.map;
    RosCells cells{.occupied = Grid(map.width(), map.height()), .unknown = Grid(map.width(), map.height())};
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            const ObstacleId id = map.obstacle_at(c);
            if (!id) continue;
            (unknown[id.value] ? cells.unknown : cells.occupied).set_blocked(c, true);
            if (unknown[id.value]) ++cells.unknown_count;
        }
    }
    return cells;
}

// Whether the obstacles differ from the connected sets of blocked cells, and of unknown ones in a ROS map.
std::string lost_obstacles(const io::MapFile& file, bool to_ros) {
    const Map& map = file.map;
    const Map seen = to_ros ? ros_map(ros_cells_of(file), Connectivity::four, false) : Map{Grid(map.grid())};
    const bool same = std::equal(seen.labels().begin(), seen.labels().end(), map.labels().begin());
    std::string loss = same ? ""
                            : "that its " + std::to_string(map.obstacles().size()) + " obstacles are not the " +
                                  std::to_string(seen.obstacles().size()) + " connected ones";
    const auto any = [&](auto holds) { return std::any_of(map.obstacles().begin(), map.obstacles().end(), holds); };
    if (any([](const Obstacle& o) { return o.source_id != 0; }))
        loss += (loss.empty() ? "" : ", ") + std::string("source ids");
    const site::Annotations& known = file.annotations;
    if (!known.names.empty()) loss += (loss.empty() ? "" : ", ") + std::string("names");
    if (!known.kinds.empty()) loss += (loss.empty() ? "" : ", ") + std::string("kinds");
    if (known.tags.size() > known.tags.count(site::unknown_tag))
        loss += (loss.empty() ? "" : ", ") + std::string("tags");
    if (any([](const Obstacle& o) { return o.weight != 1 || o.breach_time != 0; })) {
        loss += (loss.empty() ? "" : ", ") + std::string("what their removal costs");
    }
    const std::vector<bool> unknown = site::unknown_obstacles(file.map, file.annotations.tags);
    if (any([&](const Obstacle& o) { return !o.destructible && !(to_ros && unknown[o.id.value]); })) {
        loss += (loss.empty() ? "" : ", ") + std::string("which obstacles cannot be destroyed");
    }
    return loss;
}

std::vector<std::string> losses_of(const io::MapFile& map, const Format& format) {
    std::vector<std::string> losses;
    const auto lose = [&](bool held, const std::string& what) {
        if (!held && !what.empty()) losses.push_back(std::string("a ") + format.name + " does not hold " + what);
    };
    const bool to_ros = std::string_view(format.name) == "ROS map";
    const bool as_ros = map.ros && to_ros;
    const bool is_tiff = std::string_view(format.name) == "GeoTIFF";
    const bool knows_unknown = to_ros || is_tiff;
    const std::vector<bool> unknown = site::unknown_obstacles(map.map, map.annotations.tags);
    const bool apart = std::ranges::find(unknown, true) != unknown.end();
    lose(format.obstacles || as_ros, lost_obstacles(map, to_ros));
    lose(format.place || !map.georeference, "the coordinate system");
    lose(format.cell_size || map.cell_size == 1, "the size of a cell");
    constexpr std::array<double, 2> usual_origin{};
    lose(format.origin || map.origin.value_or(usual_origin) == usual_origin, "the origin of the map");
    lose(as_ros || map.unknown == 0 || (knows_unknown && apart),
         "that cells are unknown: they are written as they were taken, blocked or free");
    lose(format.mission || !map.task || !map.task->start, "start, goal and search options");
    lose(!map.task || map.task->agents.empty(), "the agents of a task for many");
    const site::Annotations& known = map.annotations;
    lose(format.background || known.background.features.empty(),
         "streets, water and what else lies around the obstacles");
    lose(std::string_view(format.name) == "GeoTIFF" || !known.profile, "whom the map was made for");
    lose(is_tiff || (known.ways.empty() && known.bridges.empty()), "which cells are ways and bridges");
    lose(format.title || known.title.empty(), "the title");
    lose(is_tiff || known.notes.empty(), "the notes");
    lose(format.attribution || known.attribution.empty(),
         "the attribution, which must go with it: " + known.attribution);
    return losses;
}

std::vector<std::uint8_t> grey(const Grid& grid, std::uint8_t of_free) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(grid.cell_count());
    for (Cell c; c.y < grid.height(); ++c.y) {
        for (c.x = 0; c.x < grid.width(); ++c.x) pixels.push_back(grid.blocked(c) ? blocked_grey : of_free);
    }
    return pixels;
}

// ROS maps that were read are written unchanged; others as nav2's map saver writes them.
std::vector<io::OutputFile> ros_files(const io::MapFile& map, const std::string& path) {
    fs::path extension = map.ros ? fs::path(map.ros->yaml.image).extension() : fs::path(".pgm");
    if (extension == fs::path(path).extension()) extension = ".pgm";  // not over the YAML itself
    const fs::path image_path = fs::path(path).replace_extension(extension);
    const std::string image = image_path.filename().string();
    if (map.ros) return {{image_path.string(), map.ros->image}, {path, with_image(map.ros->text, image, path)}};
    const Point origin = io::MapFrame(map).origin();
    const io::RosYaml yaml{.image = image, .resolution = map.cell_size, .origin = {origin.x, origin.y}};
    const Grid& grid = map.map.grid();
    std::vector<std::uint8_t> pixels = grey(grid, free_grey);
    const std::vector<bool> unknown = site::unknown_obstacles(map.map, map.annotations.tags);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (unknown[map.map.labels()[i]]) pixels[i] = unknown_grey;
    }
    return {{image_path.string(), pgm_bytes(grid.width(), grid.height(), pixels)}, {path, ros_yaml_text(yaml)}};
}

std::string bytes_of(const io::MapFile& map, std::string_view extension) {
    const Grid& grid = map.map.grid();
    if (extension == ".map") return movingai_map(grid);
    if (extension == ".geojson") return io::map_geojson(map, geotiff::lon_lat_of(map.georeference));
    if (extension == ".xml") return authors::authors_xml_text(map);
    if (extension == ".png") return png_bytes(grid.width(), grid.height(), grey(grid, white));
    if (extension == ".pgm") return pgm_bytes(grid.width(), grid.height(), grey(grid, white));
    return geotiff::label_tiff_bytes({.map = map.map,
                                      .cell_size = map.cell_size,
                                      .georeference = map.georeference,
                                      .origin = map.origin,
                                      .annotations = map.annotations});
}

}  // namespace

bool holds_obstacles(const std::string& path) {
    return format_of(path).obstacles;
}

WrittenMap write_map(const io::MapFile& map, const std::string& path) {
    const Format& format = format_of(path);
    WrittenMap result{.files = {}, .losses = losses_of(map, format)};
    if (std::string_view(format.name) == "ROS map") {
        result.files = ros_files(map, path);
    } else {
        result.files.push_back({path, bytes_of(map, format.extension)});
    }
    return result;
}

}  // namespace waybreaker::mapfile

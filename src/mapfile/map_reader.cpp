#include "mapfile/map_reader.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "authors/authors_xml.hpp"
#include "authors/xml_element.hpp"
#include "core/byte_order_mark.hpp"
#include "core/range.hpp"
#include "geotiff/file_kind.hpp"
#include "geotiff/label_tiff.hpp"
#include "io/output_file.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/grey_image.hpp"
#include "mapfile/occupancy.hpp"
#include "mapfile/ros_map.hpp"
#include "site/unknown_ground.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::mapfile {
namespace {

using namespace std::string_view_literals;
using authors::is_xml;

constexpr std::size_t most_map_bytes = std::size_t{1} << 31;
constexpr std::string_view movingai_start = "type";

// TIFF and BigTIFF, in either byte order.
bool is_tiff(std::string_view bytes) {
    return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
           bytes.starts_with("MM\0+"sv);
}

// The map that `make` makes, with the time that takes.
template <class Make>
io::MapFile timed(Make make, const std::string& format) {
    const auto start = std::chrono::steady_clock::now();
    io::MapFile file{.map = make(), .format = format};
    file.label_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return file;
}

io::MapFile labelled(Grid grid, Connectivity connectivity, const std::string& format, const MapLimits& limits) {
    if (limits.admit) limits.admit(map_bytes(grid.width(), grid.height(), count_obstacles(grid, connectivity)));
    return timed([&] { return Map(std::move(grid), connectivity); }, format);
}

// Text holds each cell as a byte at least, so that its grid is small; labels are not.
void require_at_most(std::size_t most_cells, const Grid& grid, const std::string& path) {
    if (grid.cell_count() <= most_cells) return;
    throw SizeError(path, 0,
                    "has " + std::to_string(grid.cell_count()) + " cells, it may have " + std::to_string(most_cells));
}

// Labels and pictures need their memory; the file's bytes go before.
void release(std::string& bytes) {
    std::string().swap(bytes);
}

io::MapFile read_tiff(std::string_view bytes, const std::string& path, Connectivity connectivity,
                      const MapLimits& limits) {
    geotiff::LabelTiff tiff = geotiff::read_label_tiff(bytes, path, connectivity, limits);
    std::vector<std::string> notes;
    if (tiff.mask)
        notes.emplace_back("it has one value beside 0 and no list of obstacles: all cells but those of 0 are blocked");
    io::MapFile file{.map = std::move(tiff.map),
                     .format = tiff.mask ? "GeoTIFF occupancy map" : "GeoTIFF label map",
                     .cell_size = tiff.cell_size,
                     .georeference = std::move(tiff.georeference),
                     .origin = tiff.origin,
                     .annotations = std::move(tiff.annotations),
                     .notes = std::move(notes)};
    file.unknown = site::unknown_cells(file.map, file.annotations.tags);
    return file;
}

io::MapFile read_xml(std::string& bytes, const std::string& path, Connectivity connectivity, const MapLimits& limits) {
    authors::AuthorsXml xml = authors::parse_authors_xml(bytes, path);
    release(bytes);
    require_at_most(limits.cells, xml.grid, path);
    io::MapFile file = labelled(std::move(xml.grid), connectivity, "authors' XML", limits);
    file.cell_size = xml.cell_size;
    file.annotations.title = std::move(xml.title);
    if (xml.task.smoothing) {
        file.notes.emplace_back("its <postsmoothing> is not heeded: paths stay as its planner finds them");
    }
    file.task = std::move(xml.task);
    return file;
}

// What is taken for blocked, and what a ROS map's image alone does not say.
std::vector<std::string> notes_of(const GreyImage& image, double threshold) {
    constexpr int white = 255;
    constexpr int saved_for_unknown = 205;
    const int lightest = int(std::floor(white * (1 - threshold)));
    std::vector<std::string> notes{"an image alone says no threshold: greys of 0 to " + std::to_string(lightest) +
                                   " are blocked, lighter ones free"};
    const bool has_unknown = std::ranges::any_of(image.pixels, [](const GreyImage::Pixel& pixel) {
        return pixel.sum == 3 * saved_for_unknown && pixel.alpha == white;
    });
    if (has_unknown) {
        notes.push_back("so the grey of 205, which map savers of ROS write for unknown, is " +
                        std::string(lightest < saved_for_unknown ? "free" : "blocked") +
                        "; with the map's YAML it is what that says");
    }
    return notes;
}

io::MapFile read_plain_image(std::string& bytes, const std::string& path, Connectivity connectivity,
                             const io::ImageReading& reading, const MapLimits& limits) {
    constexpr double half = 0.5;
    const std::string format = is_png(bytes) ? "PNG image" : "netpbm image";
    const double threshold = reading.threshold.value_or(half);
    std::vector<std::string> notes;
    Grid grid = [&] {
        const GreyImage image = read_image(bytes, path, limits.cells);
        release(bytes);
        notes = notes_of(image, threshold);
        return grid_of(image, threshold);
    }();
    io::MapFile file = labelled(std::move(grid), connectivity, format, limits);
    file.notes = std::move(notes);
    return file;
}

// That the grey of 205 is free, and what makes it unknown: in mode scale no grey is, and to nav2 Humble transparency
// makes all of a trinary image lighter.
std::string note_of_free_unknown(io::RosYaml yaml, bool transparency, io::Nav2 nav2) {
    const bool scale = yaml.mode == io::RosMode::scale;
    std::string note = std::string("its ") + (scale ? "mode, scale, takes" : "free_thresh takes") +
                       " the grey of 205, which map savers write for unknown, for free";
    yaml.mode = io::RosMode::trinary;
    yaml.free_thresh = 0.196;
    if (occupancy(GreyImage::Pixel::of_grey(205), false, yaml, nav2)) return note;
    const bool lighter = transparency && nav2 == io::Nav2::humble;
    return note + "; with " + (scale ? "mode trinary and " : "") + (lighter ? "no transparency and " : "") +
           "0.196 it is unknown";
}

// Nothing else of a ROS map cannot be destroyed.
void tag_unknown(io::MapFile& file) {
    std::vector<ObstacleId>& unknown = file.annotations.tags[site::unknown_tag];
    for (const Obstacle& obstacle : file.map.obstacles()) {
        if (!obstacle.destructible) unknown.push_back(obstacle.id);
    }
}

io::MapFile read_ros_pieces(RosPieces pieces, const std::string& path, const std::string& image_path,
                            Connectivity connectivity, const io::ImageReading& reading, const MapLimits& limits) {
    io::RosYaml yaml = parse_ros_yaml(pieces.text, path);
    const RosCells cells = ros_cells(read_image(pieces.image, image_path, limits.cells), yaml,
                                     reading.threshold.value_or(1), reading.nav2);
    io::MapFile file = timed([&] { return ros_map(cells, connectivity, reading.unknown_free); }, "ROS map");
    if (cells.unknown_count > 0 && !reading.unknown_free) tag_unknown(file);
    file.digest = sha256_digest(pieces.text + pieces.image);
    file.cell_size = yaml.resolution;
    file.origin = yaml.origin;
    file.unknown = cells.unknown_count;
    if (cells.frees_unknown) {
        file.notes.push_back(note_of_free_unknown(yaml, cells.transparency, reading.nav2));
    }
    file.ros = io::RosFiles{std::move(yaml), std::move(pieces.text), std::move(pieces.image), reading.nav2};
    return file;
}

// The bytes of a map's image; of another file, none but the first are read.
std::string read_image_bytes(const std::string& path) {
    return io::read_whole(path, most_map_bytes, [&](std::string_view head) {
        if (!is_png(head) && !is_netpbm(head)) {
            throw InputError(path, 0, "is no image that can be read: give PNG or PGM");
        }
    });
}

io::MapFile read_ros_map(std::string& text, const std::string& path, Connectivity connectivity,
                         const io::ImageReading& reading) {
    const std::string image = parse_ros_yaml(text, path).image;
    const std::string image_path = (std::filesystem::path(path).parent_path() / image).string();
    return read_ros_pieces({std::move(text), read_image_bytes(image_path)}, path, image_path, connectivity, reading,
                           {});
}

// Detected from the first bytes, so that files of other kinds are not read to their end.
void require_map(std::string_view head, const std::string& path) {
    using enum geotiff::FileKind::Reader;
    const std::optional<geotiff::FileKind> kind = geotiff::file_kind(head);
    if (kind && kind->reader == import) {
        throw InputError(path, 0, "is map data (" + kind->what + "): waybreaker import makes a map of it");
    }
    if (kind && kind->reader != map) throw InputError(path, 0, geotiff::description(*kind));
    if (is_tiff(head) || is_png(head) || is_netpbm(head) || is_xml(head) || is_ros_yaml(head) ||
        without_byte_order_mark(head).starts_with(movingai_start)) {
        return;
    }
    throw InputError(path, 0,
                     "not a map that can be read: give a MovingAI map (its first line is 'type octile'), a task in "
                     "the authors' XML, a GeoTIFF, the YAML of a ROS map, or an image (PNG, PGM, PBM, PPM)");
}

// The world file beside an image, as its name ends for that one: m.tfw, m.tifw or m.wld of m.tif; empty if there is
// none.
std::string world_file_of(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();  // with its dot
    if (ending.size() < 3) return "";
    const std::string shortened{ending[1], ending.back(), 'w'};
    for (const std::string& name : {shortened, ending.substr(1) + "w", std::string("wld")}) {
        const std::filesystem::path world = std::filesystem::path(path).replace_extension(name);
        std::error_code failed;
        if (std::filesystem::is_regular_file(world, failed)) return world.filename().string();
    }
    return "";
}

// GIS keep some of what they know of an image in files beside it, but a map is one file. What would change its cells is
// refused; where it would lie is said.
void heed_neighbours(const std::string& path, io::MapFile& file) {
    std::error_code failed;
    const bool tiff = file.format.starts_with("GeoTIFF");
    if (tiff && std::filesystem::exists(path + ".msk", failed)) {
        throw InputError(path, 0,
                         "has a mask in a file beside it, " + file.source +
                             ".msk; put both into one with 'gdal_translate --config GDAL_TIFF_INTERNAL_MASK YES'");
    }
    const bool image = tiff || file.format == "PNG image" || file.format == "netpbm image";
    if (!image || file.georeference || file.origin) return;
    const std::string world = world_file_of(path);
    if (world.empty()) return;
    file.notes.push_back(
        "the world file beside it, " + world + ", is not read: " +
        (tiff ? "'gdal_translate' writes what it says into a new file" : "give the size of a cell in metres"));
}

io::MapFile parse(std::string& bytes, const std::string& path, Connectivity connectivity, const io::ImageReading& image,
                  const MapLimits& limits) {
    require_map(std::string_view(bytes).substr(0, io::head_size), path);
    if (is_tiff(bytes)) return read_tiff(bytes, path, connectivity, limits);
    if (is_png(bytes) || is_netpbm(bytes)) return read_plain_image(bytes, path, connectivity, image, limits);
    if (is_xml(bytes)) return read_xml(bytes, path, connectivity, limits);
    if (auto pieces = ros_pieces(bytes)) {
        return read_ros_pieces(std::move(*pieces), path, path, connectivity, image, limits);
    }
    if (is_ros_yaml(bytes)) return read_ros_map(bytes, path, connectivity, image);
    Grid grid = read_movingai_map(std::string_view(bytes), path);
    release(bytes);
    require_at_most(limits.cells, grid, path);
    return labelled(std::move(grid), connectivity, "MovingAI map", limits);
}

io::MapFile read(std::string& bytes, const std::string& path, Connectivity connectivity, const io::ImageReading& image,
                 const MapLimits& limits) {
    io::MapFile file = parse(bytes, path, connectivity, image, limits);
    require_range(file.cell_size, io::least_cell_size, io::most_cell_size, path + ": the side of a cell, in metres,");
    return file;
}

std::string name_of(const std::string& path) {
    return io::is_standard_input(path) ? io::input_name(path) : path;
}

}  // namespace

std::string read_map_bytes(const std::string& path) {
    return io::read_whole(path, most_map_bytes, [&](std::string_view head) { require_map(head, name_of(path)); });
}

io::MapFile read_map_file(const std::string& path, Connectivity connectivity, const io::ImageReading& image) {
    const std::string name = name_of(path);
    std::string bytes = read_map_bytes(path);
    std::string digest = sha256_digest(bytes);
    io::MapFile file = read(bytes, name, connectivity, image, {});
    file.source = std::filesystem::path(name).filename().string();
    if (file.digest.empty()) file.digest = std::move(digest);
    if (!io::is_standard_input(path)) heed_neighbours(path, file);
    return file;
}

io::MapFile parse_map(std::string bytes, const std::string& name, Connectivity connectivity,
                      const io::ImageReading& image, const MapLimits& limits) {
    const bool one_file = is_tiff(bytes) || is_png(bytes) || is_netpbm(bytes) || is_xml(bytes) || ros_pieces(bytes);
    if (!one_file && is_ros_yaml(bytes)) {
        throw InputError(
            name, 0, "a ROS map is two files: give both in one, the YAML, a line of three dots and the image's bytes");
    }
    std::string digest = sha256_digest(bytes);
    io::MapFile file = read(bytes, name, connectivity, image, limits);
    file.source = name;
    if (file.digest.empty()) file.digest = std::move(digest);
    return file;
}

}  // namespace waybreaker::mapfile

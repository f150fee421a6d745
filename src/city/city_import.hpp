// Import: footprints of any vector source GDAL knows, rasterised into label maps.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "city/ground_rules.hpp"
#include "city/obstacle_choice.hpp"
#include "city/overlay_source.hpp"
#include "geotiff/label_tiff.hpp"

namespace waybreaker::city {

struct ImportOptions {
    double longitude = 0;  // of the window's centre, WGS84 degrees
    double latitude = 0;
    double size = 1202.4;         // side of the square window, in metres, rounded to whole cells: 501, as in the paper
    double cell = 2.4;            // side of a cell, in metres
    bool merge_touching = false;  // obstacles are 4-connected components (the paper) instead of one per building
    // West, south, east, north in degrees: then the window is what holds these, in place of centre and size.
    std::optional<std::array<double, 4>> box = {};
    // Who drives, and so what bars the way beside buildings. Empty: a rover; or, where obstacles are chosen, nobody
    // (`paper`), so that they are all there is. Obstacles that are chosen beside a profile take the place of its
    // buildings and barriers.
    std::optional<Profile> profile = {};
    // Side of the squares that one breach opens, in metres, rounded to whole cells; 0: whole obstacles. Empty: 20 for a
    // profile other than `paper`, else 0.
    std::optional<double> section = {};
    ObstacleChoice choice = {};
    bool names = true;       // keep what people call the obstacles
    bool background = true;  // keep streets, water, green and places
    // What lies beyond the data of an OpenStreetMap file is free instead of unknown. For `paper` it always is.
    bool unknown_free = false;
    // What is laid over the finished map, one after the other; what they weigh is as `choice` says.
    std::vector<OverlaySource> overlays = {};
};

// Columns and rows of the window. Throws InputError, naming the option, if there is no such window.
std::array<int, 2> import_cells(const ImportOptions& options);

struct ImportReport {
    geotiff::LabelTiff tiff;
    std::size_t buildings = 0;    // that have some area inside the window; those that own no cell are no obstacle
    double area = 0;              // of their parts inside the window, in square metres; overlaps count twice
    double covered = 1;           // the share of the window that the source has data of: see data_area.hpp
    bool unknown_beyond = false;  // the rest is unknown ground; else it is free
    Profile profile = Profile::paper;
    std::size_t sheltered = 0;            // obstacles that the profile protects
    std::vector<std::string> notes = {};  // what the user should know of the source, a line each
    std::vector<OverlayReport> overlays = {};
};

// Buildings, or what else is chosen, become obstacles, one each unless merged, with their source ids (OSM ways
// positive, relations negative) and names; projected to the local UTM zone. A cell belongs to the building that covers
// its centre; the first in the source's order where several do. What bars the profile's way for ever (water, forbidden
// ground) becomes obstacles that cannot be destroyed, under buildings too: see ground_map.hpp. So does what is free
// beyond the data of an OpenStreetMap file: site/unknown_ground.hpp. With sections, what
// can be destroyed is cut along a lattice from the window's north-western corner: see site/split.hpp. Throws InputError
// (source and remedy) if there is nothing to import, or a filter matches nothing in all of the source.
ImportReport import_city(const std::string& source, const ImportOptions& given);

struct ImportTile {
    int column = 0;  // from the west
    int row = 0;     // from the north
    ImportReport report;
};

// The window cut into squares of `side` metres, rounded to whole cells, from its north-western corner; what is left in
// the east and south is no whole tile. Visits those with an obstacle beside unknown ground, row by row; gives the
// number of all. The source is read once. Throws as import_city, also if the window has no whole tile.
std::size_t import_tiles(const std::string& source, const ImportOptions& given, double side,
                         const std::function<void(const ImportTile&)>& visit);

}  // namespace waybreaker::city

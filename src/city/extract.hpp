// Extract: what a source of map data covers and where it is built up most, so that people can choose a window to
// import.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace waybreaker::city {

struct NamedPlace {
    std::string name;
    std::array<double, 2> at;  // longitude and latitude
};

struct Extract {
    // West, south, east, north in degrees (WGS84): the box that the source states, else the one around its buildings.
    std::array<double, 4> bounds{};
    std::size_t buildings = 0;
    // The box in equal parts, of those the longer side has 64, row by row from the north-western one: the share of each
    // that is built up, from 0 to 1, to a hundredth. A building counts where the middle of its bounding box is.
    int columns = 0;
    int rows = 0;
    std::vector<double> built = {};
    // The square with the largest area of buildings, of those as large as the window of an import or, if the box is
    // smaller, as fit into it: longitude and latitude of its middle, and its side in metres.
    std::array<double, 2> densest{};
    double side = 0;
    // Cities, towns, villages and quarters, as OpenStreetMap's nodes say, the most important first; at most 40.
    std::vector<NamedPlace> places = {};
};

// Two scans of the source: of its places, and of its buildings, as the profiles other than `paper` count them. Throws
// InputError if it cannot be read, or has no buildings.
Extract read_extract(const std::string& source);

}  // namespace waybreaker::city

// The window of an import: whole cells in a UTM zone.
#pragma once

#include <array>

#include "city/city_import.hpp"
#include "city/footprints.hpp"

namespace waybreaker::city {

struct CellWindow {
    Window window;
    int width = 0;  // in cells
    int height = 0;
    site::Georeference georeference;
    std::array<double, 2> center;  // longitude and latitude
};

// Throws InputError, naming the option, if there is no such window.
CellWindow import_window(const ImportOptions& options);

// A part of a window, in cells from its upper-left corner.
CellWindow part_of(const CellWindow& whole, int x, int y, int width, int height);

// The cells of a map that lies somewhere.
CellWindow window_of(const site::Georeference& place, int width, int height);

}  // namespace waybreaker::city

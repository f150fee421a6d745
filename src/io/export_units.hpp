// What the numbers of an exported plan count.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::io {

struct ExportUnits {
    bool in_seconds = false;  // a unit of time is a second
    std::string crs = {};  // of the metres in the map's frame, e.g. "EPSG:32633"; empty if the frame is the map's own
};

// The unit of all times: "s", or how long a cell takes at speed 1.
inline std::string_view time_unit(const ExportUnits& units) {
    return units.in_seconds ? "s" : "cells at speed 1";
}

}  // namespace waybreaker::io

// Overlays from vector data of any format GDAL reads, in any coordinate system.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "city/obstacle_choice.hpp"
#include "site/georeference.hpp"
#include "site/overlay.hpp"

namespace waybreaker::city {

using site::OverlaySource;

// What removing each thing takes, if it can be removed; as of the obstacles of an import.
struct OverlayCosts {
    Quantity weight = {};
    Quantity breach_time = {};
};

struct OverlayReport {
    std::string file;
    site::OverlayUse use = site::OverlayUse::water;
    std::size_t things = 0;  // that have a cell of the map
    std::size_t cells = 0;   // that they have
    std::vector<std::string> notes = {};
};

struct ReadOverlay {
    site::Overlay overlay;
    OverlayReport report;
};

// Every area, line and point of the source that meets a map of that size and place, with its name. An area covers the
// cells whose centres it covers, a line is a strip of at least a cell; where things overlap, the first in the source's
// order has the cell. Throws InputError (source and remedy) if it cannot be read.
ReadOverlay read_overlay(const OverlaySource& source, const site::Georeference& place, int width, int height,
                         const OverlayCosts& costs = {});

// Reads it and lays it over a map that lies there.
OverlayReport lay_over(const OverlaySource& source, const site::Georeference& place, const OverlayCosts& costs,
                       site::DescribedMap& map);

}  // namespace waybreaker::city

// The picture of a plan: map, obstacles, removed ones, both agents' paths before and after, legend, scale bar, caption.
#pragma once

#include <string>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct PictureOptions {
    int width = 1200;         // pixels; the height follows from the map
    double cell_size = 1;     // metres per cell, for the scale bar
    bool metres = false;      // lengths in metres instead of cells
    std::string title;        // first line of the caption
    std::string attribution;  // small print, e.g. "(c) OpenStreetMap contributors, ODbL 1.0"
};

// An SVG document. Same input, same bytes.
std::string svg(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options);

// The same picture as PNG bytes.
std::string png(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options);

}  // namespace waybreaker::render

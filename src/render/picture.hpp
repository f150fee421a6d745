// The picture of a plan: map, obstacles, removed ones, both agents' paths before and after, legend, scale bar, caption.
//
//     save("plan.svg", render::svg(map, mission, plan, {.annotations = {.title = "Berlin"}}));
#pragma once

#include <optional>
#include <string>

#include "model/reach.hpp"
#include "site/annotations.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

inline constexpr int least_width = 300;
inline constexpr int most_width = 8000;

struct PictureOptions {
    int width = 1200;                           // pixels, least_width to most_width; the height follows from the map
    double cell_size = 1;                       // metres a cell, > 0: lengths are multiplied by it
    bool metres = false;                        // what lengths are then called: metres, or cells
    bool seconds = false;                       // a unit of the mission's time is a second
    bool animate = false;                       // the plan plays, over and over (render/motion.hpp)
    Objective objective = Objective::makespan;  // what the plan's bound is one of
    // The title is the first line, the notes stand below the legend, the attribution in small print; the background is
    // drawn beneath the obstacles, water as such, unknown ground too; what is removed is called by its sections.
    site::Annotations annotations = {};
    // Drawn as bands of time in place of the background, what the plan gains marked, and places as dots.
    std::optional<Reach> reach = {};
};

// An SVG document. Obstacles are outlines; those of maps with cells smaller than half a pixel are drawn coarser, so
// that the size is bounded by the picture's. Same input, same bytes. Throws InputError if the width or the cell size is
// out of range.
std::string svg(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options);

}  // namespace waybreaker::render

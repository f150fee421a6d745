// Reach in a picture: ground by when it is reached, as bands of time; what a plan gains; places as dots.
#pragma once

#include <string>
#include <vector>

#include "render/legend.hpp"
#include "render/scene.hpp"

namespace waybreaker::render {

// All of these REQUIRE a scene with PictureOptions::reach.

// With the plan. Hatched where it is clearly sooner than without, or reached at all. SVG elements.
std::string draw_bands(const Scene& scene);

// Of the ground agents, in their order: where the hub is not.
std::vector<Cell> places_of(const Scene& scene);
// The more a place counts for, the larger its dot.
std::string draw_places(const Scene& scene);

// A path of a ground agent, thin.
std::string drive_sign(const std::vector<Point>& path, double unit);

// What the picture shows of bands, gains and places.
std::vector<LegendEntry> reach_legend(const Scene& scene);

// For the document's <defs>.
std::string reach_patterns(double unit, double scale);

}  // namespace waybreaker::render

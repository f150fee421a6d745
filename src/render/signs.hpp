// Signs: the graphic vocabulary of a picture, drawn alike on the map and in the legend. All return SVG elements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "render/layout.hpp"
#include "render/outline.hpp"

namespace waybreaker::render {

enum class PathSign { ground, air, ground_before, air_before };

// Paths differ in colour and in pattern: ground is solid, air is dashed, before is thin and dashed or dotted. `unit` is
// a thousandth of the picture's width in all of these.
std::string path_sign(PathSign sign, const std::vector<Point>& points, double unit);

// The path of a team's vehicle, of its aircraft: number 0 is the first.
std::string vehicle_sign(std::size_t number, const std::vector<Point>& points, double unit);
std::string aircraft_sign(std::size_t number, const std::vector<Point>& points, double unit);

// A ring; a wide one around the goal if that is at the same place.
std::string start_sign(Point at, double unit, bool is_goal = false);
std::string goal_sign(Point at, double unit);

// A plate with a battery on it, where aircraft recharge.
std::string base_sign(Point at, double unit);

// A breach has a disc with its number, and a line to it if the disc lies aside. Without a number the disc is small.
std::string breach_leader(Point at, Point label, double unit);
std::string breach_label(Point at, std::string_view number, double unit);

// A ring around such a disc, in the colour of the aircraft that breaches.
std::string opener_sign(Point at, std::size_t aircraft, double unit);

// A disc with two bars where the ground agent waits; as large as a breach's.
std::string wait_sign(Point at, double unit);

// A few words that begin at a place, on their baseline.
std::string words(Point begin, std::string_view content, double unit);

// Obstacles of one style, given as path data; `scale` is the size of the data's unit in pixels, `origin` its (0, 0).
std::string obstacle_sign(Style style, std::string_view path_data, Point origin, double scale, double unit);

// The patterns that obstacle_sign of the same scale needs in the document's <defs>: openings, water, forbidden
// and unknown ground differ by more than their colour.
std::string patterns(double unit, double scale);

enum class Anchor { start, middle, end };

// `content` is XML already.
std::string text(Point at, std::string_view content, double pixels, std::string_view colour,
                 Anchor anchor = Anchor::start, bool bold = false);

std::string rectangle(Rectangle r, std::string_view more);

}  // namespace waybreaker::render

// What a map's maker noticed of its ground, as lines under its picture.
#pragma once

#include <string>
#include <vector>

#include "render/layout.hpp"

namespace waybreaker::render {

// Any bytes in, XML out. Long notes go on in the next line; where there are too many lines the last one ends in an
// ellipsis.
std::vector<std::string> note_lines(const std::vector<std::string>& notes);

// The lines as SVG, above a line of small print.
std::string draw_notes(const std::vector<std::string>& lines, Point small_print, double unit);

}  // namespace waybreaker::render

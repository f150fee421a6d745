// Layout: where the parts of a picture lie, in pixels. Captions and legend lie outside the map and cover nothing.
#pragma once

#include <string>
#include <vector>

#include "render/picture.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::render {

struct Point {
    double x;
    double y;
    friend bool operator==(Point, Point) = default;
};

struct Rectangle {
    double x;
    double y;
    double width;
    double height;
};

struct Layout {
    double width;      // of the picture
    double height;     // of the picture
    double unit;       // a thousandth of the width
    double cell;       // pixels a cell
    int sample_step;   // cells a drawn cell stands for, in each direction
    Rectangle window;  // room for the map, which lies in its middle
    Rectangle map;

    // The centre of a cell.
    Point at(double x, double y) const { return {map.x + (x + 0.5) * cell, map.y + (y + 0.5) * cell}; }
    Point at(Cell c) const { return at(c.x, c.y); }
    // For what is written on the map: beside it there is a margin.
    Rectangle room() const {
        const double edge = 6 * unit;
        return {edge, window.y - edge, width - 2 * edge, window.height + 2 * edge};
    }
};

// `legend_rows`: lines of text that the part under the map has room for.
Layout lay_out(const Map& map, const PictureOptions& options, std::size_t legend_rows);

struct ScaleBar {
    double length;  // in pixels
    std::string label;
};

// A bar of a round length, about a fifth of the picture's width, never longer than the map is wide or than a cell.
ScaleBar scale_bar(const Layout& layout, const PictureOptions& options);

// Where discs that label `points` can lie in the window so that they cover neither each other nor `taken`: on their
// points if possible, else near them.
std::vector<Point> spread_labels(const std::vector<Point>& points, const std::vector<Point>& taken, double radius,
                                 Rectangle window);

}  // namespace waybreaker::render

// Stretches: where on a straight move somebody is in a zone. In reals, to within `margin`: who goes along an outline is
// not.
#pragma once

#include <vector>

#include "waybreaker/cell.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::zones {

// Cells, by which somebody may be in a zone: less than what judges of plans let pass, more than rounding does.
inline constexpr double margin = 1.0 / 4096;

// A part of a move, as shares of it: 0 <= from < to <= 1.
struct Stretch {
    double from = 0;
    double to = 1;
};

// A zone as those meet it for whom it holds: aircraft its polygon, vehicles the cells that it reaches into.
class Closed {
  public:
    // REQUIRES: a valid zone.
    Closed(const Zone& zone, int width, int height);

    // On the way from one point to another, in order and apart from each other. Of an aircraft the radius is 0. Who
    // stands (both points are one) is in it all the time or never.
    std::vector<Stretch> stretches(Point a, Point b, double radius) const;

  private:
    struct Run {  // of cells in a row
        Point least;
        Point most;
    };

    std::vector<Stretch> in_polygon(Point a, Point b) const;
    bool holds(Point p) const;
    double from_outline(Point p) const;
    bool is_along_outline(Point a, Point b) const;

    std::vector<std::vector<Point>> polygon_;  // of a zone for aircraft
    std::vector<Run> runs_;                    // of one for vehicles
};

}  // namespace waybreaker::zones

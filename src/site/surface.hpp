// Surface: what a vehicle's path leads over, by what a map knows of its cells.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "site/annotations.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::site {

// Lengths in cells. The first three add up to that of the path; what is unknown counts as neither of the other two.
struct Surface {
    double ways = 0;
    double off_ways = 0;
    double unknown = 0;  // free only because somebody wants it so
    // Near water, on ways or off them; empty if cells are too fine to look for it.
    std::optional<double> near_water = 0;

    Surface& operator+=(const Surface& other);
    friend bool operator==(const Surface&, const Surface&) = default;
};

// A cell is near water if its centre is no farther from a cell of water.
inline constexpr double near_water_metres = 5;

// "1180 m on ways, 64 m off ways; 40 m within 5 m of water"
std::string surface_text(const Surface& surface, double cell_size);

class SurfaceMap {
  public:
    // Map and annotations must outlive it. `cell_size`: metres. REQUIRES: annotations.ways is not empty.
    SurfaceMap(const Map& map, const Annotations& annotations, double cell_size);

    // Of a path that is straight from point to point. On the line between two cells it is in both: it counts as unknown
    // if either is, else as a way if either is. Outside of the map there are no ways. O(cells of the path).
    Surface along(std::span<const Point> path) const;

  private:
    bool is_unknown(Cell cell) const;
    bool is_near_water(Cell cell) const;

    const Map& map_;
    const Annotations& annotations_;
    std::vector<bool> unknown_obstacles_;
    bool looks_for_water_;
    std::vector<Cell> around_;  // steps from a cell to those that are near it
};

}  // namespace waybreaker::site

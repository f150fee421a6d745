// Cells and ids: the words everything else is written in.
//
// x grows right, y grows down, (0, 0) is the upper-left cell. The integer point (x, y) is the centre of cell (x, y),
// its corners lie at +-0.5. Lengths are in cells.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace waybreaker {

struct Cell {
    int x = 0;
    int y = 0;
    friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
};

// Euclidean distance between two cell centres, in cells.
inline double distance(Cell a, Cell b) {
    const double dx = a.x - b.x;
    const double dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
}

// A point in cell units; a cell stands for its centre.
struct Point {
    double x = 0;
    double y = 0;
    constexpr Point() = default;
    constexpr Point(double px, double py) : x(px), y(py) {}
    constexpr Point(Cell c) : x(c.x), y(c.y) {}
    friend constexpr bool operator==(const Point&, const Point&) = default;
};

inline double distance(Point a, Point b) {
    const double dx = a.x - b.x;
    const double dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
}

// Smallest box of cells that holds something; both corners belong to it.
struct Box {
    Cell min;
    Cell max;
    friend constexpr bool operator==(const Box&, const Box&) = default;
};

// An obstacle of a map. Ids start at 1, in the order of a row-by-row scan; 0 means "no obstacle here".
struct ObstacleId {
    std::uint32_t value = 0;
    friend constexpr auto operator<=>(ObstacleId, ObstacleId) = default;
    explicit constexpr operator bool() const { return value != 0; }
};

}  // namespace waybreaker

// Lattice: the plane in half cells, where both bodies' turning points are integers.
//
// Cell (x, y) has its centre at (2x, 2y). An obstacle grown by the body is the union of the open boxes around its
// cells' centres with half side `reach`: 2 for the unit square, whose path bends at the boxes' corners, the cell
// centres; 1 for the point, where boxes are the cells themselves. For wider bodies the cells are those of a map that
// was grown before (regions.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdint>
#include <limits>

#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/cell.hpp"

namespace waybreaker::crossing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Vertex {
    int x = 0;
    int y = 0;
    friend constexpr bool operator==(Vertex, Vertex) = default;
};

// A direction or difference of vertices.
struct Step {
    int x = 0;
    int y = 0;
    friend constexpr bool operator==(Step, Step) = default;
    constexpr Step operator-() const { return {-x, -y}; }
};

constexpr Step operator-(Vertex a, Vertex b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vertex operator+(Vertex v, Step s) {
    return {v.x + s.x, v.y + s.y};
}
constexpr Cell operator+(Cell c, Step s) {
    return {c.x + s.x, c.y + s.y};
}
constexpr Step operator+(Step a, Step b) {
    return {a.x + b.x, a.y + b.y};
}

// > 0: b points to the right of a on a screen (y down).
constexpr std::int64_t cross(Step a, Step b) {
    return std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
}
constexpr int sign(std::int64_t value) {
    return (value > 0) - (value < 0);
}

inline double length(Step s) {
    return std::sqrt(double(s.x) * s.x + double(s.y) * s.y);
}

constexpr Vertex centre(Cell c) {
    return {2 * c.x, 2 * c.y};
}
// Half the side of the box around a cell that the body's centre cannot enter, in half cells.
inline int reach_of(const CrossingOptions& options) {
    return options.relaxed || options.body.is_point() ? 1 : 2;
}

constexpr std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    return a / b - (a % b < 0);
}

// A corner of an obstacle that a path can bend around: the obstacle fills the quadrant that `quadrant` (signs of x and
// y) points to. The direction in which it leaves a path that arrives along `arriving` and slides around the corner as
// far as it can; (0, 0) if the path does not touch the corner in passing.
constexpr Step sliding(Step arriving, Step quadrant) {
    const int x = sign(arriving.x) * quadrant.x;
    const int y = sign(arriving.y) * quadrant.y;
    if (x >= 0 && y < 0) return {quadrant.x, 0};
    if (y >= 0 && x < 0) return {0, quadrant.y};
    return {0, 0};
}

// The least box that holds some vertices, grown by the reach of their cells.
class Bounds {
  public:
    void add(Vertex v) {
        min_ = {std::min(min_.x, v.x - 2), std::min(min_.y, v.y - 2)};
        max_ = {std::max(max_.x, v.x + 2), std::max(max_.y, v.y + 2)};
    }
    bool hold(Vertex v) const { return v.x >= min_.x && v.x <= max_.x && v.y >= min_.y && v.y <= max_.y; }

  private:
    Vertex min_{INT_MAX, INT_MAX};
    Vertex max_{INT_MIN, INT_MIN};
};

inline constexpr std::array<Step, 4> quadrants{Step{1, 1}, Step{-1, 1}, Step{-1, -1}, Step{1, -1}};

}  // namespace waybreaker::crossing

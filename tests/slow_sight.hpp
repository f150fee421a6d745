// Line of sight, slow and obvious: every cell near the segment is tested against the definition (contract of
// waybreaker/body.hpp), one by one and in integers. Shares nothing with src/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "plain_map.hpp"
#include "waybreaker/body.hpp"

namespace waybreaker::slow {

// Twice the coordinates of cell.hpp, so that cell corners are integers too.
struct Point {
    std::int64_t x;
    std::int64_t y;
};

inline Point centre(Cell c) {
    return {2 * c.x, 2 * c.y};
}
inline std::array<Point, 4> corners(Cell c) {
    return {{{2 * c.x - 1, 2 * c.y - 1},
             {2 * c.x + 1, 2 * c.y - 1},
             {2 * c.x + 1, 2 * c.y + 1},
             {2 * c.x - 1, 2 * c.y + 1}}};
}

inline std::int64_t cross(Point o, Point a, Point b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}
inline std::int64_t dot(Point o, Point a, Point b) {
    return (a.x - o.x) * (b.x - o.x) + (a.y - o.y) * (b.y - o.y);
}

// Whether p is nearer to the segment a-b than `radius`, in thousandths of a cell.
inline bool nearer(Point p, Point a, Point b, std::int64_t radius) {
    const std::int64_t limit =
        4 * radius * radius;  // of the squared distance in our doubled coordinates, in millionths
    if (dot(a, b, p) <= 0) return dot(a, p, p) * 1'000'000 < limit;
    if (dot(b, a, p) <= 0) return dot(b, p, p) * 1'000'000 < limit;
    return cross(a, b, p) * cross(a, b, p) * 1'000'000 < limit * dot(a, b, b);
}

// Whether the open disc of that radius, on its way from a to b, meets the closed square of a cell: whether square and
// segment are nearer than the radius. Two convex shapes apart are nearest at a corner of one of them.
inline bool disc_meets(Cell from, Cell to, std::int64_t radius, Cell square) {
    const Point a = centre(from);
    const Point b = centre(to);
    const std::array<Point, 4> ring = corners(square);
    for (std::size_t i = 0; i < 4; ++i) {
        const Point p = ring[i];
        const Point q = ring[(i + 1) % 4];
        if (nearer(p, a, b, radius) || nearer(a, p, q, radius) || nearer(b, p, q, radius)) return true;
        // The segment crosses this side of the square.
        if (cross(a, b, p) * cross(a, b, q) < 0 && cross(p, q, a) * cross(p, q, b) < 0) return true;
    }
    return from == square || to == square;
}

// Whether the segment meets the inside of a cell: it does unless a line parallel to a side, or the segment's own line,
// parts them.
inline bool point_meets(Cell from, Cell to, Cell square) {
    const Point a = centre(from);
    const Point b = centre(to);
    const Point c = centre(square);
    if (std::max(a.x, b.x) <= c.x - 1 || std::min(a.x, b.x) >= c.x + 1) return false;
    if (std::max(a.y, b.y) <= c.y - 1 || std::min(a.y, b.y) >= c.y + 1) return false;
    if (from == to) return true;
    int left = 0;
    int right = 0;
    for (const Point p : corners(square)) {
        left += cross(a, b, p) > 0 ? 1 : 0;
        right += cross(a, b, p) < 0 ? 1 : 0;
    }
    return left > 0 && right > 0;
}

// Whether the segment runs exactly through the lower right corner of a cell, with two diagonally opposite blocked cells
// around it.
inline bool pinched(const PlainMap& map, Cell from, Cell to, Cell at) {
    const Point corner = corners(at)[2];
    const Point a = centre(from);
    const Point b = centre(to);
    if (cross(a, b, corner) != 0 || dot(a, b, corner) <= 0 || dot(b, a, corner) <= 0) return false;
    const Cell right{at.x + 1, at.y};
    const Cell below{at.x, at.y + 1};
    const Cell across{at.x + 1, at.y + 1};
    return (map.blocked(at) && map.blocked(across)) || (map.blocked(right) && map.blocked(below));
}

// Whether the agent can move straight between two cells; whether it can stand on one, if both are the same.
inline bool sees(const PlainMap& map, Cell from, Cell to, const Body& body = {}) {
    const bool disc = body.corners == Corners::none;
    const auto radius = std::int64_t(std::llround(body.radius * 1000));
    const int margin = disc ? int(body.radius) + 2 : 1;
    for (int y = std::min(from.y, to.y) - margin; y <= std::max(from.y, to.y) + margin; ++y) {
        for (int x = std::min(from.x, to.x) - margin; x <= std::max(from.x, to.x) + margin; ++x) {
            const Cell c{x, y};
            if (body.corners == Corners::cut && pinched(map, from, to, c)) return false;
            if (map.blocked(c) && (disc ? disc_meets(from, to, radius, c) : point_meets(from, to, c))) return false;
        }
    }
    return true;
}

}  // namespace waybreaker::slow

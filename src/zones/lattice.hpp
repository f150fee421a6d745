// The lattice on which zones are judged: integer points, so that every decision is exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>

#include "waybreaker/zone.hpp"

namespace waybreaker::zones {

// In steps of 1 / (2 * zone_steps) of a cell: those of corners are even, so that the middle of two is a spot as well.
// Zone corners are below 2^29, differences below 2^30, and sums of two products of them below 2^61.
inline constexpr std::int64_t steps = 2 * std::int64_t{zone_steps};

struct Spot {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend constexpr auto operator<=>(const Spot&, const Spot&) = default;
};

inline Spot spot_of(Point p) {
    return {2 * std::llround(p.x * zone_steps), 2 * std::llround(p.y * zone_steps)};
}
inline Point point_of(Spot s) {
    return {double(s.x) / double(steps), double(s.y) / double(steps)};
}
inline Spot middle(Spot a, Spot b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

// Above 0 where c lies to the left of the line from a to b, if y grew up.
inline std::int64_t turn(Spot a, Spot b, Spot c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
inline int sign(std::int64_t value) {
    return int(value > 0) - int(value < 0);
}
// Of a point on the line through a and b: whether it lies between them, or is one of them.
inline bool is_between(Spot a, Spot b, Spot c) {
    return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
           c.y <= std::max(a.y, b.y);
}
inline bool is_on(Spot a, Spot b, Spot c) {
    return turn(a, b, c) == 0 && is_between(a, b, c);
}
// Whether each of two segments passes through the other, from one side to the other.
inline bool cross(Spot a, Spot b, Spot c, Spot d) {
    return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

}  // namespace waybreaker::zones

// What is done with points of lines.
#pragma once

#include <ogr_geometry.h>

#include <cmath>
#include <utility>

namespace waybreaker::city {

// Corners that a quarter of a circle has where points and lines are made areas of.
inline constexpr int quarter_circle = 4;

using Place = std::pair<long long, long long>;

// By which lines and points that share a node of the source know each other: to a centimetre.
inline Place place_at(const OGRPoint& point) {
    return {std::llround(point.getX() * 100), std::llround(point.getY() * 100)};
}

}  // namespace waybreaker::city

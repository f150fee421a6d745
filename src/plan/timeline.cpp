#include "plan/timeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace waybreaker {
namespace {

// Part of a move, as shares of it: [enter, leave], empty unless enter < leave.
struct Span {
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
};

// A move from (x, y), relative to the centre of a cell, by (dx, dy).
struct Move {
    double x, y, dx, dy;
};

// While |position| < half along one axis.
Span inside_slab(double position, double velocity, double half) {
    if (velocity == 0) return std::abs(position) < half ? Span{} : Span{1, 0};
    const double a = (-half - position) / velocity;
    const double b = (half - position) / velocity;
    return {std::min(a, b), std::max(a, b)};
}

Span inside_box(const Move& move, double half_x, double half_y) {
    const Span x = inside_slab(move.x, move.dx, half_x);
    const Span y = inside_slab(move.y, move.dy, half_y);
    return {std::max(x.enter, y.enter), std::min(x.leave, y.leave)};
}

Span inside_circle(const Move& move, double x, double y, double radius) {
    const double a = move.dx * move.dx + move.dy * move.dy;
    const double b = (move.x - x) * move.dx + (move.y - y) * move.dy;
    const double c = (move.x - x) * (move.x - x) + (move.y - y) * (move.y - y) - radius * radius;
    if (a == 0) return c < 0 ? Span{} : Span{1, 0};
    const double discriminant = b * b - a * c;
    if (discriminant <= 0) return {1, 0};
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

// The share of the move after which the disc meets the cell's square; infinity if it never does. The places where it
// does are the square grown by the radius: two boxes and a circle around each corner.
double touch(const Move& move, double radius) {
    const std::array<Span, 6> parts{inside_box(move, 0.5 + radius, 0.5),     inside_box(move, 0.5, 0.5 + radius),
                                    inside_circle(move, -0.5, -0.5, radius), inside_circle(move, 0.5, -0.5, radius),
                                    inside_circle(move, -0.5, 0.5, radius),  inside_circle(move, 0.5, 0.5, radius)};
    constexpr double rounding = 1e-9;
    double first = std::numeric_limits<double>::infinity();
    for (const Span& part : parts) {
        const double enter = std::max(part.enter, 0.0);
        if (enter + rounding < std::min(part.leave, 1.0)) first = std::min(first, enter);
    }
    return first;
}

}  // namespace

double path_length(std::span<const Point> path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    return length;
}

std::vector<Waypoint> timed(std::span<const Point> path, double speed) {
    std::vector<Waypoint> points;
    double driven = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) driven += distance(path[i - 1], path[i]);
        points.push_back({path[i].x, path[i].y, driven / speed});
    }
    return points;
}

std::optional<double> first_touch(const Map& map, ObstacleId obstacle, std::span<const Waypoint> path, double radius) {
    const Box& bounds = map.obstacle(obstacle).bounds;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        const auto low = [radius](double p, double q) { return int(std::floor(std::min(p, q) - radius)); };
        const auto high = [radius](double p, double q) { return int(std::ceil(std::max(p, q) + radius)); };
        const Cell first{std::max(bounds.min.x, low(a.x, b.x)), std::max(bounds.min.y, low(a.y, b.y))};
        const Cell last{std::min(bounds.max.x, high(a.x, b.x)), std::min(bounds.max.y, high(a.y, b.y))};
        double share = std::numeric_limits<double>::infinity();
        for (Cell c = first; c.y <= last.y; ++c.y) {
            for (c.x = first.x; c.x <= last.x; ++c.x) {
                if (map.obstacle_at(c) != obstacle) continue;
                share = std::min(share, touch({a.x - c.x, a.y - c.y, b.x - a.x, b.y - a.y}, radius));
            }
        }
        if (share <= 1) return a.t + share * (b.t - a.t);
    }
    return std::nullopt;
}

}  // namespace waybreaker

#include "model/timeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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
    if (a == 0) return distance(Point(move.x, move.y), Point(x, y)) < radius ? Span{} : Span{1, 0};
    // By the distance to the line. In thousandths, in which radii are whole, it is exact where the move grazes the
    // circle.
    const double aside = (move.x - x) * move.dy - (move.y - y) * move.dx;
    const double thousandths = 1000 * radius;
    if (a * thousandths * thousandths <= 1e6 * aside * aside) return {1, 0};
    const double root = std::sqrt(std::max(a * radius * radius - aside * aside, 0.0));
    return {(-b - root) / a, (-b + root) / a};
}

// How deep the disc is in the cell's square after a share of the move, in cells. That of a move that grazes it from
// between two vertices is rounding.
double depth_in(const Move& move, double share, double radius) {
    const double x = std::abs(move.x + share * move.dx) - 0.5;
    const double y = std::abs(move.y + share * move.dy) - 0.5;
    if (x <= 0 && y <= 0) return radius - std::max(x, y);
    return radius - std::hypot(std::max(x, 0.0), std::max(y, 0.0));
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
        const double leave = std::min(part.leave, 1.0);
        if (enter + rounding < leave && depth_in(move, (enter + leave) / 2, radius) > rounding)
            first = std::min(first, enter);
    }
    return first;
}

// The share of a move from a to b after which the disc touches a cell of the obstacle; infinity if it never does. Only
// cells near the move are tested: rows in the order the move crosses them, and the cells of a row in its direction.
double first_touch(const Map& map, const Obstacle& obstacle, const Waypoint& a, const Waypoint& b, double radius) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double reach = 0.5 + radius;
    const auto limits = [reach](double p, double q, int least, int most) {
        return std::pair(std::max(int(std::floor(std::min(p, q) - reach)), least),
                         std::min(int(std::ceil(std::max(p, q) + reach)), most));
    };
    const auto [top, bottom] = limits(a.y, b.y, obstacle.bounds.min.y, obstacle.bounds.max.y);
    double first = std::numeric_limits<double>::infinity();
    for (int row = top; row <= bottom; ++row) {
        const int y = dy < 0 ? top + bottom - row : row;
        const Span near = inside_slab(a.y - y, dy, reach);
        const double enter = std::max(near.enter, 0.0);
        const double leave = std::min(near.leave, 1.0);
        if (enter >= first) break;
        if (enter > leave) continue;
        const auto [left, right] =
            limits(a.x + enter * dx, a.x + leave * dx, obstacle.bounds.min.x, obstacle.bounds.max.x);
        for (int column = left; column <= right; ++column) {
            const int x = dx < 0 ? left + right - column : column;
            if (inside_slab(a.x - x, dx, reach).enter >= first) break;
            if (map.obstacle_at({x, y}) == obstacle.id)
                first = std::min(first, touch({a.x - x, a.y - y, dx, dy}, radius));
        }
    }
    return first;
}

// The same for a point that moves along the side that a cell of the obstacle shares with another blocked cell, or with
// the outside of the map: it is inside neither, and touches both.
double first_between_walls(const Map& map, ObstacleId obstacle, const Waypoint& a, const Waypoint& b) {
    const bool upright = a.x == b.x && a.x != std::floor(a.x);
    const bool level = a.y == b.y && a.y != std::floor(a.y);
    if (upright == level) return std::numeric_limits<double>::infinity();
    const int beside = int(std::floor(upright ? a.x : a.y));
    const double from = upright ? a.y : a.x;
    const double to = upright ? b.y : b.x;
    const int steps = int(std::abs(to - from));
    for (int step = 0; step < steps; ++step) {
        const int along = int(from + (to > from ? step + 0.5 : -step - 0.5));
        const Cell one = upright ? Cell{beside, along} : Cell{along, beside};
        const Cell two = upright ? Cell{beside + 1, along} : Cell{along, beside + 1};
        const auto is_its = [&](Cell c) { return map.grid().contains(c) && map.obstacle_at(c) == obstacle; };
        if (map.grid().blocked(one) && map.grid().blocked(two) && (is_its(one) || is_its(two))) {
            return double(step) / steps;
        }
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace

double path_length(std::span<const Point> path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    return length;
}

double standing_radius(const Body& body) {
    constexpr double hair = 1e-5;
    return body.passes() == Corners::cut ? hair : body.reach();
}

std::vector<Waypoint> timed(std::span<const Point> path, double speed, double from) {
    std::vector<Waypoint> points;
    double driven = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) driven += distance(path[i - 1], path[i]);
        points.push_back({path[i].x, path[i].y, from + driven / speed});
    }
    return points;
}

std::vector<Point> places(std::span<const Waypoint> path) {
    std::vector<Point> places;
    for (const Waypoint& at : path) {
        if (places.empty() || places.back() != Point(at.x, at.y)) places.emplace_back(at.x, at.y);
    }
    return places;
}

std::vector<Wait> stands(const Itinerary& agent) {
    std::vector<Wait> waits;
    for (std::size_t i = 1; i < agent.path.size(); ++i) {
        const Waypoint& a = agent.path[i - 1];
        const Waypoint& b = agent.path[i];
        if (a.x == b.x && a.y == b.y && a.t < b.t) waits.push_back({{a.x, a.y}, a.t, b.t});
    }
    return waits;
}

Point place_of(std::span<const Point> path, const Touch& touch) {
    const Point from = path[touch.move];
    const Point to = path[touch.move + 1];
    return {from.x + touch.share * (to.x - from.x), from.y + touch.share * (to.y - from.y)};
}

std::optional<Touch> first_touch_on(const Map& map, ObstacleId obstacle, std::span<const Waypoint> path,
                                    double radius) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        double share = first_touch(map, map.obstacle(obstacle), a, b, radius);
        if (radius == 0) share = std::min(share, first_between_walls(map, obstacle, a, b));
        if (share <= 1) return Touch{i - 1, share, a.t + share * (b.t - a.t)};
    }
    return std::nullopt;
}

std::optional<double> first_touch(const Map& map, ObstacleId obstacle, std::span<const Waypoint> path, double radius) {
    const std::optional<Touch> touch = first_touch_on(map, obstacle, path, radius);
    return touch ? std::optional(touch->time) : std::nullopt;
}

}  // namespace waybreaker

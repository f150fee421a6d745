#include "zones/stretches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "zones/cells.hpp"

namespace waybreaker::zones {
namespace {

// Radius of a vehicle that is a point.
constexpr double hair = 1e-6;

Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

template <class Visit>
void for_each_side(const std::vector<std::vector<Point>>& polygon, const Visit& visit) {
    for (const std::vector<Point>& ring : polygon) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
}

double from_side(Point p, Point a, Point b) {
    const Point side{b.x - a.x, b.y - a.y};
    const double square = side.x * side.x + side.y * side.y;
    const double along = square == 0 ? 0 : ((p.x - a.x) * side.x + (p.y - a.y) * side.y) / square;
    return distance(p, between(a, b, std::clamp(along, 0.0, 1.0)));
}

// The shares at which a coordinate is between two values.
std::optional<Stretch> within(double from, double to, double least, double most) {
    if (from == to) return least < from && from < most ? std::optional(Stretch{}) : std::nullopt;
    double first = (least - from) / (to - from);
    double last = (most - from) / (to - from);
    if (first > last) std::swap(first, last);
    first = std::max(first, 0.0);
    last = std::min(last, 1.0);
    return first < last ? std::optional(Stretch{first, last}) : std::nullopt;
}

std::optional<Stretch> in_box(Point a, Point b, Point least, Point most) {
    const auto x = within(a.x, b.x, least.x, most.x);
    const auto y = within(a.y, b.y, least.y, most.y);
    if (!x || !y) return std::nullopt;
    const Stretch both{std::max(x->from, y->from), std::min(x->to, y->to)};
    return both.from < both.to ? std::optional(both) : std::nullopt;
}

std::optional<Stretch> in_disc(Point a, Point b, Point centre, double radius) {
    const Point way{b.x - a.x, b.y - a.y};
    const Point away{a.x - centre.x, a.y - centre.y};
    const double square = way.x * way.x + way.y * way.y;
    const double apart = away.x * away.x + away.y * away.y - radius * radius;
    if (square == 0) return apart < 0 ? std::optional(Stretch{}) : std::nullopt;
    const double along = (way.x * away.x + way.y * away.y) / square;
    const double root = along * along - apart / square;
    if (root <= 0) return std::nullopt;
    const Stretch inside{std::max(-along - std::sqrt(root), 0.0), std::min(-along + std::sqrt(root), 1.0)};
    return inside.from < inside.to ? std::optional(inside) : std::nullopt;
}

// Where the centre of a disc is so near to a box: a convex shape of two boxes and four discs.
std::optional<Stretch> near_box(Point a, Point b, Point least, Point most, double radius) {
    const std::array<std::optional<Stretch>, 6> parts{
        in_box(a, b, {least.x - radius, least.y}, {most.x + radius, most.y}),
        in_box(a, b, {least.x, least.y - radius}, {most.x, most.y + radius}),
        in_disc(a, b, least, radius),
        in_disc(a, b, {most.x, least.y}, radius),
        in_disc(a, b, {least.x, most.y}, radius),
        in_disc(a, b, most, radius)};
    Stretch all{1, 0};
    for (const std::optional<Stretch>& part : parts) {
        if (part) all = {std::min(all.from, part->from), std::max(all.to, part->to)};
    }
    return all.from < all.to ? std::optional(all) : std::nullopt;
}

// In order; those that overlap are one.
std::vector<Stretch> joined(std::vector<Stretch> stretches) {
    std::ranges::sort(stretches, {}, &Stretch::from);
    std::vector<Stretch> apart;
    for (const Stretch& stretch : stretches) {
        if (apart.empty() || stretch.from > apart.back().to) {
            apart.push_back(stretch);
        } else {
            apart.back().to = std::max(apart.back().to, stretch.to);
        }
    }
    return apart;
}

}  // namespace

Closed::Closed(const Zone& zone, int width, int height) {
    if (zone.kind == ZoneKind::no_fly) {
        polygon_ = zone.polygon;
        return;
    }
    for (const Cell c : cells_in(zone, width, height)) {
        const bool goes_on = !runs_.empty() && runs_.back().most == Point(c.x - 0.5, c.y + 0.5);
        if (goes_on) {
            runs_.back().most.x = c.x + 0.5;
        } else {
            runs_.push_back({{c.x - 0.5, c.y - 0.5}, {c.x + 0.5, c.y + 0.5}});
        }
    }
}

std::vector<Stretch> Closed::stretches(Point a, Point b, double radius) const {
    if (!polygon_.empty()) return in_polygon(a, b);
    const double reach = std::max(radius - margin, hair);
    std::vector<Stretch> near;
    for (const Run& run : runs_) {
        if (const auto stretch = near_box(a, b, run.least, run.most, reach)) near.push_back(*stretch);
    }
    return joined(std::move(near));
}

// Between two sides that it crosses a move is inside as a whole, or outside.
std::vector<Stretch> Closed::in_polygon(Point a, Point b) const {
    if (a == b) return holds(a) && from_outline(a) > margin ? std::vector<Stretch>{{}} : std::vector<Stretch>{};
    std::vector<double> shares{0, 1};
    for_each_side(polygon_, [&](Point c, Point d) {
        const double across = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
        if (across == 0) return;
        const double share = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / across;
        if (share > 0 && share < 1) shares.push_back(share);
    });
    std::ranges::sort(shares);
    std::vector<Stretch> inside;
    for (std::size_t i = 1; i < shares.size(); ++i) {
        const Stretch part{shares[i - 1], shares[i]};
        if (part.from == part.to || is_along_outline(between(a, b, part.from), between(a, b, part.to))) continue;
        if (holds(between(a, b, (part.from + part.to) / 2))) inside.push_back(part);
    }
    return joined(std::move(inside));
}

bool Closed::holds(Point p) const {
    bool odd = false;
    for_each_side(polygon_, [&](Point a, Point b) {
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    });
    return odd;
}

double Closed::from_outline(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for_each_side(polygon_, [&](Point a, Point b) { least = std::min(least, from_side(p, a, b)); });
    return least;
}

// All between two places that are near to one side is.
bool Closed::is_along_outline(Point a, Point b) const {
    bool is_near = false;
    for_each_side(polygon_, [&](Point c, Point d) {
        is_near = is_near || (from_side(a, c, d) <= margin && from_side(b, c, d) <= margin);
    });
    return is_near;
}

}  // namespace waybreaker::zones

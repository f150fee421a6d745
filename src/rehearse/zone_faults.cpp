#include "rehearse/zone_faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace waybreaker::rehearsal {
namespace {

struct Side {
    Point from;
    Point to;
};

std::vector<Side> sides_of(const Zone& zone) {
    std::vector<Side> sides;
    for (const std::vector<Point>& ring : zone.polygon) {
        for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
    return sides;
}

double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}

double to_side(Point p, const Side& side) {
    const Point along = side.to - side.from;
    const Point there = p - side.from;
    const double square = along.x * along.x + along.y * along.y;
    const double share = square == 0 ? 0 : std::clamp((there.x * along.x + there.y * along.y) / square, 0.0, 1.0);
    return std::hypot(there.x - share * along.x, there.y - share * along.y);
}

// How deep inside; below 0 outside, as far as the outline is away. Sides above a place, to be inside, are odd.
double depth(const std::vector<Side>& sides, Point p) {
    double least = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (const Side& side : sides) {
        least = std::min(least, to_side(p, side));
        if ((side.from.x <= p.x) == (side.to.x <= p.x)) continue;
        const bool rises = side.from.x <= p.x;
        if ((cross(side.to - side.from, p - side.from) > 0) == rises) inside = !inside;
    }
    return inside ? least : -least;
}

// Whether a disc that moves from a to b reaches into a zone.
bool reaches_in(const std::vector<Side>& sides, Point a, Point b, double reach) {
    const Side way{a, b};
    return depth(sides, a) > -reach || std::ranges::any_of(sides, [&](const Side& side) {
               const bool meet =
                   cross(b - a, side.from - a) * cross(b - a, side.to - a) < 0 &&
                   cross(side.to - side.from, a - side.from) * cross(side.to - side.from, b - side.from) < 0;
               return meet || std::min({to_side(a, side), to_side(b, side), to_side(side.from, way),
                                        to_side(side.to, way)}) < reach;
           });
}

// Whether a point that moves from a to b comes deeper in than that. Depth changes by no more than the way between two
// places does: where the middle is far enough from being too deep, all of the way is. So it is where both ends are near
// to one side.
bool is_deeper(const std::vector<Side>& sides, Point a, Point b, double limit) {
    const auto is_along = [&](const Side& side) { return to_side(a, side) <= limit && to_side(b, side) <= limit; };
    if (std::ranges::any_of(sides, is_along)) return false;
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double half = distance(a, b) / 2;
    const double deep = depth(sides, middle);
    if (deep > limit) return true;
    if (deep + half <= limit || half < zone_touching / 2) return false;
    return is_deeper(sides, a, middle, limit) || is_deeper(sides, middle, b, limit);
}

bool is_in(const std::vector<Side>& sides, const Piece& piece, double radius) {
    const Point a(piece.from.x, piece.from.y);
    const Point b(piece.to.x, piece.to.y);
    const double reach = radius - zone_touching;
    return reach > 0 ? reaches_in(sides, a, b, reach) : is_deeper(sides, a, b, zone_touching);
}

// Whether it is in a zone, or so near to it that its body reaches into a cell that the zone reaches into: planning
// keeps vehicles out of those cells, but for who stands in them when the zone begins.
bool is_beside(const std::vector<Side>& sides, const Waypoint& p, const Trail& trail) {
    const double cell = trail.kind == AgentKind::ground ? std::sqrt(2.0) : 0;
    return is_in(sides, {p, p}, trail.radius + cell);
}

Piece stand_at(const Piece& piece, double time) {
    const Point at = piece.at(time);
    return {{at.x, at.y, time}, {at.x, at.y, time}};
}

// The parts of pieces for which a zone holds.
std::vector<Piece> parts_within(const Zone& zone, const std::vector<Piece>& pieces) {
    if (!zone.has_window()) return pieces;
    std::vector<Piece> parts;
    for (const Piece& piece : pieces) {
        if (piece.to.t <= zone.from || piece.from.t >= zone.until) continue;
        parts.push_back({stand_at(piece, std::max(piece.from.t, zone.from)).from,
                         stand_at(piece, std::min(piece.to.t, zone.until)).from});
    }
    return parts;
}

bool holds_for(const Zone& zone, const Trail& trail) {
    if ((zone.kind == ZoneKind::no_fly) != (trail.kind == AgentKind::air)) return false;
    return zone.agents.empty() || std::ranges::find(zone.agents, trail.agent) != zone.agents.end();
}

// Who is where a zone begins is excused until it is out.
void add_faults(const Zone& zone, std::size_t number, const Trail& trail, ZoneFaults& faults) {
    const std::vector<Side> sides = sides_of(zone);
    bool excused = false;
    for (const Piece& part : parts_within(zone, trail.pieces)) {
        if (zone.from > 0 && part.from.t == zone.from) excused = is_beside(sides, part.from, trail);
        const bool there = is_in(sides, part, trail.radius);
        if (there && !excused) {
            faults.fault = trail.agent + " is in " + name_of(zone, number) + " between " + std::to_string(part.from.t) +
                           " and " + std::to_string(part.to.t);
            return;
        }
        if (there) faults.caught = true;
        excused = excused && is_beside(sides, part.to, trail);
    }
}

}  // namespace

ZoneFaults zone_faults(std::span<const Zone> zones, const Trail& trail) {
    ZoneFaults faults;
    for (std::size_t i = 0; i < zones.size() && !faults.fault; ++i) {
        if (holds_for(zones[i], trail)) add_faults(zones[i], i + 1, trail, faults);
    }
    return faults;
}

}  // namespace waybreaker::rehearsal

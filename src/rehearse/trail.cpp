#include "rehearse/trail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waybreaker::rehearsal {
namespace {

constexpr double half_cell = 0.5;

double to_square(Point p, Point centre) {
    const double dx = std::max(std::abs(p.x - centre.x) - half_cell, 0.0);
    const double dy = std::max(std::abs(p.y - centre.y) - half_cell, 0.0);
    return std::hypot(dx, dy);
}

double to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double share = square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(a.x + share * dx - p.x, a.y + share * dy - p.y);
}

Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// The shares of a segment that lie in a square of that half side, without its border; empty if none do.
struct Span {
    double from = 0;
    double to = 1;
};
std::optional<Span> inside(Point a, Point b, Point centre, double half_side) {
    Span span;
    const auto cut = [&](double start, double end, double middle) {
        const double low = middle - half_side - start;
        const double high = middle + half_side - start;
        const double way = end - start;
        if (way == 0) return low < 0 && 0 < high;
        span.from = std::max(span.from, std::min(low / way, high / way));
        span.to = std::min(span.to, std::max(low / way, high / way));
        return true;
    };
    if (!cut(a.x, b.x, centre.x) || !cut(a.y, b.y, centre.y)) return std::nullopt;
    const bool stands = a == b;
    if (stands ? span.from > span.to : span.from >= span.to) return std::nullopt;
    return span;
}

// Of a way from a to b: how near it comes to a cell.
double distance_to(Cell cell, Point a, Point b) {
    const Point centre = cell;
    if (inside(a, b, centre, half_cell)) return 0;
    double least = std::min(to_square(a, centre), to_square(b, centre));
    for (const double dx : {-half_cell, half_cell}) {
        for (const double dy : {-half_cell, half_cell}) {
            least = std::min(least, to_segment({centre.x + dx, centre.y + dy}, a, b));
        }
    }
    return least;
}

// Whether a body on its way from a to b overlaps a cell. A point does inside it.
bool overlaps(Cell cell, Point a, Point b, double radius) {
    if (radius > 0) return distance_to(cell, a, b) < radius - touching;
    return inside(a, b, cell, half_cell - touching).has_value();
}

// Calls `visit` for each cell that a body may come near on its way, until that says true.
template <class Visit>
bool any_cell_near(const Map& map, Point a, Point b, double radius, const Visit& visit) {
    const double reach = radius + half_cell + touching;
    const auto first_row = int(std::ceil(std::min(a.y, b.y) - reach));
    const auto last_row = int(std::floor(std::max(a.y, b.y) + reach));
    for (int y = std::max(first_row, 0); y <= std::min(last_row, map.height() - 1); ++y) {
        // The part of the way from which the row can be reached.
        double low = 0;
        double high = 1;
        if (a.y != b.y) {
            const double one = (y - reach - a.y) / (b.y - a.y);
            const double other = (y + reach - a.y) / (b.y - a.y);
            low = std::clamp(std::min(one, other), 0.0, 1.0);
            high = std::clamp(std::max(one, other), 0.0, 1.0);
        }
        const double x1 = between(a, b, low).x;
        const double x2 = between(a, b, high).x;
        const auto first = std::max(int(std::ceil(std::min(x1, x2) - reach)), 0);
        const auto last = std::min(int(std::floor(std::max(x1, x2) + reach)), map.width() - 1);
        for (int x = first; x <= last; ++x) {
            if (visit(Cell{x, y})) return true;
        }
    }
    return false;
}

// The least distance of two bodies while both are on these pieces.
double least_distance(const Piece& a, const Piece& b) {
    const double from = std::max(a.from.t, b.from.t);
    const double to = std::min(a.to.t, b.to.t);
    const Point a1 = a.at(from);
    const Point a2 = a.at(to);
    const Point b1 = b.at(from);
    const Point b2 = b.at(to);
    return to_segment({0, 0}, {a1.x - b1.x, a1.y - b1.y}, {a2.x - b2.x, a2.y - b2.y});
}

bool overlap(const Trail& a, const Trail& b, double separation) {
    if (a.radius == 0 && b.radius == 0 && separation == 0) return false;
    const double room = a.radius + b.radius + separation - touching;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.pieces.size() && j < b.pieces.size()) {
        const Piece& p = a.pieces[i];
        const Piece& q = b.pieces[j];
        if (std::max(p.from.t, q.from.t) <= std::min(p.to.t, q.to.t) && least_distance(p, q) < room) return true;
        if (p.to.t < q.to.t) {
            ++i;
        } else {
            ++j;
        }
    }
    return false;
}

std::string as_text(Point p) {
    return std::to_string(p.x) + "," + std::to_string(p.y);
}

class Ground {
  public:
    Ground(const Map& map, const Events& events)
        : map_(map), events_(events), opens_(map.obstacles().size() + 1, std::numeric_limits<double>::infinity()) {
        for (const TimedOpening& opening : events.opened) {
            // What was found has ids of its own, and is not opened.
            if (opening.obstacle.value >= opens_.size()) continue;
            double& opens = opens_[opening.obstacle.value];
            opens = std::min(opens, opening.at);
        }
    }

    // What a vehicle drives into on that piece; empty if nothing.
    std::string fault(const Trail& vehicle, const Piece& piece) const {
        std::string fault;
        const Point a(piece.from.x, piece.from.y);
        const Point b(piece.to.x, piece.to.y);
        any_cell_near(map_, a, b, vehicle.radius, [&](Cell cell) {
            const ObstacleId id = map_.obstacle_at(cell);
            if (!id) return false;
            const double opens = opens_[id.value];
            if (opens <= piece.from.t) return false;
            const Point end = opens < piece.to.t ? piece.at(opens) : b;
            if (!overlaps(cell, a, end, vehicle.radius)) return false;
            fault = vehicle.agent + " is in obstacle " + std::to_string(id.value) + ", which stands, between " +
                    as_text(a) + " at " + std::to_string(piece.from.t) + " and " + as_text(end) + " at " +
                    std::to_string(std::min(opens, piece.to.t));
            return true;
        });
        for (const Events::Rubble& rubble : events_.rubble) {
            if (!fault.empty() || rubble.since >= piece.to.t) continue;
            const Point begin = rubble.since > piece.from.t ? piece.at(rubble.since) : a;
            const auto hit = [&](Cell cell) { return overlaps(cell, begin, b, vehicle.radius); };
            if (std::ranges::any_of(rubble.cells, hit))
                fault = vehicle.agent + " is in a blocked street between " + as_text(begin) + " and " + as_text(b) +
                        " at " + std::to_string(piece.to.t);
        }
        return fault;
    }

  private:
    const Map& map_;
    const Events& events_;
    std::vector<double> opens_;
};

}  // namespace

Point Piece::at(double time) const {
    if (time >= to.t || to.t <= from.t) return {to.x, to.y};
    if (time <= from.t) return {from.x, from.y};
    return between({from.x, from.y}, {to.x, to.y}, (time - from.t) / (to.t - from.t));
}

void Trail::add(Point at, double time) {
    if (pieces.empty()) {
        pieces.push_back({{at.x, at.y, time}, {at.x, at.y, time}});
        return;
    }
    Piece& last = pieces.back();
    const auto is_at = [&](const Waypoint& p) { return p.x == at.x && p.y == at.y; };
    if (is_at(last.from) && is_at(last.to)) {
        last.to.t = time;
    } else if (time > last.to.t || !is_at(last.to)) {
        pieces.push_back({last.to, {at.x, at.y, time}});
    }
}

std::optional<double> first_overlap(const Map& map, ObstacleId obstacle, Point a, Point b, double radius) {
    const double length = distance(a, b);
    std::optional<double> first;
    any_cell_near(map, a, b, radius, [&](Cell cell) {
        if (map.obstacle_at(cell) != obstacle || !overlaps(cell, a, b, radius)) return false;
        // Up to `legal` nothing overlaps, up to `illegal` something does.
        double legal = 0;
        double illegal = first.value_or(1);
        if (!overlaps(cell, a, between(a, b, illegal), radius)) return false;
        while (length * (illegal - legal) > touching / 4) {
            const double middle = (legal + illegal) / 2;
            (overlaps(cell, a, between(a, b, middle), radius) ? illegal : legal) = middle;
        }
        first = legal;
        return false;
    });
    return first;
}

bool overlaps(Cell cell, Point at, double radius) {
    return overlaps(cell, at, at, radius);
}

std::vector<std::string> faults_of(const Map& map, const Events& events, std::span<const Trail> vehicles,
                                   const std::optional<double>& separation, bool stay) {
    std::vector<std::string> faults;
    const Ground ground(map, events);
    double end = 0;
    for (const Trail& vehicle : vehicles) {
        end = std::max(end, vehicle.pieces.empty() ? 0 : vehicle.pieces.back().to.t);
        for (const Piece& piece : vehicle.pieces) {
            std::string fault = ground.fault(vehicle, piece);
            if (fault.empty()) continue;
            faults.push_back(std::move(fault));
            break;
        }
    }
    if (!separation) return faults;
    std::vector<Trail> trails(vehicles.begin(), vehicles.end());
    for (Trail& trail : trails) {
        if (stay && !trail.pieces.empty()) trail.add(Point(trail.pieces.back().to.x, trail.pieces.back().to.y), end);
    }
    for (std::size_t i = 0; i < trails.size(); ++i) {
        for (std::size_t j = i + 1; j < trails.size(); ++j) {
            if (overlap(trails[i], trails[j], *separation))
                faults.push_back(trails[i].agent + " and " + trails[j].agent + " overlap");
        }
    }
    return faults;
}

}  // namespace waybreaker::rehearsal

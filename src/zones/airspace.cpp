#include "waybreaker/airspace.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "zones/seen_memory.hpp"
#include "zones/shape.hpp"

namespace waybreaker {
namespace {

using zones::Edge;
using zones::Ring;
using zones::Shape;
using zones::Spot;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

class Airspace::Parts {
  public:
    Parts(std::vector<Shape> shapes, int width, int height) : shapes_(std::move(shapes)) {
        const Spot least = zones::spot_of({-0.5, -0.5});
        const Spot most = zones::spot_of({width - 0.5, height - 0.5});
        for (const Shape& shape : shapes_) {
            for (const Ring& ring : shape.rings) {
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Corner corner{ring[(i + ring.size() - 1) % ring.size()], ring[i],
                                        ring[(i + 1) % ring.size()]};
                    const bool convex = zones::turn(corner.before, corner.at, corner.after) > 0;
                    const bool on_map = corner.at.x >= least.x && corner.at.y >= least.y && corner.at.x <= most.x &&
                                        corner.at.y <= most.y;
                    if (convex && on_map && allows(corner.at)) corners_.push_back(corner);
                }
            }
        }
        for (const Shape& shape : shapes_) {
            least_ = {std::min(least_.x, shape.least.x), std::min(least_.y, shape.least.y)};
            most_ = {std::max(most_.x, shape.most.x), std::max(most_.y, shape.most.y)};
        }
        link();
        ways_.resize(corners_.size());
        asked_ = std::vector<Once>(corners_.size());
    }

    bool comes_near(Cell least, Cell most) const {
        return overlap(zones::spot_of({least.x - 0.5, least.y - 0.5}), zones::spot_of({most.x + 0.5, most.y + 0.5}),
                       least_, most_);
    }

    bool allows(Spot at) const {
        return std::ranges::none_of(shapes_, [at](const Shape& shape) { return shape.has_inside(at); });
    }

    // On the lattice. What rounding has put into a zone is beside it.
    Spot settled(Point p) const {
        const Spot spot = zones::spot_of(p);
        if (zones::point_of(spot) == p || allows(spot)) return spot;
        for (const std::int64_t dy : {0, -2, 2}) {
            for (const std::int64_t dx : {0, -2, 2}) {
                const Spot near{spot.x + dx, spot.y + dy};
                if (allows(near)) return near;
            }
        }
        return spot;
    }

    // A segment that crosses no edge is divided by the corners that it touches into parts that are each outside, inside
    // or along an edge as a whole, as the middle of the part is.
    bool is_clear(Spot a, Spot b) const {
        if (a == b) return true;
        const Spot least{std::min(a.x, b.x), std::min(a.y, b.y)};
        const Spot most{std::max(a.x, b.x), std::max(a.y, b.y)};
        std::vector<const Shape*> near;
        std::vector<Spot> ends;
        for (const Shape& shape : shapes_) {
            if (!overlap(least, most, shape.least, shape.most)) continue;
            for (const Edge& edge : shape.edges) {
                if (std::max(edge.from.x, edge.to.x) < least.x || std::min(edge.from.x, edge.to.x) > most.x ||
                    std::max(edge.from.y, edge.to.y) < least.y || std::min(edge.from.y, edge.to.y) > most.y)
                    continue;
                if (zones::cross(a, b, edge.from, edge.to)) return false;
                if (zones::is_on(a, b, edge.from)) ends.push_back(edge.from);
            }
            near.push_back(&shape);
        }
        if (near.empty()) return true;
        ends.push_back(a);
        ends.push_back(b);
        std::ranges::sort(ends);  // along the segment, from its lesser end
        for (std::size_t i = 1; i < ends.size(); ++i) {
            if (ends[i - 1] != ends[i] && is_closed(zones::middle(ends[i - 1], ends[i]), a, b, near)) return false;
        }
        return true;
    }

    double length(Point from, Point to) const { return best(from, to).length; }

    std::vector<Point> way(Point from, Point to) const {
        if (is_clear(settled(from), settled(to))) return {from, to};
        const bool turned = is_less(to, from);
        const Way way = best(from, to);
        if (way.length == infinity) return {};
        std::vector<Point> points{turned ? to : from};
        std::vector<Point> bends;
        for (std::size_t at = way.last; at != way.first; at = ways_[way.first].before[at])
            bends.push_back(zones::point_of(corners_[at].at));
        bends.push_back(zones::point_of(corners_[way.first].at));
        std::ranges::reverse(bends);
        bends.push_back(turned ? from : to);
        for (const Point p : bends) {
            if (p != points.back()) points.push_back(p);
        }
        if (turned) std::ranges::reverse(points);
        return points;
    }

  private:
    // Where a flight can bend.
    struct Corner {
        Spot before;  // along its ring
        Spot at;
        Spot after;
    };
    struct Link {
        std::size_t to;
        double length;
    };
    // From one corner to all.
    struct Ways {
        std::vector<double> length;
        std::vector<std::size_t> before;
    };
    // By way of a first and a last corner.
    struct Way {
        double length = infinity;
        std::size_t first = 0;
        std::size_t last = 0;
    };

    // Whether a flight from there that bends at the corner turns round the zone: the line is a tangent.
    static bool is_tangent(Spot from, const Corner& corner) {
        return zones::sign(zones::turn(from, corner.at, corner.before)) *
                   zones::sign(zones::turn(from, corner.at, corner.after)) >=
               0;
    }

    static bool overlap(Spot least, Spot most, Spot other_least, Spot other_most) {
        return least.x <= other_most.x && other_least.x <= most.x && least.y <= other_most.y && other_least.y <= most.y;
    }
    static bool is_less(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

    // Whether a spot on the segment from a to b lies inside a zone, or between two that touch there.
    static bool is_closed(Spot at, Spot a, Spot b, const std::vector<const Shape*>& near) {
        bool left = false;
        bool right = false;
        for (const Shape* shape : near) {
            if (!overlap(at, at, shape->least, shape->most)) continue;
            const Edge* edge = shape->edge_at(at);
            if (edge == nullptr) {
                if (shape->holds(at)) return true;
                continue;
            }
            const bool along =
                (edge->to.x - edge->from.x) * (b.x - a.x) + (edge->to.y - edge->from.y) * (b.y - a.y) > 0;
            (along ? left : right) = true;
        }
        return left && right;
    }

    void link() {
        links_.resize(corners_.size());
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (!is_tangent(corners_[i].at, corners_[j]) || !is_tangent(corners_[j].at, corners_[i])) continue;
                if (!is_clear(corners_[i].at, corners_[j].at)) continue;
                const double length = distance(zones::point_of(corners_[i].at), zones::point_of(corners_[j].at));
                links_[i].push_back({j, length});
                links_[j].push_back({i, length});
            }
        }
    }

    // Corners at which a flight from there may bend first.
    std::vector<std::size_t> seen_from(Spot at) const {
        return seen_.of(at, [&] {
            std::vector<std::size_t> seen;
            for (std::size_t i = 0; i < corners_.size(); ++i) {
                if (is_tangent(at, corners_[i]) && is_clear(at, corners_[i].at)) seen.push_back(i);
            }
            return seen;
        });
    }

    // Dijkstra 1959, when first asked for.
    const Ways& ways_from(std::size_t corner) const {
        asked_[corner].call([&] {
            Ways ways{std::vector<double>(corners_.size(), infinity),
                      std::vector<std::size_t>(corners_.size(), corner)};
            using Entry = std::pair<double, std::size_t>;
            std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
            ways.length[corner] = 0;
            open.emplace(0, corner);
            while (!open.empty()) {
                const auto [length, at] = open.top();
                open.pop();
                if (length > ways.length[at]) continue;
                for (const Link& link : links_[at]) {
                    const double longer = length + link.length;
                    if (longer >= ways.length[link.to]) continue;
                    ways.length[link.to] = longer;
                    ways.before[link.to] = at;
                    open.emplace(longer, link.to);
                }
            }
            ways_[corner] = std::move(ways);
        });
        return ways_[corner];
    }

    // From the lesser of two points to the other, so that it is the same in both directions. REQUIRES: it bends.
    Way best(Point from, Point to) const {
        if (is_less(to, from)) std::swap(from, to);
        const std::vector<std::size_t> lasts = seen_from(settled(to));
        Way best;
        if (lasts.empty()) return best;
        for (const std::size_t first : seen_from(settled(from))) {
            const double there = distance(from, zones::point_of(corners_[first].at));
            const Ways& ways = ways_from(first);
            for (const std::size_t last : lasts) {
                const double length = there + ways.length[last] + distance(zones::point_of(corners_[last].at), to);
                if (length < best.length) best = {length, first, last};
            }
        }
        return best;
    }

    std::vector<Shape> shapes_;
    Spot least_{INT64_MAX, INT64_MAX};  // of the box round all of them
    Spot most_{INT64_MIN, INT64_MIN};
    std::vector<Corner> corners_;
    std::vector<std::vector<Link>> links_;  // by corner
    // By corner, of those that were asked for.
    mutable std::vector<Ways> ways_;
    mutable std::vector<Once> asked_;
    mutable zones::SeenMemory seen_;
};

Airspace::Airspace(std::span<const Zone> zones, int width, int height) {
    std::vector<Shape> shapes;
    for (const Zone& zone : zones) {
        if (zone.kind == ZoneKind::no_fly) shapes.push_back(zones::shape_of(zone));
    }
    if (!shapes.empty()) parts_ = std::make_shared<const Parts>(std::move(shapes), width, height);
}

bool Airspace::allows(Point at) const {
    return is_open() || parts_->allows(parts_->settled(at));
}

bool Airspace::comes_near(Cell least, Cell most) const {
    return !is_open() && parts_->comes_near(least, most);
}

bool Airspace::is_clear_of_zones(Point a, Point b) const {
    return parts_->is_clear(parts_->settled(a), parts_->settled(b));
}

double Airspace::bent_length(Point a, Point b) const {
    return parts_->length(a, b);
}

std::vector<Point> Airspace::way(Point a, Point b) const {
    if (is_open()) return {a, b};
    return parts_->way(a, b);
}

std::vector<Point> Airspace::way_past(std::span<const Point> stops) const {
    std::vector<Point> all(stops.begin(), stops.begin() + std::ptrdiff_t(std::min<std::size_t>(stops.size(), 1)));
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const std::vector<Point> leg = way(stops[i - 1], stops[i]);
        if (!leg.empty()) all.insert(all.end(), leg.begin() + 1, leg.end());
    }
    return all;
}

}  // namespace waybreaker

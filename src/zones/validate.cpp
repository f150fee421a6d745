// Validates the polygons of zones.
#include <cmath>
#include <limits>
#include <string>

#include "core/range.hpp"
#include "zones/shape.hpp"

namespace waybreaker {
namespace {

using zones::Edge;
using zones::Ring;
using zones::Shape;
using zones::Spot;

std::string text(Spot spot) {
    const Point p = zones::point_of(spot);
    return number_text(p.x) + "," + number_text(p.y);
}

// Whether two edges have a point in common, beside the corner where the first ends and the second begins.
bool meet(const Edge& a, const Edge& b, bool a_ends_at_b, bool b_ends_at_a) {
    if (zones::cross(a.from, a.to, b.from, b.to)) return true;
    return (!b_ends_at_a && zones::is_on(b.from, b.to, a.from)) || (!a_ends_at_b && zones::is_on(b.from, b.to, a.to)) ||
           (!a_ends_at_b && zones::is_on(a.from, a.to, b.from)) || (!b_ends_at_a && zones::is_on(a.from, a.to, b.to));
}

class ZoneCheck {
  public:
    ZoneCheck(const Zone& zone, std::size_t number) : zone_(zone), who_(name_of(zone, number)) {}

    void run() const {
        require_enumerator(zone_.kind, ZoneKind::keep_out, "the kind of " + who_);
        require_window();
        if (zone_.polygon.empty()) refuse("has no polygon; give its corners");
        for (const std::vector<Point>& corners : zone_.polygon) {
            for (const Point p : corners) {
                const auto in_range = [](double value) { return std::abs(value) <= most_zone_coordinate; };
                if (!in_range(p.x) || !in_range(p.y))
                    refuse("has a corner at " + number_text(p.x) + "," + number_text(p.y) + ", farther than " +
                           number_text(most_zone_coordinate) + " cells away; is it for this map?");
            }
        }
        const Shape shape = zones::shape_of(zone_);
        for (const Ring& ring : shape.rings) {
            if (ring.size() < 3) refuse("has a polygon of fewer than three corners");
        }
        require_simple(shape);
        require_holes_inside(shape);
    }

  private:
    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(ErrorCode::contradiction, zone_.name, who_ + " " + why);
    }

    void require_window() const {
        if (!(zone_.from >= 0)) refuse("begins to hold at no time of a mission; let 'from' be 0 or more");
        if (!(zone_.from < zone_.until)) refuse("ends before it holds; let 'until' be after 'from'");
    }

    void require_simple(const Shape& shape) const {
        const std::vector<Edge>& edges = shape.edges;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                // Only edges of a simple ring that follow each other have a corner in common.
                const bool onward = follows(shape, i, j);
                const bool back = follows(shape, j, i);
                if (!meet(edges[i], edges[j], onward, back)) continue;
                refuse("has a polygon that crosses or touches itself near " + text(edges[i].from) +
                       "; draw it without, or as two zones");
            }
        }
    }

    // Whether edge `next` comes right after edge `edge` in a ring.
    static bool follows(const Shape& shape, std::size_t edge, std::size_t next) {
        std::size_t first = 0;
        for (const Ring& ring : shape.rings) {
            const std::size_t last = first + ring.size();
            if (edge < last) return next == (edge + 1 < last ? edge + 1 : first);
            first = last;
        }
        return false;
    }

    void require_holes_inside(const Shape& shape) const {
        for (std::size_t hole = 1; hole < shape.rings.size(); ++hole) {
            for (std::size_t ring = 0; ring < shape.rings.size(); ++ring) {
                if (ring == hole) continue;
                Zone alone;
                std::vector<Point>& corners = alone.polygon.emplace_back();
                for (const Spot spot : shape.rings[ring]) corners.push_back(zones::point_of(spot));
                const bool inside = zones::shape_of(alone).holds(shape.rings[hole].front());
                if (ring == 0 && !inside) refuse("has a hole outside its outline");
                if (ring > 0 && inside) refuse("has a hole in a hole; make what is in it a zone of its own");
            }
        }
    }

    const Zone& zone_;
    std::string who_;
};

}  // namespace

std::string name_of(const Zone& zone, std::size_t number) {
    std::string name = zone.name.empty() ? "zone " + std::to_string(number) : "the zone '" + zone.name + "'";
    if (!zone.has_window()) return name;
    const std::string from = zone.from > 0 ? "from " + number_text(zone.from) : "";
    const bool ends = zone.until < std::numeric_limits<double>::infinity();
    const std::string until = ends ? "until " + number_text(zone.until) : "";
    return name + " (" + from + (from.empty() || until.empty() ? "" : " ") + until + ")";
}

void validate(const Zone& zone, std::size_t number) {
    ZoneCheck(zone, number).run();
}

}  // namespace waybreaker

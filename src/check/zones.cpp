// Whether agents keep out of zones: held against the polygons themselves, in reals, with a hair's breadth to spare. By
// geometry of its own, without that of the planners.
#include <array>
#include <cmath>
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();
constexpr double spare = 1e-3;       // cells: what rounding of corners, and of points in files, may do
constexpr double spare_area = 1e-3;  // of a cell
constexpr int looks = 32;            // at a part of a leg that lies inside

using Corners = std::vector<Point>;

template <class Visit>
void for_each_edge(const Zone& zone, const Visit& visit) {
    for (const Corners& ring : zone.polygon) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    }
}

Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// Whether a ray from there to the right crosses an odd number of edges.
bool is_inside(const Zone& zone, Point p) {
    bool odd = false;
    for_each_edge(zone, [&](Point a, Point b) {
        if ((a.y > p.y) == (b.y > p.y)) return;
        if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    });
    return odd;
}

// The share of a segment at which it is nearest to a point.
double nearest_share(Point p, Point a, Point b) {
    const double square = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    return square == 0 ? 0 : std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square, 0.0, 1.0);
}

double away(Point p, Point a, Point b) {
    const Point near = between(a, b, nearest_share(p, a, b));
    return std::hypot(p.x - near.x, p.y - near.y);
}

// From the outline, however a point lies to it.
double from_outline(const Zone& zone, Point p) {
    double least = boundless;
    for_each_edge(zone, [&](Point a, Point b) { least = std::min(least, away(p, a, b)); });
    return least;
}

// Where a leg first lies so deep inside, as a share of it. Between two edges that it crosses it is inside as a whole,
// or outside.
std::optional<double> first_inside(const Zone& zone, Point a, Point b, double deep = spare) {
    std::vector<double> shares{0, 1};
    for_each_edge(zone, [&](Point c, Point d) {
        const double across = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
        const double share = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / across;
        if (share > 0 && share < 1) shares.push_back(share);  // not where they are parallel: no number is in between
    });
    std::sort(shares.begin(), shares.end());
    for (std::size_t i = 1; i < shares.size(); ++i) {
        if (!is_inside(zone, between(a, b, (shares[i - 1] + shares[i]) / 2))) continue;
        for (int look = 0; look <= looks; ++look) {
            const double share = shares[i - 1] + (shares[i] - shares[i - 1]) * look / looks;
            if (from_outline(zone, between(a, b, share)) > deep) return share;
        }
    }
    return std::nullopt;
}

// Where the disc of a body that moves along a leg reaches into a zone that its centre stays out of.
std::optional<double> first_touched(const Zone& zone, Point a, Point b, double radius) {
    std::optional<double> first;
    for_each_edge(zone, [&](Point c, Point d) {
        // Two segments that do not cross are nearest at an end of one of them.
        for (const double share : std::array<double, 4>{0, 1, nearest_share(c, a, b), nearest_share(d, a, b)}) {
            if (away(between(a, b, share), c, d) < radius - spare && (!first || share < *first)) first = share;
        }
    });
    return first;
}

// Of the polygon within a cell: what lies beyond each of its sides is cut off.
double area_within(Corners ring, Cell cell) {
    for (int side = 0; side < 4; ++side) {
        const auto depth = [&](Point p) {
            const double along = side % 2 == 0 ? p.x - cell.x : p.y - cell.y;
            return side < 2 ? along + 0.5 : 0.5 - along;
        };
        Corners cut;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i];
            const Point b = ring[(i + 1) % ring.size()];
            if (depth(a) >= 0) cut.push_back(a);
            if ((depth(a) >= 0) != (depth(b) >= 0)) cut.push_back(between(a, b, depth(a) / (depth(a) - depth(b))));
        }
        ring = std::move(cut);
    }
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point b = ring[(i + 1) % ring.size()];
        twice += (ring[i].x - cell.x) * (b.y - cell.y) - (ring[i].y - cell.y) * (b.x - cell.x);
    }
    return std::abs(twice) / 2;
}

bool covers(const Zone& zone, Cell cell) {
    double area = 0;
    for (std::size_t ring = 0; ring < zone.polygon.size(); ++ring)
        area += (ring == 0 ? 1 : -1) * area_within(zone.polygon[ring], cell);
    return area > spare_area;
}

class ZoneJudge {
  public:
    ZoneJudge(const Map& map, const Zone& zone, std::size_t number, const Terms& terms)
        : map_(map), zone_(zone), name_(zone.name.empty() ? "zone " + std::to_string(number) : "zone " + zone.name) {
        for_each_edge(zone, [this](Point a, Point) {
            least_ = {std::min(least_.x, a.x), std::min(least_.y, a.y)};
            most_ = {std::max(most_.x, a.x), std::max(most_.y, a.y)};
        });
        if (!zone.has_window()) return;
        from_ = zone.from + slack(terms, zone.from);
        until_ = std::isinf(zone.until) ? zone.until : zone.until - slack(terms, zone.until);
        if (zone.from > 0) when_ = " from " + text(zone.from);
        if (std::isfinite(zone.until)) when_ += " until " + text(zone.until);
    }

    // From that point of its path on.
    void judge_path(const Itinerary& agent, double radius, std::size_t first) {
        for (std::size_t i = first; i < agent.path.size(); ++i) {
            if (judge_leg(agent, radius, agent.path[i > first ? i - 1 : i], agent.path[i])) return;
        }
    }

    // The same while the zone holds, not before `earliest`. `stays`: at the end of its path, for ever.
    void judge_in_time(const Itinerary& agent, double radius, double earliest, bool stays) {
        std::vector<Waypoint> path = agent.path;
        if (stays && !path.empty()) path.push_back({path.back().x, path.back().y, boundless});
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double begin = std::max({path[i - 1].t, from_, earliest});
            const double end = std::min(path[i].t, until_);
            if (begin < end && judge_leg(agent, radius, at(path[i - 1], path[i], begin), at(path[i - 1], path[i], end)))
                return;
        }
    }

    // Nothing is removed that reaches into a zone for vehicles.
    void judge_removed(const Breach& breach) {
        if (!names_obstacle(map_, breach.obstacle)) return;
        const Box& box = map_.obstacle(breach.obstacle).bounds;
        const auto first = [](double least, int side) { return int(std::max(std::floor(least), double(side))); };
        const auto last = [](double most, int side) { return int(std::min(std::ceil(most), double(side))); };
        for (int y = first(least_.y, box.min.y); y <= last(most_.y, box.max.y); ++y) {
            for (int x = first(least_.x, box.min.x); x <= last(most_.x, box.max.x); ++x) {
                if (map_.obstacle_at({x, y}) != breach.obstacle || !covers(zone_, {x, y})) continue;
                found_.push_back({Rule::zone, text(breach.obstacle) + " is removed, and reaches into " + name_, "",
                                  breach.obstacle, Point(x, y), breach.cleared_at});
                return;
            }
        }
    }

    Violations found() { return std::move(found_); }

  private:
    // Between two points of a path, or where it stands.
    static Waypoint at(const Waypoint& a, const Waypoint& b, double time) {
        if (a.x == b.x && a.y == b.y) return {a.x, a.y, time};
        const Point place = between({a.x, a.y}, {b.x, b.y}, (time - a.t) / (b.t - a.t));
        return {place.x, place.y, time};
    }

    // Whether it is at fault on the way from one point to another.
    bool judge_leg(const Itinerary& agent, double radius, const Waypoint& from, const Waypoint& to) {
        const bool flies = agent.kind == AgentKind::air;
        const Point a(from.x, from.y);
        const Point b(to.x, to.y);
        if (!comes_near(a, b, radius)) return false;
        std::optional<double> share = first_inside(zone_, a, b);
        if (!share && radius > 0) share = first_touched(zone_, a, b, radius);
        if (!share) return false;
        found_.push_back({Rule::zone,
                          "the " + agent.id + " agent " + (flies ? "flies in " : "drives into ") + name_ +
                              (flies ? ", where nobody may" : ", which it has to keep out of") + when_,
                          agent.id,
                          {},
                          between(a, b, *share),
                          *share > 0 ? from.t + *share * (to.t - from.t) : from.t});
        return true;
    }

    bool comes_near(Point a, Point b, double radius) const {
        return std::max(a.x, b.x) + radius >= least_.x && std::min(a.x, b.x) - radius <= most_.x &&
               std::max(a.y, b.y) + radius >= least_.y && std::min(a.y, b.y) - radius <= most_.y;
    }

    const Map& map_;
    const Zone& zone_;
    std::string name_;
    std::string when_;          // it holds; empty: all the time
    double from_ = -boundless;  // it holds without doubt
    double until_ = boundless;
    Point least_{boundless, boundless};
    Point most_{-boundless, -boundless};
    Violations found_;
};

bool holds_for(const Zone& zone, const std::string& id, bool flies) {
    return flies == (zone.kind == ZoneKind::no_fly) &&
           (zone.agents.empty() || std::find(zone.agents.begin(), zone.agents.end(), id) != zone.agents.end());
}

// The point of its path from which on an agent has to keep out of zones: the first, but for an aircraft that was under
// way and found in a zone, which may fly out of it straight.
std::size_t first_judged(const Mission& mission, const Agent& agent, const Itinerary& planned) {
    if (agent.kind == AgentKind::ground || agent.approach.empty() || planned.path.empty()) return 0;
    const auto place = [&](std::size_t i) { return Point(planned.path[i].x, planned.path[i].y); };
    if (!flies_in_zone(mission, agent.id, place(0), place(0), planned.path[0].t)) return 0;
    std::size_t first = 0;
    while (first + 1 < planned.path.size() && place(first) == place(0)) ++first;
    return first;
}

}  // namespace

bool flies_in_zone(const Mission& mission, const std::string& aircraft, Point a, Point b, double time) {
    return std::any_of(mission.rules.zones.begin(), mission.rules.zones.end(), [&](const Zone& zone) {
        return zone.holds_at(time) && holds_for(zone, aircraft, true) && first_inside(zone, a, b).has_value();
    });
}

bool is_barred(const Mission& mission, const std::string& aircraft, Point a, Point b, double time) {
    return std::any_of(mission.rules.zones.begin(), mission.rules.zones.end(), [&](const Zone& zone) {
        return zone.holds_at(time) && holds_for(zone, aircraft, true) &&
               (first_inside(zone, a, b, 0) || first_touched(zone, a, b, 2 * spare));
    });
}

Violations judge_zones(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    Violations found;
    for (std::size_t i = 0; i < mission.rules.zones.size(); ++i) {
        const Zone& zone = mission.rules.zones[i];
        ZoneJudge judge(map, zone, i + 1, terms);
        bool holds = false;
        for (const Agent& agent : mission.agents) {
            const bool flies = agent.kind == AgentKind::air;
            if (!holds_for(zone, agent.id, flies)) continue;
            holds = true;
            for (const Itinerary& planned : plan.agents) {
                if (planned.id != agent.id) continue;
                const double radius = flies ? 0 : agent.body.reach();
                if (zone.has_window()) {
                    const bool stays = flies || mission.rules.at_goal == AtGoal::stay;
                    judge.judge_in_time(planned, radius, agent.approach.empty() ? 0 : agent.ready_at, stays);
                } else {
                    judge.judge_path(planned, radius, first_judged(mission, agent, planned));
                }
            }
        }
        if (holds && zone.kind == ZoneKind::keep_out && !zone.has_window()) {
            for (const Breach& breach : plan.breaches) judge.judge_removed(breach);
        }
        append(found, judge.found());
    }
    return found;
}

}  // namespace waybreaker::checker

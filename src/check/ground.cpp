// The ground agent's way: what it touches, and whether that stands at the moment.
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

// The ground agent's body in the judge's own terms.
struct Shape {
    std::int64_t radius = 0;        // thousandths of a cell; 0: a point
    bool bends_at_corners = false;  // of cells, beside their centres
    bool slips = true;              // between diagonal neighbours
};

Shape shape_of(const Body& body) {
    const auto radius = std::int64_t(std::llround(body.radius * 1000));
    return {.radius = body.corners == Corners::none ? radius : 0,
            .bends_at_corners = radius == 0,
            .slips = body.corners != Corners::cut};
}

std::optional<Vertex> vertex(const Waypoint& point, const Map& map, const Shape& body) {
    if (!(point.x >= -0.5 && point.y >= -0.5)) return std::nullopt;
    if (!(point.x <= map.width() - 0.5 && point.y <= map.height() - 0.5)) return std::nullopt;
    const Vertex v{std::llround(2 * point.x), std::llround(2 * point.y)};
    if (double(v.x) != 2 * point.x || double(v.y) != 2 * point.y) return std::nullopt;
    const bool is_centre = v.x % 2 == 0 && v.y % 2 == 0;
    const bool is_corner = v.x % 2 != 0 && v.y % 2 != 0;
    return is_centre || (is_corner && body.bends_at_corners) ? std::optional(v) : std::nullopt;
}

// The body does not reach beyond the map.
bool keeps_inside(Vertex v, const Map& map, const Shape& body) {
    const std::int64_t right = 2 * std::int64_t(map.width()) - 1 - v.x;
    const std::int64_t below = 2 * std::int64_t(map.height()) - 1 - v.y;
    return 500 * std::min({v.x + 1, v.y + 1, right, below}) >= body.radius;
}

class GroundJudge {
  public:
    GroundJudge(const Map& map, const Plan& plan, const Itinerary& ground, const Agent& asked, const Terms& terms)
        : map_(map),
          ground_(ground),
          terms_(terms),
          ready_at_(asked.ready_at),
          stops_on_moves_(asked.own_breaches > 0),
          body_(shape_of(terms.body)),
          standing_(standing_until(map, plan, terms)) {}

    Drive judge() {
        if (!read_legs()) return {std::move(found_)};
        for (const StoppedLeg& leg : legs_) {
            judge_leg(leg);
            if (found_.size() > enough_violations) return {std::move(found_)};
        }
        return {std::move(found_), true, std::move(entries_)};
    }

  private:
    // A move, its times without the stops on it: when each would begin, and how long it lasts.
    struct Stop {
        double at;
        double lasts;
    };
    struct StoppedLeg {
        Leg move;
        std::vector<Stop> stops;
    };
    // A point of the path, and where that is if it is a vertex.
    struct Bend {
        bool is_vertex = false;
        Vertex vertex = {};
        std::size_t point = 0;
    };

    void report(Rule rule, const std::string& what, Point place, double time, ObstacleId obstacle = {}) {
        found_.push_back({rule, "the " + ground_.id + " agent " + what, ground_.id, obstacle, place, time});
    }

    // A path that does not bend at vertices of the map is not looked at any further.
    bool read_legs() {
        const std::vector<Waypoint>& path = ground_.path;
        bool bends_at_vertices = true;
        Bend last;
        for (std::size_t i = 0; i < path.size(); ++i) {
            if (found_.size() > enough_violations) return false;
            if (stops_on_moves_ && last.is_vertex) {
                const std::size_t next = next_vertex(i);
                if (next > i && is_straight(last.point, next)) i = next;
            }
            const Bend bend = read_bend(i);
            bends_at_vertices = bends_at_vertices && bend.is_vertex;
            add_leg(last, bend);
            last = bend;
        }
        // Who does not move at all stands there.
        if (path.size() == 1) add_leg(last, last);
        for (StoppedLeg& leg : legs_) {
            if (!(leg.move.from == legs_.front().move.from && leg.move.to == leg.move.from)) break;
            leg.move.start = std::min(std::max(leg.move.start, ready_at_), leg.move.end);
        }
        return bends_at_vertices;
    }

    // The first point from there on that is a vertex; that point itself if there is none.
    std::size_t next_vertex(std::size_t point) const {
        for (std::size_t i = point; i < ground_.path.size(); ++i) {
            if (vertex(ground_.path[i], map_, body_)) return i;
        }
        return point;
    }

    // Whether the path leads straight from one point to another, and never back.
    bool is_straight(std::size_t from, std::size_t to) const {
        const std::vector<Waypoint>& path = ground_.path;
        const double dx = path[to].x - path[from].x;
        const double dy = path[to].y - path[from].y;
        const double length = std::hypot(dx, dy);
        if (!(length > 0)) return false;
        double before = 0;
        for (std::size_t i = from + 1; i <= to; ++i) {
            const double x = path[i].x - path[from].x;
            const double y = path[i].y - path[from].y;
            const double along = (x * dx + y * dy) / length;
            if (std::abs(x * dy - y * dx) > terms_.tolerance * length || along < before - terms_.tolerance)
                return false;
            before = along;
        }
        return true;
    }

    Bend read_bend(std::size_t point) {
        const std::optional<Vertex> v = read_vertex(ground_.path[point]);
        return {v.has_value(), v.value_or(Vertex{}), point};
    }

    void add_leg(const Bend& from, const Bend& to) {
        if (from.is_vertex && to.is_vertex) legs_.push_back(leg_between(from.vertex, from.point, to.vertex, to.point));
    }

    StoppedLeg leg_between(Vertex from, std::size_t first, Vertex to, std::size_t last) const {
        const std::vector<Waypoint>& path = ground_.path;
        StoppedLeg leg{{from, to, path[first].t, path[last].t}, {}};
        for (std::size_t i = first + 1; i < last; ++i) {
            if (path[i].x != path[i - 1].x || path[i].y != path[i - 1].y) continue;
            const double lasts = path[i].t - path[i - 1].t;
            leg.stops.push_back({path[i - 1].t - (path[last].t - leg.move.end), lasts});
            leg.move.end -= lasts;
        }
        return leg;
    }

    std::optional<Vertex> read_vertex(const Waypoint& point) {
        const Point place{point.x, point.y};
        const std::optional<Vertex> v = vertex(point, map_, body_);
        if (!v) {
            const std::string of = body_.bends_at_corners ? "centre or corner" : "centre";
            report(Rule::vertex, "bends at " + text(place) + ", which is no cell " + of + " of the map", place,
                   point.t);
        } else if (!keeps_inside(*v, map_, body_)) {
            report(Rule::collision, "reaches beyond the map", place, point.t);
        }
        return v;
    }

    bool stands(double until, double time) const { return time + slack(terms_, time) < until; }

    static std::string how_long(double until) {
        return std::isfinite(until) ? "stands until " + text(until) : "is not removed";
    }

    // What is met where it stops is met when it goes on.
    double with_stops(double time, const std::vector<Stop>& stops) const {
        double all = 0;
        for (const Stop& stop : stops) all += time + slack(terms_, time) >= stop.at ? stop.lasts : 0;
        return time + all;
    }

    void judge_leg(const StoppedLeg& stopped) {
        const Leg& leg = stopped.move;
        const auto late = [&](auto met) {
            met.time = with_stops(met.time, stopped.stops);
            return met;
        };
        for (const Contact& moving : contacts(map_, leg, body_.radius)) {
            const Contact contact = late(moving);
            judge_contact(contact);
            note_entry(contact);
        }
        if (body_.radius == 0) {
            for (const Passage& moving : side_passages(map_, leg)) {
                const Passage passage = late(moving);
                judge_passage(passage);
                // Who moves between two cells is inside neither, and touches both.
                note_entry({passage.first, passage.time, passage.place});
                note_entry({passage.second, passage.time, passage.place});
            }
        }
        if (!body_.slips) {
            for (const Passage& passage : corner_passages(map_, leg)) judge_passage(late(passage));
        }
    }

    void note_entry(const Contact& contact) {
        const auto [known, is_new] = entries_.emplace(contact.obstacle, contact);
        if (!is_new && contact.time < known->second.time) known->second = contact;
    }

    void judge_contact(const Contact& contact) {
        const double until = standing_[contact.obstacle.value];
        if (!stands(until, contact.time)) return;
        report(Rule::collision, "touches " + text(contact.obstacle) + ", which " + how_long(until), contact.place,
               contact.time, contact.obstacle);
    }

    void judge_passage(const Passage& passage) {
        const double until = std::min(standing_[passage.first.value], standing_[passage.second.value]);
        if (!stands(until, passage.time)) return;
        const ObstacleId obstacle = std::max(passage.first, passage.second);
        const std::string pair = passage.first == passage.second ? "two cells of " + text(passage.first)
                                                                 : text(passage.first) + " and " + text(passage.second);
        report(Rule::collision, "squeezes between " + pair + ", where there is no way", passage.place, passage.time,
               obstacle);
    }

    const Map& map_;
    const Itinerary& ground_;
    const Terms& terms_;
    const double ready_at_;      // before, what opens by then may stand where it starts
    const bool stops_on_moves_;  // it may stop between vertices
    const Shape body_;
    const std::vector<double> standing_;
    std::vector<StoppedLeg> legs_;
    Entries entries_;
    Violations found_;
};

}  // namespace

std::vector<double> standing_until(const Map& map, const Plan& plan, const Terms& terms) {
    constexpr double for_ever = std::numeric_limits<double>::infinity();
    std::vector<double> until(map.obstacles().size() + 1, for_ever);
    for (const Breach& breach : plan.breaches) {
        if (!names_obstacle(map, breach.obstacle)) continue;
        until[breach.obstacle.value] = terms.rules.timing == Timing::enforce ? breach.cleared_at : -for_ever;
    }
    for (const TimedOpening& opening : terms.rules.opened) {
        if (!names_obstacle(map, opening.obstacle)) continue;
        double& stands = until[opening.obstacle.value];
        stands = terms.rules.timing == Timing::enforce ? std::min(stands, opening.at) : -for_ever;
    }
    return until;
}

Drive judge_ground(const Map& map, const Plan& plan, const Itinerary& ground, const Agent& asked, const Terms& terms) {
    if (asked.approach.empty()) return GroundJudge(map, plan, ground, asked, terms).judge();
    // From where it bends at vertices only.
    const std::size_t start = std::min(asked.approach.size(), ground.path.size()) - 1;
    std::size_t first = start;
    while (first > 0 && vertex(ground.path[first - 1], map, shape_of(terms.body))) --first;
    Itinerary free = ground;
    free.path.erase(free.path.begin(), free.path.begin() + std::ptrdiff_t(first));
    Drive drive = judge_approach(map, plan, ground, first + 1, terms);
    Drive rest = GroundJudge(map, plan, free, asked, terms).judge();
    append(drive.found, std::move(rest.found));
    drive.followed = drive.followed && rest.followed;
    for (const auto& [obstacle, contact] : rest.entries) drive.entries.emplace(obstacle, contact);
    return drive;
}

Violations judge_entries(const Map& map, const Plan& plan, const Entries& entries, const std::string& who,
                         const Terms& terms) {
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto at_time = [](double when) { return when < never ? "at " + text(when) : "never"; };
    Violations found;
    for (const Breach& breach : plan.breaches) {
        if (!names_obstacle(map, breach.obstacle)) continue;
        const auto entry = entries.find(breach.obstacle);
        const double truth = entry == entries.end() ? never : entry->second.time;
        const double said = breach.entered_at.value_or(never);
        if (truth == said || agree(terms, truth, said)) continue;
        Violation& wrong = found.emplace_back(Violation{
            Rule::entered,
            text(breach.obstacle) + " is said to be entered " + at_time(said) + "; it is entered " + at_time(truth),
            who,
            breach.obstacle,
            {},
            std::min(truth, said)});
        if (entry == entries.end()) continue;
        wrong.place = entry->second.place;
        wrong.time = truth;
    }
    return found;
}

}  // namespace waybreaker::checker

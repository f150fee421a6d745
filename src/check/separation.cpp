// That no two ground agents overlap: between two bends of either both move straight, and so does one as seen from the
// other; how near they come is the distance of a segment to a point.
#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

// Where it is at a time, between two points of its path or at rest behind the last one.
Point place_at(const std::vector<Waypoint>& path, std::size_t next, double time) {
    if (next == 0) return {path.front().x, path.front().y};
    const Waypoint& a = path[next - 1];
    if (next == path.size()) return {a.x, a.y};
    const Waypoint& b = path[next];
    if (b.t <= a.t) return {b.x, b.y};
    const double share = std::clamp((time - a.t) / (b.t - a.t), 0.0, 1.0);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

struct Nearest {
    double apart = for_ever;
    double time = 0;
    Point place;  // of the first
};

// While the offset goes straight from one to another.
Nearest nearest(Point from, Point to, double start, double end) {
    const Point way{to.x - from.x, to.y - from.y};
    const double length2 = way.x * way.x + way.y * way.y;
    const double share = length2 > 0 ? std::clamp(-(from.x * way.x + from.y * way.y) / length2, 0.0, 1.0) : 0.0;
    return {std::hypot(from.x + share * way.x, from.y + share * way.y), start + share * (end - start), {}};
}

class Pair {
  public:
    Pair(const Itinerary& a, const Itinerary& b, bool stays)
        : a_(a.path), b_(b.path), begin_(std::max(a_.front().t, b_.front().t)) {
        // Those that leave are there until the first of them has gone.
        end_ = stays ? std::max(a_.back().t, b_.back().t) : std::min(a_.back().t, b_.back().t);
    }

    // The first time at which the two are nearer than that, as near as they come before one of them bends again.
    std::optional<Nearest> too_near(double needed) const {
        if (begin_ > end_) return std::nullopt;
        std::size_t i = 0;
        std::size_t j = 0;
        for (double time = begin_;;) {
            while (i < a_.size() && a_[i].t <= time) ++i;
            while (j < b_.size() && b_[j].t <= time) ++j;
            const double next =
                std::min({i < a_.size() ? a_[i].t : for_ever, j < b_.size() ? b_[j].t : for_ever, end_});
            Nearest found = nearest(offset(i, j, time), offset(i, j, std::max(next, time)), time, std::max(next, time));
            if (found.apart < needed) {
                found.place = place_at(a_, i, found.time);
                return found;
            }
            if (next <= time || next >= end_) return std::nullopt;
            time = next;
        }
    }

  private:
    Point offset(std::size_t i, std::size_t j, double time) const {
        const Point a = place_at(a_, i, time);
        const Point b = place_at(b_, j, time);
        return {a.x - b.x, a.y - b.y};
    }

    const std::vector<Waypoint>& a_;
    const std::vector<Waypoint>& b_;
    double begin_;  // both are there from then on
    double end_;
};

// Left, right, top and bottom of a path, so that those far apart need no look at every move.
struct Bounds {
    double min_x = for_ever, max_x = -for_ever, min_y = for_ever, max_y = -for_ever;

    explicit Bounds(const Itinerary& agent) {
        for (const Waypoint& at : agent.path) {
            min_x = std::min(min_x, at.x);
            max_x = std::max(max_x, at.x);
            min_y = std::min(min_y, at.y);
            max_y = std::max(max_y, at.y);
        }
    }
    bool apart(const Bounds& other, double needed) const {
        return other.min_x - max_x >= needed || min_x - other.max_x >= needed || other.min_y - max_y >= needed ||
               min_y - other.max_y >= needed;
    }
};

}  // namespace

Violations judge_separation(const std::vector<Disc>& discs, const Terms& terms) {
    Violations found;
    std::vector<Bounds> bounds;
    for (const Disc& disc : discs) bounds.emplace_back(*disc.agent);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        for (std::size_t j = 0; j < i && found.size() < enough_violations; ++j) {
            const double needed = discs[i].radius + discs[j].radius + terms.rules.separation - terms.tolerance;
            if (bounds[i].apart(bounds[j], needed)) continue;
            const auto near =
                Pair(*discs[j].agent, *discs[i].agent, terms.rules.at_goal == AtGoal::stay).too_near(needed);
            if (!near) continue;
            found.push_back({Rule::separation,
                             "the " + discs[j].agent->id + " and the " + discs[i].agent->id + " agent are " +
                                 text(near->apart) + " cells apart instead of " + text(needed + terms.tolerance),
                             discs[j].agent->id,
                             {},
                             near->place,
                             near->time});
        }
    }
    return found;
}

double away(const Waypoint& a, const Waypoint& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double away(const Waypoint& p, const Waypoint& a, const Waypoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double share = square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

}  // namespace waybreaker::checker

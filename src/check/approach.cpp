// How an agent that is under way already gets to its start: from anywhere, so in reals. What it touches is looked for
// in short pieces, with a hair's breadth to spare, and when it first does by halving.
#include <cmath>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double piece = 0.05;    // cells
constexpr double spare = 1e-3;    // cells
constexpr double grazing = 1e-9;  // cells: who touches does not meet
constexpr int halvings = 50;

class ApproachJudge {
  public:
    ApproachJudge(const Map& map, const Plan& plan, const Itinerary& ground, const Terms& terms)
        : map_(map),
          ground_(ground),
          terms_(terms),
          radius_(terms.body.reach()),
          standing_(standing_until(map, plan, terms)) {}

    Drive judge(std::size_t points) {
        for (std::size_t i = 1; i < points && drive_.found.empty(); ++i)
            judge_leg(ground_.path[i - 1], ground_.path[i]);
        drive_.followed = drive_.found.empty();
        return std::move(drive_);
    }

  private:
    static Waypoint between(const Waypoint& a, const Waypoint& b, double share) {
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.t + share * (b.t - a.t)};
    }

    // Whether it meets the cell, grown by that.
    bool meets(const Waypoint& p, Cell c, double grown) const {
        const double x = std::abs(p.x - c.x) - 0.5;
        const double y = std::abs(p.y - c.y) - 0.5;
        if (radius_ == 0) return x < grown && y < grown;
        return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) < radius_ + grown;
    }

    void judge_leg(const Waypoint& a, const Waypoint& b) {
        const int pieces = int(std::hypot(b.x - a.x, b.y - a.y) / piece) + 1;
        for (int k = 0; k <= pieces; ++k) {
            const double share = double(k) / pieces;
            const Waypoint p = between(a, b, share);
            for (int y = int(std::floor(p.y - radius_)); y <= int(std::ceil(p.y + radius_)); ++y) {
                for (int x = int(std::floor(p.x - radius_)); x <= int(std::ceil(p.x + radius_)); ++x) {
                    if (meets(p, {x, y}, -grazing))
                        judge_contact(a, b, k > 0 ? double(k - 1) / pieces : 0, share, {x, y});
                }
            }
        }
    }

    // It meets the cell at the second of these shares of a leg, and perhaps not yet at the first.
    void judge_contact(const Waypoint& a, const Waypoint& b, double before, double share, Cell c) {
        const bool on_map = c.x >= 0 && c.y >= 0 && c.x < map_.width() && c.y < map_.height();
        const ObstacleId obstacle = on_map ? map_.obstacle_at(c) : ObstacleId{};
        if (on_map && !obstacle) return;
        const Waypoint p = between(a, b, share);
        for (int i = 0; i < halvings && !meets(between(a, b, before), c, -grazing); ++i) {
            const double middle = (before + share) / 2;
            (meets(between(a, b, middle), c, -grazing) ? share : before) = middle;
        }
        const Waypoint first = between(a, b, share);
        const bool stands = !on_map || first.t + slack(terms_, first.t) < standing_[obstacle.value];
        if (stands && meets(p, c, -spare)) {
            drive_.found.push_back(
                {Rule::collision, "the " + ground_.id + " agent touches " + text(obstacle) + " on its way to its start",
                 ground_.id, obstacle, Point(first.x, first.y), first.t});
        }
        if (!on_map) return;
        const Contact contact{obstacle, first.t, {first.x, first.y}};
        const auto [known, is_new] = drive_.entries.emplace(obstacle, contact);
        if (!is_new && contact.time < known->second.time) known->second = contact;
    }

    const Map& map_;
    const Itinerary& ground_;
    const Terms& terms_;
    double radius_;
    const std::vector<double> standing_;
    Drive drive_;
};

}  // namespace

Drive judge_approach(const Map& map, const Plan& plan, const Itinerary& ground, std::size_t points,
                     const Terms& terms) {
    return ApproachJudge(map, plan, ground, terms).judge(points);
}

}  // namespace waybreaker::checker

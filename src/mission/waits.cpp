#include "mission/waits.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mission/in_windows.hpp"
#include "mission/zone_stays.hpp"
#include "model/timeline.hpp"
#include "safe_interval/motion.hpp"
#include "safe_interval/traffic.hpp"

namespace waybreaker {
namespace {

using safe_interval::Interval;
using safe_interval::Leg;

constexpr double whenever = -std::numeric_limits<double>::infinity();

// Times that differ by less are one.
double rounding_at(double time) {
    return 1e-6 + 1e-12 * time;
}

// Departures at which something is in the way, and what.
struct Hindrance {
    Interval departures;
    Wait wait;
};

// From a stop to the next one, or to the goal, as if it began at time 0.
struct Run {
    std::vector<Waypoint> path;
    bool stays = true;  // at its end
    double duration() const { return path.back().t; }
};

// The paths that may be in the way of others.
struct Disc {
    std::size_t agent = 0;
    double radius = 0;
    std::vector<Leg> legs;
    Waypoint least;  // of the path, without its time
    Waypoint most;
};

class Causes {
  public:
    Causes(const Map& map, const Mission& mission, const Plan& plan) : map_(map), mission_(mission), plan_(plan) {
        for (const Breach& breach : plan.breaches) removed_.push_back(breach.obstacle);
        for (const TimedOpening& opening : mission.rules.opened) removed_.push_back(opening.obstacle);
        if (has_windows(mission)) watch_.emplace(map, mission);
        for (std::size_t i = 0; i < plan.agents.size(); ++i) {
            if (plan.agents[i].kind == AgentKind::air || !mission.rules.collisions) continue;
            const std::vector<Waypoint>& path = plan.agents[i].path;
            const auto [left, right] = std::ranges::minmax(path, {}, &Waypoint::x);
            const auto [top, bottom] = std::ranges::minmax(path, {}, &Waypoint::y);
            discs_.push_back({i,
                              mission.agents[i].body.reach(),
                              safe_interval::TrafficIndex::legs(path, stays()),
                              {left.x, top.y, 0},
                              {right.x, bottom.y, 0}});
        }
    }

    std::vector<Wait> waits(std::size_t agent) const {
        const std::vector<Waypoint>& path = plan_.agents[agent].path;
        std::vector<Wait> waits;
        for (std::size_t i = 0; i + 1 < path.size();) {
            const std::size_t last = last_at(path, i);
            const double until = path[last].t;
            if (last + 1 < path.size() && until - path[i].t > rounding_at(until)) {
                const Run run = run_from(path, last);
                const Wait whole{{path[i].x, path[i].y}, path[i].t, until};
                add(reasons(whole, hindrances(agent, whole, run)), waits);
            }
            i = last + 1;
        }
        return waits;
    }

  private:
    bool stays() const { return mission_.rules.at_goal == AtGoal::stay; }

    // The last of the points that lie where that one does, in a row.
    static std::size_t last_at(std::span<const Waypoint> path, std::size_t i) {
        while (i + 1 < path.size() && path[i + 1].x == path[i].x && path[i + 1].y == path[i].y) ++i;
        return i;
    }

    Run run_from(std::span<const Waypoint> path, std::size_t first) const {
        Run run{{{path[first].x, path[first].y, 0}}};
        for (std::size_t i = first + 1; i < path.size(); ++i) {
            const Waypoint& to = path[i];
            if (to.x == run.path.back().x && to.y == run.path.back().y) return run;
            run.path.push_back({to.x, to.y, to.t - path[first].t});
        }
        run.stays = stays();
        return run;
    }

    std::vector<Hindrance> hindrances(std::size_t agent, const Wait& whole, const Run& run) const {
        std::vector<Hindrance> found;
        const auto add = [&](const Interval& departures, WaitReason reason, ObstacleId obstacle,
                             const std::string& who) {
            if (departures.empty() || departures.to <= whole.from || departures.from >= whole.until) return;
            Wait wait = whole;
            wait.reason = reason;
            wait.obstacle = obstacle;
            wait.agent = who;
            found.push_back({departures, wait});
        };
        const Agent& driver = mission_.agents[agent];
        if (whole.from < driver.ready_at) add({whenever, driver.ready_at}, WaitReason::readiness, {}, "");
        for (const Breach& breach : plan_.breaches) {
            if (mission_.rules.timing == Timing::ignore) break;
            const bool is_breaching = breach.by == driver.id && breach.begun_at && *breach.begun_at < whole.until &&
                                      *breach.begun_at >= whole.from - rounding_at(whole.from);
            if (is_breaching) add({whenever, breach.cleared_at}, WaitReason::opening, breach.obstacle, breach.by);
            const auto touched = first_touch(map_, breach.obstacle, run.path, standing_radius(driver.body));
            if (!touched) continue;
            add({whenever, breach.cleared_at - *touched}, WaitReason::opening, breach.obstacle, breacher(breach));
        }
        for (const TimedOpening& opening : mission_.rules.opened) {
            if (mission_.rules.timing == Timing::ignore) break;
            const auto touched = first_touch(map_, opening.obstacle, run.path, standing_radius(driver.body));
            if (touched) add({whenever, opening.at - *touched}, WaitReason::opening, opening.obstacle, "");
        }
        // Its last moments are for the rubble of what it enters next.
        double rubble_from = whole.until;
        for (const ObstacleId obstacle : entered_on(agent, whole, run)) {
            add({rubble_from - mission_.rules.rubble, rubble_from}, WaitReason::rubble, obstacle, "");
            rubble_from -= mission_.rules.rubble;
        }
        add_zones(agent, whole, run, found);
        for (const Disc& disc : discs_) {
            if (disc.agent == agent) continue;
            const double reach = driver.body.reach() + disc.radius + mission_.rules.separation -
                                 safe_interval::TrafficIndex::planning_slack;
            if (!comes_near(run, disc, reach)) continue;
            for (const Interval& departures : unsafe_departures(whole, run, disc, reach)) {
                add(departures, WaitReason::agent, {}, plan_.agents[disc.agent].id);
            }
        }
        return found;
    }

    // What it has not entered before and touches on the first move of a run, the last one first.
    std::vector<ObstacleId> entered_on(std::size_t agent, const Wait& whole, const Run& run) const {
        if (mission_.rules.rubble == 0) return {};
        const double radius = standing_radius(mission_.agents[agent].body);
        std::vector<std::pair<double, ObstacleId>> entered;
        for (const ObstacleId obstacle : removed_) {
            const std::span<const Waypoint> move = std::span(run.path).first(2);
            const auto touched = first_touch(map_, obstacle, move, radius);
            const auto first = first_touch(map_, obstacle, plan_.agents[agent].path, radius);
            if (touched && first && *first >= whole.until - rounding_at(whole.until))
                entered.emplace_back(*touched, obstacle);
        }
        std::ranges::sort(entered, std::greater{});
        std::vector<ObstacleId> obstacles;
        for (const auto& [time, obstacle] : entered) obstacles.push_back(obstacle);
        return obstacles;
    }

    // Departures at which it would be in a zone while that holds.
    void add_zones(std::size_t agent, const Wait& whole, const Run& run, std::vector<Hindrance>& found) const {
        if (!watch_) return;
        const std::vector<Zone>& zones = mission_.rules.zones;
        for (std::size_t zone = 0; zone < zones.size(); ++zone) {
            if (!zones[zone].has_window() || !watch_->holds_for(zone, agent)) continue;
            for (const Stay& stay : watch_->stays(zone, agent, run.path, run.stays)) {
                const Interval departures{zones[zone].from - stay.until, zones[zone].until - stay.from};
                if (departures.to <= whole.from || departures.from >= whole.until) continue;
                Wait wait = whole;
                wait.reason = WaitReason::zone;
                wait.zone = zone + 1;
                found.push_back({departures, wait});
            }
        }
    }

    // Of one ground and one air agent the plan does not say who breaches.
    std::string breacher(const Breach& breach) const {
        return breach.by.empty() ? mission_.first(AgentKind::air).id : breach.by;
    }

    static bool comes_near(const Run& run, const Disc& disc, double reach) {
        const auto [left, right] = std::ranges::minmax(run.path, {}, &Waypoint::x);
        const auto [top, bottom] = std::ranges::minmax(run.path, {}, &Waypoint::y);
        return left.x - reach < disc.most.x && right.x + reach > disc.least.x && top.y - reach < disc.most.y &&
               bottom.y + reach > disc.least.y;
    }

    // Those within the wait at which the run comes too near to the disc: while it moves, or where it stops and stands
    // until the time at which it is there by the plan.
    static std::vector<Interval> unsafe_departures(const Wait& whole, const Run& run, const Disc& disc, double reach) {
        std::vector<Interval> unsafe;
        const Waypoint& end = run.path.back();
        const Leg stop{{end.x, end.y}, {}, whole.from + end.t, whole.until + end.t};
        for (const Leg& leg : disc.legs) {
            if (leg.to <= whole.from || leg.from >= stop.to) continue;
            for (std::size_t i = 1; i < run.path.size(); ++i) {
                const Waypoint& a = run.path[i - 1];
                const Waypoint& b = run.path[i];
                const double lasts = b.t - a.t;
                if (lasts <= 0 || leg.to <= whole.from + a.t || leg.from >= whole.until + b.t) continue;
                const safe_interval::Move move{{a.x, a.y}, {(b.x - a.x) / lasts, (b.y - a.y) / lasts}, lasts};
                const Interval departures = safe_interval::unsafe_departures(move, leg, reach);
                if (!departures.empty()) unsafe.push_back({departures.from - a.t, departures.to - a.t});
            }
            if (!run.stays) continue;
            const Interval near = safe_interval::overlap(leg, stop, reach);
            if (!near.empty()) unsafe.push_back({whenever, near.to - end.t});
        }
        return unsafe;
    }

    // The wait in parts: at each moment what is in the way for longest.
    static std::vector<Wait> reasons(const Wait& whole, const std::vector<Hindrance>& hindrances) {
        const double rounding = rounding_at(whole.until);
        std::vector<Wait> parts;
        for (double time = whole.from; whole.until - time > rounding;) {
            const Hindrance* longest = nullptr;
            double next = whole.until;
            for (const Hindrance& one : hindrances) {
                if (one.departures.from > time + rounding) {
                    next = std::min(next, one.departures.from);
                } else if (one.departures.to > (longest == nullptr ? time : longest->departures.to) + rounding) {
                    longest = &one;
                }
            }
            Wait part = longest == nullptr ? whole : longest->wait;
            part.from = time;
            part.until = longest == nullptr ? next : std::min(longest->departures.to, whole.until);
            if (part.until > whole.until - rounding) part.until = whole.until;
            time = part.until;
            parts.push_back(part);
        }
        return parts;
    }

    // Parts with one reason in a row are one.
    static void add(const std::vector<Wait>& parts, std::vector<Wait>& waits) {
        for (const Wait& part : parts) {
            const bool same = !waits.empty() && waits.back().until == part.from && waits.back().at == part.at &&
                              waits.back().reason == part.reason && waits.back().obstacle == part.obstacle &&
                              waits.back().agent == part.agent && waits.back().zone == part.zone;
            if (same) {
                waits.back().until = part.until;
            } else {
                waits.push_back(part);
            }
        }
    }

    const Map& map_;
    const Mission& mission_;
    const Plan& plan_;
    std::vector<ObstacleId> removed_;
    std::vector<Disc> discs_;
    std::optional<ZoneWatch> watch_;
};

}  // namespace

void add_waits(const Map& map, const Mission& mission, Plan& plan) {
    const Causes causes(map, mission, plan);
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::ground) plan.agents[i].waits = causes.waits(i);
    }
}

}  // namespace waybreaker

// Actor: an agent of a mission that is played, and what it does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "rehearse/script.hpp"
#include "rehearse/trail.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::rehearsal {

inline constexpr double never = std::numeric_limits<double>::infinity();

// `waiting`: for orders; `held`: until a time; `at_work`: until the breach is done.
enum class Phase { waiting, held, moving, at_work, arrived, lost };

struct Actor {
    Actor(const Agent& agent, std::size_t index);

    std::size_t number = 0;      // in the mission that is rehearsed
    std::size_t planned_as = 0;  // in that of the plan
    AgentKind kind = AgentKind::ground;
    double speed = 1;
    double radius = 0;
    std::vector<Waypoint> path = {};
    Script script = {};
    std::size_t stop = 0;  // the last one that it got to
    Phase phase = Phase::waiting;
    double since = 0;  // it moves
    double until = never;
    double barred_at = never;  // by a zone, for which there was a new plan
    bool rolls = false;        // it was on a move when the plan changed: it goes on at once
    bool delayed = false;      // at this stop, the delay is drawn already
    std::uint64_t moves = 0;
    double driven = 0;                  // up to the stop, cells
    double news = never;                // what is drawn happens when it has driven that
    std::vector<ObstacleId> work = {};  // it is on
    double arrived_at = 0;
    // Of an aircraft, in units of time: how long its battery lasts and what is to be left of that, how long it was in
    // the air, but for the flight it is on, and since when it is on that.
    double battery = never;
    double reserve = 0;
    double flown = 0;
    double took_off = never;
    bool recharging = false;
    Point lost_at = {};
    Trail trail = {};

    bool ended() const { return phase == Phase::arrived || phase == Phase::lost; }
    void take_off(double now) {
        if (kind == AgentKind::air && !flies()) took_off = now;
    }
    // Whether it lands on its reserve.
    bool land(double now) {
        if (!flies()) return false;
        flown = in_the_air(now);
        took_off = never;
        return flown > (1 - reserve) * battery * (1 + 1e-6);
    }
    // Begins what it does at the next stop, where it is: whether it lands on its reserve for that.
    bool begin_work(const Stop& next, double now) {
        work = next.breaches;
        recharging = next.recharges;
        if (recharging) return land(now);
        take_off(now);
        return false;
    }
    // Its battery is full, if it has recharged. Whether the plan, which may have changed, has it there for that.
    bool ends_work_as_planned() {
        const bool recharged = std::exchange(recharging, false);
        if (recharged) flown = 0;
        if (stop + 1 == script.size()) return false;
        const Stop& next = script[stop + 1];
        return recharged ? next.at == here().at : next.breaches == work;
    }
    bool flies() const { return took_off != never; }
    double in_the_air(double now) const { return flown + (flies() ? now - took_off : 0); }
    // In the air, when its battery is empty.
    double emptied_at() const { return flies() ? took_off + (battery - flown) * (1 + 1e-6) : never; }
    // The next time at which something happens to it.
    double event() const { return std::min(until, emptied_at()); }
    const Stop& here() const { return script[stop]; }
    double to_next() const { return distance(script[stop].at, script[stop + 1].at); }
    Point at(double now) const {
        if (phase == Phase::lost) return lost_at;
        if (phase != Phase::moving) return here().at;
        const double length = to_next();
        const double share = length > 0 ? std::clamp((now - since) * speed / length, 0.0, 1.0) : 1;
        const Point& a = here().at;
        const Point& b = script[stop + 1].at;
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    // So far ahead on its path, or nowhere.
    std::optional<Point> ahead(double way, double now) const;
    // As it reports it.
    AgentState state(double now) const;
    // The last point of its planned path that it has left behind; where it stands for a while by the plan, the one that
    // it would be at by now.
    std::size_t passed(double now) const;
};

double length_of(const std::vector<Waypoint>& path);

// The cells of a street that is blocked there; none where a vehicle is or is to end.
std::vector<Cell> rubble_at(const Map& map, Point place, const std::vector<Actor>& actors, double now);

}  // namespace waybreaker::rehearsal

// Actor: an agent of a mission that is played, and what it does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "rehearse/script.hpp"
#include "rehearse/trail.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::rehearsal {

inline constexpr double never = std::numeric_limits<double>::infinity();

// `waiting`: for orders; `held`: until a time; `at_work`: until the breach is done.
enum class Phase { waiting, held, moving, at_work, arrived, lost };

struct Actor {
    std::size_t number = 0;  // in the mission
    AgentKind kind = AgentKind::ground;
    double speed = 1;
    double radius = 0;
    std::vector<Waypoint> path = {};
    Script script = {};
    std::size_t stop = 0;  // the last one that it got to
    Phase phase = Phase::waiting;
    double since = 0;  // it moves
    double until = never;
    bool rolls = false;    // it was on a move when the plan changed: it goes on at once
    bool delayed = false;  // at this stop, the delay is drawn already
    std::uint64_t moves = 0;
    double driven = 0;                  // up to the stop, cells
    double news = never;                // what is drawn happens when it has driven that
    std::vector<ObstacleId> work = {};  // it is on
    double arrived_at = 0;
    Point lost_at = {};
    Trail trail = {};

    bool ended() const { return phase == Phase::arrived || phase == Phase::lost; }
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
    // The last point of its planned path that it has left behind; where it stands for a while by the plan, the one that
    // it would be at by now.
    std::size_t passed(double now) const;
};

double length_of(const std::vector<Waypoint>& path);

// The cells of a street that is blocked there; none where a vehicle is or is to end.
std::vector<Cell> rubble_at(const Map& map, Point place, const std::vector<Actor>& actors, double now);

}  // namespace waybreaker::rehearsal

<<<<<<< HEAD
// Actor: an agent that is played, where it is on its script and what it does.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
=======
// Actor: an agent of a mission that is played, and what it does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
>>>>>>> live
#include <vector>

#include "rehearse/script.hpp"
#include "rehearse/trail.hpp"
<<<<<<< HEAD
=======
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"
>>>>>>> live

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
<<<<<<< HEAD
    // The last point of its planned path that it has left behind; where it stands for a while by the plan, the one that
    // it would be at by now.
    std::size_t passed(double now) const {
        const std::size_t last = here().point;
        if (kind == AgentKind::air || phase == Phase::moving || here().share > 0) return last;
        std::size_t first = last;
        while (first > 0 && path[first - 1].x == path[last].x && path[first - 1].y == path[last].y) --first;
        while (first < last && path[first + 1].t <= now) ++first;
        return first;
    }
};

// Of a path, in cells.
inline double length_of(const std::vector<Waypoint>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    return length;
}
=======
    // So far ahead on its path, or nowhere.
    std::optional<Point> ahead(double way, double now) const;
    // The last point of its planned path that it has left behind; where it stands for a while by the plan, the one that
    // it would be at by now.
    std::size_t passed(double now) const;
};

// The cells of a street that is blocked there; none where a vehicle is or is to end.
std::vector<Cell> rubble_at(const Map& map, Point place, const std::vector<Actor>& actors, double now);
>>>>>>> live

}  // namespace waybreaker::rehearsal

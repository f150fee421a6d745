// Position: where an agent is on its planned path by now, and when it gets to the points ahead if nothing stops it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::live {

// The part of a planned path that is still to come.
struct Position {
    Point at;
    std::size_t next = 0;  // the first point of the planned path ahead; its size if there is none
    bool on_time = true;   // as planned, but for rounding
    bool stands = false;   // it is not on a move
    Doing doing = Doing::moving;
    std::vector<Waypoint> ahead;  // `at` at the time asked for, then the points from `next` on. Planned times, or the
                                  // earliest: it drives at its speed, and leaves no place before it was to

    // Of an aircraft that zones are in the way of, to the first point ahead: where it bends; the first of these is
    // where it gets out of a zone in which it was found.
    std::vector<Waypoint> detour = {};
    double leaves_zone = 0;    // the time at which it has got out of one
    std::size_t left_out = 0;  // points before `next` that it does not come to any more: zones hold over them

    // Whether it has got to that point of its planned path, by the time asked for.
    bool has_passed(std::size_t point) const { return point + left_out < next; }
    bool finished() const { return ahead.size() == 1; }
    // What is ahead, round zones.
    std::vector<Waypoint> flight() const;
};

// `state`: what is reported of it, or none.
Position position_of(const Itinerary& agent, const AgentState* state, double now);

// Lengths and times below that are rounding.
inline constexpr double hair = 1e-9;

inline bool same_place(const Waypoint& a, const Waypoint& b) {
    return a.x == b.x && a.y == b.y;
}

// The point of its path at which it has recharged, if it is on it.
std::optional<std::size_t> end_of(const Itinerary& agent, const Recharge& recharge);

// On the path, at that time; before and after it, its ends.
Waypoint place_on(const std::vector<Waypoint>& path, double time);
// Until then, that place its last point.
std::vector<Waypoint> until(const std::vector<Waypoint>& path, double time);

}  // namespace waybreaker::live

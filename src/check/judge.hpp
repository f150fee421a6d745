// The parts of a judgement, each on its own: they take what they judge and give back what is wrong with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "check/contact.hpp"
#include "waybreaker/check.hpp"

namespace waybreaker::checker {

using Violations = std::vector<Violation>;

// What a plan is held against.
struct Terms {
    const Rules& rules;
    Body body;  // of the ground agent
    double tolerance;
};

// A path that breaks more is not followed to its end.
inline constexpr std::size_t enough_violations = 1000;

inline void append(Violations& all, Violations more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

// How far a number may be off: by a share of itself, but no more than that of a thousand; and by what sums of doubles
// lose.
inline double slack(const Terms& terms, double value) {
    constexpr double rounding = 1e-12;
    return terms.tolerance * std::clamp(std::abs(value), 1.0, 1000.0) + rounding * std::abs(value);
}
// A sum that overflows agrees with nothing.
inline bool agree(const Terms& terms, double a, double b) {
    return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= slack(terms, std::max(std::abs(a), std::abs(b)));
}

// "12.5", "12.5,3", "obstacle 17"
std::string text(double value);
std::string text(Point p);
std::string text(ObstacleId obstacle);

// Whether the map has such an obstacle; it can be asked for only then.
inline bool names_obstacle(const Map& map, ObstacleId obstacle) {
    return obstacle && obstacle.value <= map.obstacles().size();
}

// Until when each obstacle stands, by id: for ever, unless it is removed. [0] is the outside of the map.
std::vector<double> standing_until(const Map& map, const Plan& plan, const Terms& terms);

// That all numbers of the plan are finite. What follows has this as its precondition.
Violations judge_numbers(const Plan& plan);

// From one point to another, and to a piece of a path.
double away(const Waypoint& a, const Waypoint& b);
double away(const Waypoint& p, const Waypoint& a, const Waypoint& b);

// A path from start to goal, in time and at the agent's speed. `asked`: the agent as the mission has it, if it does.
// `own`: what it breaches, in order.
Violations judge_timetable(const Itinerary& agent, const Agent* asked, std::span<const Breach> own, const Terms& terms);

// That the agent stands at its start until it is ready, also if that is its goal.
Violations judge_ready(const Itinerary& agent, const Agent& asked, const Terms& terms);

// The first contact with each obstacle that is met.
using Entries = std::map<ObstacleId, Contact>;

struct Drive {
    Violations found;
    bool followed = false;  // to its end
    Entries entries = {};
};

// The ground agent's way. Precondition: its timetable is in order.
Drive judge_ground(const Map& map, const Plan& plan, const Itinerary& ground, const Agent& asked, const Terms& terms);

// The same of so many points from the first on, wherever they lie. Precondition: the path has them.
Drive judge_approach(const Map& map, const Plan& plan, const Itinerary& ground, std::size_t points, const Terms& terms);

// That what is removed is entered when the plan says. `who` has entered it; empty where there are several.
Violations judge_entries(const Map& map, const Plan& plan, const Entries& entries, const std::string& who,
                         const Terms& terms);

// That it takes its time over rubble. `entries`: where it enters what.
Violations judge_rubble(const Map& map, const Plan& plan, const Itinerary& ground, const Agent& asked,
                        const Entries& entries, const Terms& terms);

// What is removed: whether it may be, and is as described.
Violations judge_removals(const Map& map, const Plan& plan, const Terms& terms);

// How many obstacles the agent may breach, and what to say if it breaches more.
int most_breaches(const Agent& agent);
std::string beyond_capacity(const Agent& agent);

// How long a breach by that agent takes: its own time, or else the rules'.
double lasting(const Agent& agent, const Obstacle& obstacle, const Rules& rules);

// That the agent may breach these, and is where it does, as long as it takes, one after the other. A ground agent
// stands still, its disc within its reach. `asked`: as the mission has it. Precondition: its timetable is in order.
Violations judge_breaches(const Map& map, std::span<const Breach> breaches, const Itinerary& agent, const Agent& asked,
                          const Terms& terms);

// Status, lengths, arrivals and bound. Preconditions: timetables in order; without agents both are null.
// `driver` and `flyer`: as the mission has them.
Violations judge_figures(const Plan& plan, const Itinerary* ground, const Itinerary* air, const Agent& driver,
                         const Agent& flyer, const Terms& terms);

// What it explains of an agent. `alone`: how long its way is without removals. Preconditions: its timetable is in
// order.
Violations judge_waits(const Plan& plan, const Itinerary& agent, double ready_at, const Terms& terms);
Violations judge_gain(const Itinerary& agent, double ready_at, const std::optional<double>& alone, const Terms& terms);

// That the bound is neither above what is reached nor below 0, and the gap fits both.
void judge_bound(const Plan& plan, const Terms& terms, Violations& found);

// A ground agent of several. Precondition: its timetable is in order.
struct Disc {
    const Itinerary* agent;
    double radius;
};

// That any two are far enough apart at all times.
Violations judge_separation(const std::vector<Disc>& discs, const Terms& terms);

// A plan of a team, all of it.
Violations judge_team(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms);

// That agents keep out of zones while they hold, and what is removed does not reach into one for vehicles. What an
// agent under way does until it decides is held against zones without a window only: it is bound to do it.
Violations judge_zones(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms);

// That no aircraft flies farther or longer than it may, and what is said to be out of range is.
Violations judge_ranges(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms);

// Whether the straight way between two places leads through a zone that is closed to that aircraft at that time.
bool flies_in_zone(const Mission& mission, const std::string& aircraft, Point a, Point b, double time);
// The same, or grazes one: there is a reason to fly round.
bool is_barred(const Mission& mission, const std::string& aircraft, Point a, Point b, double time);

// What waits for what. Precondition: nothing else is wrong with the plan.
Violations judge_orders(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms);

}  // namespace waybreaker::checker

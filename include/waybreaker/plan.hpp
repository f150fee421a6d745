// Plan: what a mission's planning gives back, as data (contract, section 4).
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// What a ground agent waits for. `readiness`: its own Agent::ready_at; `opening`: an obstacle that stands; `agent`: one
// that it would touch; `rubble`: what is left of an obstacle that it enters next; `zone`: one with a window that holds;
// `nothing`: it could go on, and only the planner did not see it.
enum class WaitReason { nothing, readiness, opening, agent, rubble, zone };
template <>
inline constexpr std::array<std::string_view, 6> words_of<WaitReason>{"nothing", "readiness", "opening",
                                                                      "agent",   "rubble",    "zone"};

// A time for which a ground agent stands on its way, and why: had it gone on at any moment of it, along its path to
// where it waits next or to its goal, that would have been in its way. Two in a row at one place are two reasons, one
// after the other. Where several things are in the way at once, it is the one that is so for longest.
struct Wait {
    Point at = {};
    double from = 0;  // units of time
    double until = 0;
    WaitReason reason = WaitReason::nothing;
    ObstacleId obstacle = {};  // of an opening
    std::string agent = {};    // who is in the way, or breaches the obstacle
    std::size_t zone = 0;      // which of Rules::zones, from 1; 0: none
};

// A time for which an air agent stands at one of its bases: at its end the battery is full.
struct Recharge {
    Cell at = {};
    double from = 0;  // units of time
    double until = 0;
    double flown = 0;  // when it lands: how long it has been in the air since the battery was full
};

// An agent of the mission, and its path in time.
struct Itinerary {
    std::string id = {};
    AgentKind kind = AgentKind::ground;
    double speed = 1;  // cells per unit of time
    std::vector<Waypoint> path = {};
    Cell start = {};
    Cell goal = {};
    // Whether it gets to its goal; else it stands at its start, or where it has breached its last, until
    // Rules::unreached.
    bool reached = true;
    // Of a ground agent, if asked for: how much earlier it is at its goal than if it were alone and nothing were
    // removed, in units of time (below 0: later); empty where it has no way then.
    std::optional<double> gain = {};
    std::vector<Wait> waits = {};          // of a ground agent, in order
    std::vector<Recharge> recharges = {};  // of an air agent, in order
};

// A moment of an agent's execution: it has got to that point of its path, or that share of the move from there to the
// next point.
struct Moment {
    std::size_t agent = 0;  // in Plan::agents
    std::size_t point = 0;  // in Itinerary::path
    double fraction = 0;    // 0 <= fraction < 1
    friend auto operator<=>(const Moment&, const Moment&) = default;
};

// `opening`: what is entered must have been breached; `passing`: two ground agents would touch.
enum class OrderReason { opening, passing };
template <>
inline constexpr std::array<std::string_view, 2> words_of<OrderReason>{"opening", "passing"};

// `after` may not begin before `before` has happened: whoever executes the plan keeps it, however late anybody is.
// `before`: its agent has got there. `after`: its agent leaves from there.
struct Order {
    Moment before = {};
    Moment after = {};
    OrderReason reason = OrderReason::opening;
    ObstacleId obstacle = {};  // of an opening
    double slack = 0;  // how late `before` may be until `after` is put off, everybody else as planned; units of time
};

// Plan B: what a mission comes to where a breach turns out to have failed when it was to be done, all else as planned
// until then.
struct IfFailed {
    double objective = 0;                  // +infinity: there is no plan then, or a vehicle cannot stop any more
    std::vector<ObstacleId> removed = {};  // all that are, before the failure and after it; none without a plan
    friend bool operator==(const IfFailed&, const IfFailed&) = default;
};

// One obstacle an air agent removes.
struct Breach {
    ObstacleId obstacle = {};
    std::int64_t source_id = 0;
    std::uint32_t cells = 0;
    std::uint32_t hits = 0;                 // in the search before removal
    Cell at = {};                           // where the air agent breaches it
    double cleared_at = 0;                  // units of time
    std::optional<double> entered_at = {};  // when the ground agent first touches a cell of it
    // What the objective would lose if this one had to stay; if asked for (below 0: it gains; +infinity: there is no
    // plan then).
    std::optional<double> saves = {};
    std::optional<IfFailed> if_failed = {};  // if asked for (with_plan_b of revise.hpp)
    // Of a team's plan: the air agent that breaches it, and when it begins to.
    std::string by = {};
    std::optional<double> begun_at = {};
};

// The obstacle that one removal more would take, and what the objective would gain.
struct NextBreach {
    ObstacleId obstacle = {};
    std::int64_t source_id = 0;
    double saves = 0;
};

// The way of one agent, not in time.
struct Route {
    AgentKind kind = AgentKind::ground;
    std::optional<double> length = {};  // cells; empty where there is no path
    std::vector<Point> path = {};
    // Of the search for it; 0 for a flight.
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
    double seconds = 0;
};

// The mission at one stage: without removal ("before") or as planned ("after").
struct Outcome {
    std::vector<Route> routes{Route{AgentKind::ground}, Route{AgentKind::air}};  // one for each agent
    std::optional<double> makespan = {};                                         // when the last agent reaches its goal
    std::optional<double> flowtime = {};         // sum over agents of when each reaches its goal
    std::optional<double> ground_makespan = {};  // when the last ground agent reaches its goal

    // The first route of its kind. REQUIRES: there is one.
    const Route& ground() const;
    const Route& air() const;
    Route& ground();
    Route& air();
};

// The figure of an outcome that the objective speaks of; empty where there is no path.
std::optional<double> value(const Outcome& outcome, Objective objective);

// `no_plan`: valid input, but a ground agent cannot reach its goal. `not_found`: the search ended by itself without a
// plan and without a proof that there is none, as it may for several ground agents; more time would not help.
// `limit_reached`, `stopped`: it ended early.
enum class PlanStatus { solved, no_plan, not_found, limit_reached, stopped };
template <>
inline constexpr std::array<std::string_view, 5> words_of<PlanStatus>{"solved", "no_plan", "not_found", "limit_reached",
                                                                      "stopped"};

// An obstacle that no aircraft can breach and come home from, and the aircraft that comes nearest to it.
struct OutOfRange {
    ObstacleId obstacle;
    std::int64_t source_id = 0;  // as Obstacle::source_id
    std::string agent = {};
    double flight = 0;   // there, the breach, and to the goal, in units of time
    double longest = 0;  // that it may fly
};

// A zone with a window that an agent would be in while it holds, in the plan that comes nearest to keeping out of all.
struct BarredBy {
    std::size_t zone = 0;  // which of Rules::zones, from 1
    std::string agent = {};
    double at = 0;  // when it would be in it first, units of time
};

// Where the base of an agent ends, in a plan that revises another: up to that point of its path it keeps to the other.
struct Decision {
    std::string agent = {};
    std::size_t point = 0;  // in Itinerary::path
    double time = 0;        // when it is there
};

// Cells that turned out to be other than the map says. Blocked ones are one new obstacle, with the next id.
struct Found {
    std::vector<Cell> cells = {};
    bool blocked = true;
    bool destructible = false;
    friend bool operator==(const Found&, const Found&) = default;
};

// The map with what was found laid over it, one after the other.
[[nodiscard]] Map laid_over(const Map& map, std::span<const Found> found);

// What has become of a plan (revise.hpp). `unchanged`: it knows that report already, which is looked at no further.
// `kept`: nothing better was found than the rest of it. `revised`: the rest is another one. `no_plan`: none was found;
// Plan::status says why. `broken`: an agent is bound to meet what is in its way, unless it stops (Revised::halts).
enum class RevisionStatus { unchanged, kept, revised, no_plan, broken };
template <>
inline constexpr std::array<std::string_view, 5> words_of<RevisionStatus>{"unchanged", "kept", "revised", "no_plan",
                                                                          "broken"};

// An agent must stop before it gets to that point of its old path, by then.
struct Halt {
    std::string agent = {};
    std::size_t point = 0;
    double by = 0;  // units of time
};

// What a plan says of itself that was made while the mission was under way (revise.hpp).
struct Revised {
    int number = 1;              // 1 for the first revision, and so on
    std::uint64_t sequence = 0;  // of the last report that it knows
    double now = 0;              // when that was, in units of time; paths begin then
    std::vector<Decision> decisions = {};
    std::vector<Found> found = {};  // since the mission began, in order: laid over the map, it is the one planned on
    RevisionStatus status = RevisionStatus::revised;  // of the plan before
    std::vector<Halt> halts = {};                     // if broken
    std::string reason = {};  // of `no_plan`, where it is no search that says so: for a person, one line
};

struct Plan {
    PlanStatus status = PlanStatus::no_plan;
    Outcome before = {};
    Outcome after = {};
    // A limit ended the choice: the plan is the best one found by then, and the bound what was proven.
    bool limit_reached = false;
    std::optional<double> bound = {};  // proven lower limit of the objective; empty where the method proves none
    std::optional<double> gap = {};    // objective / bound - 1; empty without a bound or a plan
    // With Rules::minimise_demolition: no plan as good as asked for demolishes fewer cells, proven.
    std::optional<std::uint64_t> least_demolition = {};
    std::vector<Breach> breaches = {};  // in the order of the flight; of several flights, of cleared_at
    std::vector<NextBreach> next = {};  // if asked for: at most one
    // If explained: what is not removed only because no aircraft can fly there and home, in the order of the flight
    // that one would make.
    std::vector<OutOfRange> out_of_range = {};
    // Without a plan: what stands in the way, where that is a zone with a window.
    std::optional<BarredBy> barred_by = {};
    std::vector<Itinerary> agents = {};   // one for each agent of the mission, in its order; empty unless solved
    std::optional<Revised> revised = {};  // of a mission that was under way
    // What waits for what: an execution that keeps them has no collision, whatever comes late. Sorted by `after`.
    // Empty unless solved, and where timing is ignored: then obstacles may be entered while they stand.
    std::vector<Order> orders = {};
    struct Seconds {
        double label = 0;   // filled in by whoever labelled the map
        double search = 0;  // both ground searches
        double select = 0;
        double flight = 0;
        double total = 0;
    } seconds = {};
};

}  // namespace waybreaker

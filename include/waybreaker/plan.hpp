// Plan: what a mission's planning gives back, as data (contract, section 4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

enum class AgentKind { ground, air };
// What a plan is to make small: when the last agent reaches its goal; the sum over agents of when each reaches its
// goal; or when the last ground agent does, whenever the aircraft is home.
enum class Objective { makespan, flowtime, ground_makespan };
// `enforce`: an obstacle is solid until it has been breached; `ignore`: removed obstacles never were there (the paper).
enum class Timing { enforce, ignore };

// Speeds of agents, in cells per unit of time: within these every time is a number one can use.
inline constexpr double least_speed = 1e-6;
inline constexpr double most_speed = 1e6;

// How long the air agent stays at a breach point until the obstacle is gone, in units of time: what the map says of the
// obstacle, and this: each from 0 to most_breach_time.
struct BreachTime {
    double per_obstacle = 0;
    double per_cell = 0;
    double of(const Obstacle& obstacle) const {
        return obstacle.breach_time + per_obstacle + per_cell * obstacle.cells;
    }
};

// A point of an agent's path: cell units and the time it is there. Two in a row at one place are a wait.
struct Waypoint {
    double x = 0;
    double y = 0;
    double t = 0;  // in cells / speed
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

struct AgentPlan {
    std::string id;
    AgentKind kind = AgentKind::ground;
    double speed = 1;  // cells per unit of time
    std::vector<Waypoint> path;
    Cell start = {};
    Cell goal = {};
};

// One obstacle the air agent removes.
struct Removal {
    ObstacleId obstacle;
    std::int64_t source_id = 0;
    std::uint32_t cells = 0;
    std::uint32_t hits = 0;  // in the search before removal
    Cell at;                 // where the air agent breaches it
    double cleared_at = 0;
    std::optional<double> entered_at;  // when the ground agent first touches a cell of it
    std::optional<double> saves =
        {};  // what the objective would lose if this one had to stay; if asked for (below 0: it gains)
};

// The obstacle that one removal more would take, and what the objective would gain.
struct NextRemoval {
    ObstacleId obstacle;
    std::int64_t source_id = 0;
    double saves = 0;
};

// The mission at one stage: without removal ("before") or as planned ("after"). A length is empty where there is no
// path.
struct Outcome {
    struct Ground {
        std::optional<double> length;
        std::uint64_t expanded = 0;
        std::uint64_t generated = 0;
        double seconds = 0;
        std::vector<Point> path;
    } ground;
    struct Air {
        double length = 0;
        std::vector<Cell> path;
    } air;
    std::optional<double> makespan;         // when the last agent reaches its goal
    std::optional<double> flowtime;         // sum over agents of when each reaches its goal
    std::optional<double> ground_makespan;  // when the last ground agent reaches its goal
};

// The figure of an outcome that the objective speaks of; empty where there is no path.
std::optional<double> value(const Outcome& outcome, Objective objective);

// `no_plan`: valid input, but the ground agent cannot reach its goal. `limit_reached`, `stopped`: a search ended early.
enum class PlanStatus { solved, no_plan, limit_reached, stopped };

struct Plan {
    PlanStatus status = PlanStatus::no_plan;
    Outcome before;
    Outcome after;
    // A time or expansion limit ended the choice: the plan is the best one found by then, and the bound what was
    // proven.
    bool limit_reached = false;
    std::optional<double> bound;    // proven lower limit of the objective; empty where the method proves none
    std::vector<Removal> removed;   // in the order of the flight
    std::vector<NextRemoval> next;  // if asked for: at most one
    std::vector<AgentPlan> agents;  // the timed paths; empty unless solved
    struct Seconds {
        double label = 0;   // filled in by whoever labelled the map
        double search = 0;  // both ground searches
        double select = 0;
        double flight = 0;
        double total = 0;
    } seconds;
};

}  // namespace waybreaker

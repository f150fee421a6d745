// Mission: what is asked. Who must go where, and what a plan has to keep to; the map says what stands in the way.
//
//     Mission mission = ground_and_air({12, 20}, {400, 380});
//     mission.rules.removals = 2;
//     Plan plan = Planner().plan(map, mission);   // waybreaker/planner.hpp
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/airspace.hpp"
#include "waybreaker/body.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/words.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker {

enum class AgentKind { ground, air };
template <>
inline constexpr std::array<std::string_view, 2> words_of<AgentKind>{"ground", "air"};

// What a plan is to make small: when the last agent reaches its goal; the sum over agents of when each reaches its
// goal, times its weight; or when the last ground agent does, whenever the aircraft is home.
enum class Objective { makespan, flowtime, ground_makespan };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Objective>{"makespan", "flowtime", "ground-makespan"};

// `enforce`: an obstacle is solid until it has been breached; `ignore`: removed obstacles never were there (the paper).
enum class Timing { enforce, ignore };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Timing>{"enforce", "ignore"};

// What ground agents do at their goals: they stand there for ever, or vanish.
enum class AtGoal { stay, leave };
template <>
inline constexpr std::array<std::string_view, 2> words_of<AtGoal>{"stay", "leave"};

// Speeds of agents, in cells per unit of time: within these every time is a number one can use.
inline constexpr double least_speed = 1e-6;
inline constexpr double most_speed = 1e6;
inline constexpr double most_weight_of_agent = 1e9;
inline constexpr std::size_t most_bases = 100;  // of an air agent
inline constexpr double most_reach = 100;       // cells
// Of obstacles that an air agent may breach: as many as the rules allow to all of them.
inline constexpr int any_number = (std::numeric_limits<int>::max)();  // windows.h has a macro max

// A point of an agent's path: cell units and the time it is there. Two in a row at one place are a wait.
struct Waypoint {
    double x = 0;
    double y = 0;
    double t = 0;  // in cells / speed
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

// An obstacle of the map that is gone from that time on.
struct TimedOpening {
    ObstacleId obstacle;
    double at = 0;  // units of time
    friend bool operator==(const TimedOpening&, const TimedOpening&) = default;
};

// Which obstacles an agent may breach at all: those of at most so many cells, and of these, where some are named, only
// the named ones.
struct CanBreach {
    std::uint32_t most_cells = (std::numeric_limits<std::uint32_t>::max)();
    std::optional<std::vector<ObstacleId>> only = {};
};

struct Agent {
    std::string id = {};  // as plans name it
    AgentKind kind = AgentKind::ground;
    Cell start = {};
    Cell goal = {};
    double speed = 1;  // cells per unit of time, least_speed to most_speed
    Body body = {};    // of a ground agent; an air agent has none
    // It stands at its start until then, 0 to most_breach_time, and arrives no earlier, wherever its goal is.
    double ready_at = 0;
    // Where an air agent takes off, if not at the centre of `start`: less than a cell from it, in x and in y.
    std::optional<Point> from = {};
    // How it gets to its start, of an agent that is on its way already: timed points, the last one at the start at
    // `ready_at`. Where and when they begin, the agent begins; others keep clear of a ground agent on it.
    std::vector<Waypoint> approach = {};
    // What its arrival counts for in the flowtime, in people or beds, 0 to most_weight_of_agent.
    double weight = 1;
    int breaches = any_number;  // how many obstacles an air agent may breach, >= 0
    // The longest flight of an air agent, from when it takes off at its start until it lands at its goal: in cells, >
    // 0, where to hover counts as to fly at its speed; and in units of time, > 0. It keeps to both. The last share of
    // both, 0 to below 1, is not planned with.
    double range = std::numeric_limits<double>::infinity();
    double endurance = std::numeric_limits<double>::infinity();
    double reserve = 0;
    // How long it has been in the air by `ready_at` since its battery was full, of an air agent under way: that is gone
    // from both.
    double flown = 0;
    // Where an air agent may land on its way, to take off so much later with a full battery: cells at whose centres it
    // stands for that, in units of time, > 0. Range and endurance are those of a flight from one landing to the next.
    // Without a time it flies once; without bases they are its start and its goal. At most most_bases.
    std::optional<double> recharge = {};
    std::vector<Cell> bases = {};
    // How many obstacles a ground agent may breach itself, >= 0. It stands still while it does, its disc at most
    // `reach` from the obstacle, which is open to all then.
    int own_breaches = 0;
    // How far the disc of a ground agent may be from what it breaches, 0 to most_reach cells.
    double reach = 1;
    // How long a breach by this agent takes for each obstacle, and for each of its cells, in place of
    // Rules::breach_time: 0 to most_breach_time.
    std::optional<double> breach_time = {};
    std::optional<double> breach_time_per_cell = {};
    std::optional<CanBreach> can_breach = {};  // empty: any obstacle
    // Where an air agent may fly. Of a mission, Rules::zones say it, and planning sets this.
    Airspace airspace = {};

    // Where it is when it is ready: where its flight or drive begins.
    Point begin() const { return from.value_or(Point(start)); }
    // How long it can be in the air with a full battery, in units of time; infinity if any time.
    double battery() const { return range / speed < endurance ? range / speed : endurance; }
    // How long a flight of it from now on may take.
    double longest_flight() const {
        const double left = (1 - reserve) * battery() - flown;
        return left > 0 ? left : 0;
    }
    // Whether it may take off when it is ready and land at that time, give or take rounding. Of one that recharges: at
    // any time, if at all.
    bool may_land_at(double time) const {
        if (recharge) return time < std::numeric_limits<double>::infinity();
        return flown + (time - ready_at) <= (1 - reserve) * battery() * (1 + 1e-9);
    }
};

// Agents that move one cell in a unit of time; an aircraft returns to its start unless a goal is given.
[[nodiscard]] Agent vehicle(std::string id, Cell start, Cell goal);
[[nodiscard]] Agent aircraft(std::string id, Cell start, Cell goal);
[[nodiscard]] Agent aircraft(std::string id, Cell start);

// How long the air agent stays at a breach point until the obstacle is gone, in units of time: what the map says of the
// obstacle, and this: each from 0 to most_breach_time.
struct BreachTime {
    double per_obstacle = 0;
    double per_cell = 0;
    double of(const Obstacle& obstacle) const {
        return obstacle.breach_time + per_obstacle + per_cell * obstacle.cells;
    }
};

// What every plan of the mission keeps to.
struct Rules {
    int removals = 3;  // how many obstacles may be removed, >= 0
    // What the removed obstacles may weigh together, >= 0, in the units of Obstacle::weight.
    double budget = std::numeric_limits<double>::infinity();
    std::vector<ObstacleId> protect = {};  // never removed; may be gone
    std::vector<ObstacleId> force = {};    // must be removed; they count among the removals, and in the budget
    // Obstacles that open at these times, whoever opens them: no agent has to, nor may; they count for nothing.
    std::vector<TimedOpening> opened = {};
    // Breaches that have failed, in a mission under way: each once for each time; and how often that of one obstacle
    // may be tried again. Planning passes both by (revise.hpp).
    std::vector<ObstacleId> failed = {};
    int retries = 0;
    // What agents keep out of. Obstacles that reach into a zone for vehicles are not removed.
    std::vector<Zone> zones = {};
    BreachTime breach_time = {};
    // How much longer it takes a ground agent to get through what is left of an obstacle that is removed, in units of
    // time, 0 to most_breach_time: once for each that it drives through. It stands for that at the turn before it, and
    // enters no earlier than so long after the obstacle has opened. Where obstacles stand in time.
    double rubble = 0;
    Timing timing = Timing::enforce;
    Objective objective = Objective::makespan;
    // Of the plans whose objective is at most this share above the best one's, the one that demolishes the fewest
    // cells, 0 to 1; empty: the best plan, whatever it demolishes.
    std::optional<double> minimise_demolition = {};
    // Whether ground agents keep clear of each other. If not, they may be anywhere at once, as destinations of one
    // vehicle after the other are.
    bool collisions = true;
    // A ground agent that is not at its goal by then stays at its start, and counts as if it arrived then, or when it
    // is ready if it is under way till later; empty: each must arrive. Where ground agents do not collide.
    std::optional<double> unreached = {};
    // Of several ground agents: the room between any two of their discs, in cells, 0 to 32; and whether those that have
    // arrived are in the way of others.
    double separation = 0;
    AtGoal at_goal = AtGoal::stay;
};

// How long that agent takes to breach that obstacle, in units of time; infinity if it may not.
[[nodiscard]] double time_to_breach(const Agent& agent, const Obstacle& obstacle, const Rules& rules);

inline constexpr std::size_t most_agents = 10000;

struct Mission {
    // One ground and one air agent, in any order; or a team (docs/coalition.md): any number of ground agents, and
    // aircraft; ground agents may breach, too (docs/crews.md). Where nobody may, nothing is removed, whatever the rules
    // allow.
    std::vector<Agent> agents = {};
    Rules rules = {};

    // Whether it has agents, and others than one ground and one air agent that count alike and only the latter
    // breaches.
    bool is_team() const;
    // Whether each agent must arrive, and counts for as much as any other.
    bool counts_alike() const;
    // Whether its only agent breaches what is in its way itself.
    bool opens_own_way() const;
    // Whether a ground agent may breach beside other agents.
    bool clears() const;
    // Whether some agent may not breach every obstacle.
    bool limits_breaches() const;
    // Whether some flight may be too long.
    bool limits_flights() const;
    // How many obstacles may be removed: by the rules, and by what all agents may breach.
    int removals_allowed() const;

    // The first agent of that kind. REQUIRES: there is one, as validate makes sure.
    const Agent& first(AgentKind kind) const;
    // Of the first ground agent; the default one if there is none.
    Body ground_body() const;
};

// The paper's coalition: a ground agent and an air agent that start and end together.
[[nodiscard]] Mission ground_and_air(Cell start, Cell goal);

// Throws InputError, naming what is wrong, if the mission cannot be put on the map: an agent starts in a wall or off
// the map, rules contradict each other, an obstacle does not exist, two agents of a team have one id or no room beside
// each other, or the coalition is none that can be planned.
void validate(const Map& map, const Mission& mission);

}  // namespace waybreaker

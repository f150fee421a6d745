// Validates missions on a map.
#include "waybreaker/mission.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/range.hpp"
#include "model/in_range.hpp"
#include "model/in_zones.hpp"
#include "model/nearest_place.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/place_error.hpp"

namespace waybreaker {
namespace {

std::string text(Cell c) {
    return std::to_string(c.x) + "," + std::to_string(c.y);
}

void validate_place(const OpenedMap& map, const Agent& agent, Cell at, const std::string& what) {
    const std::string where = "the " + agent.id + " agent's " + what + " " + text(at);
    if (!map.map().grid().contains(at)) {
        throw InputError(ErrorCode::off_map, agent.id,
                         where + " is off the map: x goes from 0 to " + std::to_string(map.width() - 1) +
                             ", y from 0 to " + std::to_string(map.height() - 1));
    }
    if (agent.kind == AgentKind::air || fits(map, at, agent.body)) return;
    const ObstacleId obstacle = map.map().obstacle_at(at);
    const std::string reason = obstacle ? "lies inside obstacle " + std::to_string(obstacle.value)
                                        : "leaves no room for a radius of " + number_text(agent.body.radius);
    const std::optional<Cell> place = nearest_place(map, at, agent.body);
    const std::string none = agent.body.reach() > 0.5 ? "cell with room for the agent" : "free cell";
    throw PlaceError({.agent = agent.id,
                      .what_for = "the " + agent.id + " agent's " + what,
                      .at = at,
                      .obstacle = obstacle,
                      .reason = reason,
                      .nearest = place,
                      .remedy = place ? "a free cell near it is" : "the map has no " + none});
}

std::string sentence(const Misplaced& agent) {
    std::string words = agent.what_for + " " + text(agent.at) + " " + agent.reason + "; " + agent.remedy;
    if (agent.nearest) words.append(1, ' ').append(text(*agent.nearest));
    return words;
}

// REQUIRES: all ids are those of obstacles.
void validate_forced(const Map& map, const Rules& rules) {
    double weight = 0;
    for (auto id = rules.force.begin(); id != rules.force.end(); ++id) {
        const std::string who = "obstacle " + std::to_string(id->value) + " must be removed, but ";
        if (map.obstacle(*id).gone())
            throw InputError(ErrorCode::unknown_obstacle, std::to_string(id->value), who + "is gone");
        const auto refuse = [&](const char* but) {
            throw InputError(ErrorCode::contradiction, std::to_string(id->value), who + but);
        };
        if (std::find(rules.force.begin(), id, *id) != id) refuse("is named twice");
        if (!map.obstacle(*id).destructible) refuse("cannot be destroyed");
        if (std::ranges::count(rules.protect, *id) > 0) refuse("is protected as well");
        weight += map.obstacle(*id).weight;
    }
    if (rules.force.size() > std::size_t(rules.removals)) {
        throw InputError(ErrorCode::contradiction, "removals",
                         "at most " + std::to_string(rules.removals) + " obstacles may be removed, but " +
                             std::to_string(rules.force.size()) + " must be");
    }
    if (!rules.force.empty() && weight > rules.budget) {
        throw InputError(ErrorCode::contradiction, "budget",
                         "the obstacles that must be removed weigh " + number_text(weight) +
                             ", more than the budget of " + number_text(rules.budget));
    }
}

void validate(const Map& map, const Rules& rules) {
    require_enumerator(rules.objective, Objective::ground_makespan, "the objective");
    require_enumerator(rules.timing, Timing::ignore, "the timing");
    require_enumerator(rules.at_goal, AtGoal::leave, "what agents do at their goals");
    if (rules.removals < 0)
        throw InputError(ErrorCode::out_of_range, "the number of removals",
                         "the number of removals cannot be negative");
    require_range(rules.breach_time.per_obstacle, 0, most_breach_time, "the time of a breach");
    require_range(rules.breach_time.per_cell, 0, most_breach_time, "the time of a breach for each cell");
    require_range(rules.rubble, 0, most_breach_time, "the time that rubble takes");
    if (rules.rubble > 0 && rules.timing == Timing::ignore) {
        throw InputError(
            ErrorCode::contradiction, "rubble",
            "rubble takes time only where obstacles stand in time: leave it out, or let the timing be enforced");
    }
    const std::size_t obstacles = map.obstacles().size();
    const auto require_known = [&](ObstacleId id, const std::string& purpose) {
        if (id && id.value <= obstacles) return;
        throw InputError(ErrorCode::unknown_obstacle, std::to_string(id.value),
                         "there is no obstacle " + std::to_string(id.value) + " to " + purpose + ": the map has " +
                             std::to_string(obstacles));
    };
    for (const ObstacleId id : rules.protect) require_known(id, "protect");
    for (const ObstacleId id : rules.force) require_known(id, "force");
    for (const TimedOpening& opening : rules.opened) {
        require_known(opening.obstacle, "open");
        const std::string who = "obstacle " + std::to_string(opening.obstacle.value);
        require_range(opening.at, 0, most_breach_time, "the time at which " + who + " opens");
        if (std::ranges::count(rules.opened, opening.obstacle, &TimedOpening::obstacle) > 1)
            throw InputError(ErrorCode::contradiction, std::to_string(opening.obstacle.value), who + " opens twice");
        if (std::ranges::count(rules.force, opening.obstacle) > 0) {
            throw InputError(ErrorCode::contradiction, std::to_string(opening.obstacle.value),
                             who + " opens by itself, and must be removed as well");
        }
    }
    validate_forced(map, rules);
    if (rules.minimise_demolition) {
        require_range(*rules.minimise_demolition, 0, 1, "the tolerance for a plan that demolishes less");
    }
    if (!(rules.budget >= 0))
        throw InputError(ErrorCode::out_of_range, "the budget", "the budget cannot be " + number_text(rules.budget));
}

// What is open by then.
std::vector<ObstacleId> open_by(const Rules& rules, double time) {
    std::vector<ObstacleId> open;
    for (const TimedOpening& opening : rules.opened) {
        if (opening.at <= time || rules.timing == Timing::ignore) open.push_back(opening.obstacle);
    }
    return open;
}

// Where an agent takes off, and how it gets there.
void validate_beginning(const Map& map, const Agent& agent) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(ErrorCode::contradiction, agent.id, "the " + agent.id + " agent " + why);
    };
    if (agent.from) {
        if (agent.kind == AgentKind::ground) refuse("drives, and starts at the centre of a cell");
        const bool near = std::abs(agent.from->x - agent.start.x) < 1 && std::abs(agent.from->y - agent.start.y) < 1;
        if (!near) refuse("takes off elsewhere than in its start cell");
    }
    double last = 0;
    const Waypoint* before = nullptr;
    for (const Waypoint& p : agent.approach) {
        require_range(p.x, -0.5, map.width() - 0.5, "x of the " + agent.id + " agent's approach");
        require_range(p.y, -0.5, map.height() - 0.5, "y of the " + agent.id + " agent's approach");
        require_range(p.t, last, most_breach_time, "the times of the " + agent.id + " agent's approach");
        last = p.t;
        constexpr double rounding = 1e-6;
        const double driven = before == nullptr ? 0 : distance(Point(before->x, before->y), Point(p.x, p.y));
        if (before != nullptr && driven > 0 && driven > agent.speed * (p.t - before->t) * (1 + rounding) + rounding)
            refuse("is faster on its approach than it can be");
        before = &p;
    }
    if (agent.approach.empty()) return;
    const Waypoint& end = agent.approach.back();
    if (Point(end.x, end.y) != agent.begin()) refuse("has an approach that does not end at its start");
    if (end.t != agent.ready_at) refuse("has an approach that does not end when it is ready");
}

// Two discs at once at these places.
void validate_room(const Agent& a, const Agent& b, Cell Agent::*place, const char* name, double separation) {
    const double needed = a.body.reach() + b.body.reach() + separation;
    const double apart = distance(a.*place, b.*place);
    constexpr double rounding = 1e-9;
    if (apart + rounding >= needed && a.*place != b.*place) return;
    throw InputError(ErrorCode::no_room, b.id,
                     "the " + a.id + " and the " + b.id + " agent have no room at their " + name + "s, " +
                         text(a.*place) + " and " + text(b.*place) + ": these are " + number_text(apart) +
                         " cells apart, and must be " + number_text(std::max(needed, 1.0)));
}

void validate_unreached(const Mission& mission) {
    if (!mission.rules.unreached) return;
    const double unreached = *mission.rules.unreached;
    require_range(unreached, 0, most_breach_time, "the time that an agent counts as that is not reached");
    if (mission.rules.collisions) {
        throw InputError(ErrorCode::contradiction, "unreached",
                         "ground agents can only be left where they are if they do not collide (collisions: false)");
    }
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air || agent.ready_at < unreached || !agent.approach.empty()) continue;
        throw InputError(ErrorCode::contradiction, agent.id,
                         "the " + agent.id + " agent is ready at " + number_text(agent.ready_at) +
                             ", when it counts as not reached: that is from " + number_text(unreached) + " on");
    }
}

void validate_team(const Mission& mission) {
    if (mission.agents.size() > most_agents) {
        throw InputError(ErrorCode::too_large, "agents",
                         "a mission has at most " + std::to_string(most_agents) + " agents, not " +
                             std::to_string(mission.agents.size()));
    }
    require_range(mission.rules.separation, 0, 32, "the separation of ground agents, in cells,");
    if (!mission.rules.collisions && mission.rules.separation > 0) {
        throw InputError(ErrorCode::contradiction, "separation",
                         "ground agents that may be anywhere at once (collisions: false) have no separation");
    }
    std::vector<const Agent*> drivers;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::ground) drivers.push_back(&agent);
    }
    if (drivers.empty()) throw InputError(ErrorCode::contradiction, "", "the mission has no ground agent");
    validate_unreached(mission);
    if (!mission.rules.collisions) return;
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            // Who is under way may be gone when another comes there.
            if (drivers[i]->approach.empty() && drivers[j]->approach.empty())
                validate_room(*drivers[j], *drivers[i], &Agent::start, "start", mission.rules.separation);
            if (mission.rules.at_goal == AtGoal::leave) continue;
            validate_room(*drivers[j], *drivers[i], &Agent::goal, "goal", mission.rules.separation);
        }
    }
}

}  // namespace

const Agent& Mission::first(AgentKind kind) const {
    return *std::ranges::find(agents, kind, &Agent::kind);
}

Body Mission::ground_body() const {
    const auto ground = std::ranges::find(agents, AgentKind::ground, &Agent::kind);
    return ground == agents.end() ? Body() : ground->body;
}

Agent vehicle(std::string id, Cell start, Cell goal) {
    return {.id = std::move(id), .kind = AgentKind::ground, .start = start, .goal = goal};
}

Agent aircraft(std::string id, Cell start, Cell goal) {
    return {.id = std::move(id), .kind = AgentKind::air, .start = start, .goal = goal};
}

Agent aircraft(std::string id, Cell start) {
    return aircraft(std::move(id), start, start);
}

Mission ground_and_air(Cell start, Cell goal) {
    return {{vehicle("ground", start, goal), aircraft("air", start, goal)}};
}

PlaceError::PlaceError(Misplaced agent)
    : InputError(ErrorCode::no_room, agent.agent, sentence(agent)), misplaced(std::move(agent)) {}

bool Mission::counts_alike() const {
    return !rules.unreached && std::ranges::all_of(agents, [](const Agent& agent) { return agent.weight == 1; });
}

bool Mission::is_team() const {
    return !agents.empty() && (agents.size() != 2 || agents[0].kind == agents[1].kind || !counts_alike() || clears());
}

bool Mission::opens_own_way() const {
    return agents.size() == 1 && agents.front().own_breaches > 0;
}

bool Mission::clears() const {
    return agents.size() > 1 && std::ranges::any_of(agents, [](const Agent& agent) { return agent.own_breaches > 0; });
}

bool Mission::limits_breaches() const {
    return std::ranges::any_of(agents, [](const Agent& agent) { return agent.can_breach.has_value(); });
}

bool Mission::limits_flights() const {
    return std::ranges::any_of(agents, [](const Agent& agent) { return std::isfinite(agent.longest_flight()); });
}

int Mission::removals_allowed() const {
    std::int64_t capacity = 0;
    for (const Agent& agent : agents) capacity += agent.kind == AgentKind::air ? agent.breaches : agent.own_breaches;
    return int(std::min<std::int64_t>(rules.removals, capacity));
}

void validate(const Map& map, const Mission& mission) {
    validate(map, mission.rules);
    if (mission.agents.empty()) throw InputError(ErrorCode::contradiction, "", "the mission has no ground agent");
    std::set<std::string> ids;
    for (const Agent& agent : mission.agents) {
        require_enumerator(agent.kind, AgentKind::air, "the " + agent.id + " agent's kind");
        if (!ids.insert(agent.id).second)
            throw InputError(ErrorCode::contradiction, agent.id,
                             "two agents of the mission have the id '" + agent.id + "'");
        require_range(agent.speed, least_speed, most_speed, "the " + agent.id + " agent's speed");
        require_range(agent.ready_at, 0, most_breach_time, "the time at which the " + agent.id + " agent is ready");
        require_range(agent.weight, 0, most_weight_of_agent, "the weight of the " + agent.id + " agent");
        if (agent.kind == AgentKind::ground) validate(agent.body);
        validate_place(OpenedMap(map, open_by(mission.rules, agent.ready_at)), agent, agent.start, "start");
        validate_place(OpenedMap(map, open_by(mission.rules, most_breach_time)), agent, agent.goal, "goal");
        validate_beginning(map, agent);
    }
    if (mission.is_team()) validate_team(mission);
    validate_zones(map, mission);
    validate_flights(map, mission);
}

}  // namespace waybreaker

// Validates missions on a map.
#include "waybreaker/mission.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

std::string text(Cell c) {
    return std::to_string(c.x) + "," + std::to_string(c.y);
}

// The nearest cell, in rings around `at`, where the agent can stand.
std::optional<Cell> nearest_place(const OpenedMap& map, Cell at, const Body& body) {
    const int rings = std::max(map.width(), map.height());
    for (int ring = 1; ring <= rings; ++ring) {
        std::optional<Cell> best;
        for (int dy = -ring; dy <= ring; ++dy) {
            const int stride = std::abs(dy) == ring ? 1 : 2 * ring;
            for (int dx = -ring; dx <= ring; dx += stride) {
                const Cell c{at.x + dx, at.y + dy};
                if (!map.map().grid().contains(c) || !fits(map, c, body)) continue;
                if (!best || distance(c, at) < distance(*best, at)) best = c;
            }
        }
        if (best) return best;
    }
    return std::nullopt;
}

void validate_place(const OpenedMap& map, const Agent& agent, Cell at, const std::string& what) {
    const std::string where = "the " + agent.id + " agent's " + what + " " + text(at);
    if (!map.map().grid().contains(at)) {
        throw InputError(where + " is off the map: x goes from 0 to " + std::to_string(map.width() - 1) +
                         ", y from 0 to " + std::to_string(map.height() - 1));
    }
    if (agent.kind == AgentKind::air || fits(map, at, agent.body)) return;
    const ObstacleId obstacle = map.map().obstacle_at(at);
    const std::string reason = obstacle ? " lies inside obstacle " + std::to_string(obstacle.value)
                                        : " leaves no room for a radius of " + number_text(agent.body.radius);
    const std::optional<Cell> place = nearest_place(map, at, agent.body);
    throw InputError(where + reason +
                     (place ? "; a free cell near it is " + text(*place) : "; the map has no free cell"));
}

// REQUIRES: all ids are those of obstacles.
void validate_forced(const Map& map, const Rules& rules) {
    double weight = 0;
    for (auto id = rules.force.begin(); id != rules.force.end(); ++id) {
        const std::string who = "obstacle " + std::to_string(id->value) + " must be removed, but ";
        if (std::find(rules.force.begin(), id, *id) != id) throw InputError(who + "is named twice");
        if (!map.obstacle(*id).destructible) throw InputError(who + "cannot be destroyed");
        if (std::ranges::count(rules.protect, *id) > 0) throw InputError(who + "is protected as well");
        weight += map.obstacle(*id).weight;
    }
    if (rules.force.size() > std::size_t(rules.removals)) {
        throw InputError("at most " + std::to_string(rules.removals) + " obstacles may be removed, but " +
                         std::to_string(rules.force.size()) + " must be");
    }
    if (!rules.force.empty() && weight > rules.budget) {
        throw InputError("the obstacles that must be removed weigh " + number_text(weight) +
                         ", more than the budget of " + number_text(rules.budget));
    }
}

void validate(const Map& map, const Rules& rules) {
    if (rules.removals < 0) throw InputError("the number of removals cannot be negative");
    require_range(rules.breach_time.per_obstacle, 0, most_breach_time, "the time of a breach");
    require_range(rules.breach_time.per_cell, 0, most_breach_time, "the time of a breach for each cell");
    const std::size_t obstacles = map.obstacles().size();
    const auto require_known = [&](ObstacleId id, const std::string& purpose) {
        if (id && id.value <= obstacles) return;
        throw InputError("there is no obstacle " + std::to_string(id.value) + " to " + purpose + ": the map has " +
                         std::to_string(obstacles));
    };
    for (const ObstacleId id : rules.protect) require_known(id, "protect");
    for (const ObstacleId id : rules.force) require_known(id, "force");
    validate_forced(map, rules);
    if (!(rules.budget >= 0)) throw InputError("the budget cannot be " + number_text(rules.budget));
}

}  // namespace

const Agent& Mission::first(AgentKind kind) const {
    return *std::ranges::find(agents, kind, &Agent::kind);
}

Body Mission::ground_body() const {
    const auto ground = std::ranges::find(agents, AgentKind::ground, &Agent::kind);
    return ground == agents.end() ? Body() : ground->body;
}

Mission ground_and_air(Cell start, Cell goal) {
    return {{{.id = "ground", .kind = AgentKind::ground, .start = start, .goal = goal},
             {.id = "air", .kind = AgentKind::air, .start = start, .goal = goal}}};
}

void validate(const Map& map, const Mission& mission) {
    validate(map, mission.rules);
    int ground_agents = 0;
    int air_agents = 0;
    const OpenedMap closed(map);
    for (const Agent& agent : mission.agents) {
        ++(agent.kind == AgentKind::ground ? ground_agents : air_agents);
        require_range(agent.speed, least_speed, most_speed, "the " + agent.id + " agent's speed");
        if (agent.kind == AgentKind::ground) validate(agent.body);
        validate_place(closed, agent, agent.start, "start");
        validate_place(closed, agent, agent.goal, "goal");
    }
    if (ground_agents != 1 || air_agents != 1) {
        throw InputError("a mission has one ground agent and one air agent, not " + std::to_string(ground_agents) +
                         " and " + std::to_string(air_agents));
    }
}

}  // namespace waybreaker

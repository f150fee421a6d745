#include "model/abilities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

bool is_breacher(const Agent& agent) {
    return agent.kind == AgentKind::air ? agent.breaches > 0 : agent.own_breaches > 0;
}

bool is_breachable(const Mission& mission, const Obstacle& obstacle) {
    return std::ranges::any_of(mission.agents, [&](const Agent& agent) {
        return is_breacher(agent) && std::isfinite(time_to_breach(agent, obstacle, mission.rules));
    });
}

void validate_choice(const Map& map, const Agent& agent, const CanBreach& can) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(ErrorCode::out_of_range, agent.id, "the " + agent.id + " agent can breach " + why);
    };
    if (can.most_cells == 0) refuse("obstacles of no cells: at least 1");
    for (const ObstacleId id : can.only.value_or(std::vector<ObstacleId>())) {
        if (!id || id.value > map.obstacles().size())
            refuse("obstacle " + std::to_string(id.value) + ", which is not on the map");
    }
}

}  // namespace

double time_to_breach(const Agent& agent, const Obstacle& obstacle, const Rules& rules) {
    if (const auto& can = agent.can_breach) {
        const bool is_named = !can->only || std::ranges::find(*can->only, obstacle.id) != can->only->end();
        if (obstacle.cells > can->most_cells || !is_named) return std::numeric_limits<double>::infinity();
    }
    const BreachTime time{agent.breach_time.value_or(rules.breach_time.per_obstacle),
                          agent.breach_time_per_cell.value_or(rules.breach_time.per_cell)};
    return time.of(obstacle);
}

void validate_abilities(const Map& map, const Mission& mission) {
    for (const Agent& agent : mission.agents) {
        const std::string of_agent = " of the " + agent.id + " agent";
        require_range(agent.reach, 0, most_reach, "the reach" + of_agent);
        require_range(agent.breach_time.value_or(0), 0, most_breach_time, "the time of a breach" + of_agent);
        require_range(agent.breach_time_per_cell.value_or(0), 0, most_breach_time,
                      "the time of a breach for each cell" + of_agent);
        if (agent.kind == AgentKind::air && agent.reach != 1)
            throw InputError(ErrorCode::contradiction, agent.id,
                             "the " + agent.id + " agent flies: reach is for ground agents");
        if (agent.can_breach) validate_choice(map, agent, *agent.can_breach);
    }
    if (const ObstacleId id = forced_but_unbreachable(map, mission)) {
        const std::string name = std::to_string(id.value);
        throw InputError(ErrorCode::contradiction, name,
                         "obstacle " + name + " must be removed, but no agent can breach it");
    }
}

ObstacleId forced_but_unbreachable(const Map& map, const Mission& mission) {
    if (!mission.limits_breaches()) return {};
    for (const ObstacleId id : mission.rules.force) {
        if (!is_breachable(mission, map.obstacle(id))) return id;
    }
    return {};
}

Mission protecting_unbreachable(const Map& map, const Mission& mission) {
    Mission kept = mission;
    if (!mission.limits_breaches()) return kept;
    std::vector<ObstacleId>& protect = kept.rules.protect;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.gone() || !obstacle.destructible) continue;
        if (std::ranges::count(mission.rules.opened, obstacle.id, &TimedOpening::obstacle) > 0) continue;
        if (!is_breachable(mission, obstacle)) protect.push_back(obstacle.id);
    }
    std::ranges::sort(protect);
    protect.erase(std::unique(protect.begin(), protect.end()), protect.end());
    return kept;
}

void name_breacher(const Map& map, const Mission& mission, std::span<Breach> breaches) {
    for (Breach& breach : breaches) {
        if (!breach.by.empty()) continue;
        const Agent& aircraft = mission.first(AgentKind::air);
        breach.by = aircraft.id;
        breach.begun_at = breach.cleared_at - time_to_breach(aircraft, map.obstacle(breach.obstacle), mission.rules);
    }
}

}  // namespace waybreaker

// A simulation in small steps of time: looks at discs and at standing obstacles, and knows nothing of planner or
// checker.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

inline Point simulated_place(const std::vector<Waypoint>& path, double time) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        if (time < a.t || time >= b.t) continue;
        const double share = (time - a.t) / (b.t - a.t);
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    return {path.back().x, path.back().y};
}

// What has been breached by then; all that will be, where time does not count.
inline bool simulated_as_gone(const Mission& mission, const Plan& plan, ObstacleId obstacle, double time) {
    const bool ignores = mission.rules.timing == Timing::ignore;
    const auto opens = std::ranges::find(mission.rules.opened, obstacle, &TimedOpening::obstacle);
    if (opens != mission.rules.opened.end() && (ignores || opens->at <= time)) return true;
    return std::ranges::any_of(plan.breaches, [&](const Breach& breach) {
        return breach.obstacle == obstacle && (mission.rules.timing == Timing::ignore || breach.cleared_at <= time);
    });
}

// How deep a disc is in the blocked cell that it is deepest in.
template <class Gone>
double simulated_depth(const Map& map, Point at, double radius, Gone gone) {
    double depth = 0;
    for (int y = -1; y <= map.height(); ++y) {
        for (int x = -1; x <= map.width(); ++x) {
            const bool inside = map.grid().contains({x, y});
            if (inside && (!map.grid().blocked({x, y}) || gone(map.obstacle_at({x, y})))) continue;
            const double dx = std::max(std::abs(at.x - x) - 0.5, 0.0);
            const double dy = std::max(std::abs(at.y - y) - 0.5, 0.0);
            depth = std::max(depth, radius - std::hypot(dx, dy));
        }
    }
    return depth;
}

// Whether an agent is anywhere: who is on its way already comes later, and who leaves is gone.
inline bool simulated_as_there(const Mission& mission, const Itinerary& agent, double time) {
    if (time < agent.path.front().t) return false;
    return mission.rules.at_goal == AtGoal::stay || time < agent.path.back().t;
}

// What goes wrong while the ground agents drive, seen every `step` units of time, or less often in a plan so long that
// it would take for ever; empty if nothing does.
inline std::string simulate(const Map& map, const Mission& mission, const Plan& plan, double step) {
    constexpr double slack = 1e-6;
    constexpr double most_steps = 20'000;
    double end = 0;
    for (const Itinerary& agent : plan.agents) end = std::max(end, agent.path.back().t);
    step = std::max(step, end / most_steps);
    for (double time = 0; time < end + 2 * step; time += step) {
        const auto is_gone = [&](ObstacleId id) { return simulated_as_gone(mission, plan, id, time + slack); };
        for (std::size_t i = 0; i < plan.agents.size(); ++i) {
            if (plan.agents[i].kind == AgentKind::air) continue;
            if (!simulated_as_there(mission, plan.agents[i], time)) continue;
            const double radius = mission.agents[i].body.radius;
            const Point at = simulated_place(plan.agents[i].path, time);
            if (simulated_depth(map, at, radius, is_gone) > slack) return plan.agents[i].id + " is in a wall";
            for (std::size_t j = 0; j < i; ++j) {
                if (plan.agents[j].kind == AgentKind::air) continue;
                if (!simulated_as_there(mission, plan.agents[j], time)) continue;
                const double needed = radius + mission.agents[j].body.radius + mission.rules.separation;
                if (distance(at, simulated_place(plan.agents[j].path, time)) < needed - slack) {
                    return plan.agents[j].id + " and " + plan.agents[i].id + " overlap at " + std::to_string(time);
                }
            }
        }
    }
    return "";
}

}  // namespace waybreaker

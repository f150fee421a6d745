// Plans made by hand: paths in, and the figures that follow from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "waybreaker/check.hpp"

namespace waybreaker {

inline double way(const std::vector<Waypoint>& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        sum += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    }
    return sum;
}

// The path without waits at that speed.
inline std::vector<Waypoint> driven(const std::vector<Point>& path, double speed = 1) {
    std::vector<Waypoint> points;
    for (const Point& p : path) {
        const double t =
            points.empty() ? 0 : points.back().t + std::hypot(p.x - points.back().x, p.y - points.back().y) / speed;
        points.push_back({p.x, p.y, t});
    }
    return points;
}

inline Itinerary agent(AgentKind kind, const std::vector<Waypoint>& path, double speed = 1) {
    return {.id = kind == AgentKind::ground ? "ground" : "air",
            .kind = kind,
            .speed = speed,
            .path = path,
            .start = {int(path.front().x), int(path.front().y)},
            .goal = {int(path.back().x), int(path.back().y)}};
}

// Sets what follows from the agents' paths. Precondition: agents[0] is the ground agent.
inline void set_figures(Plan& plan) {
    const Itinerary& ground = plan.agents[0];
    const Itinerary& air = plan.agents[1];
    plan.after.ground().length = way(ground.path);
    plan.after.air().length = way(air.path);
    plan.after.makespan = std::max(ground.path.back().t, air.path.back().t);
    plan.after.flowtime = ground.path.back().t + air.path.back().t;
}

// A plan in which nobody could have got there without removals.
inline Plan hand_made(const std::vector<Waypoint>& ground, const std::vector<Waypoint>& air,
                      const std::vector<Breach>& removed = {}) {
    Plan plan;
    plan.status = PlanStatus::solved;
    plan.agents = {agent(AgentKind::ground, ground), agent(AgentKind::air, air)};
    plan.breaches = removed;
    plan.before.air().length = std::hypot(air.back().x - air.front().x, air.back().y - air.front().y);
    set_figures(plan);
    return plan;
}

// A mission with the plan's agents, so that nothing but the rules can be broken.
inline Mission mission_of(const Plan& plan, const Rules& rules = {}, const Body& body = {}) {
    Mission mission{{}, rules};
    for (const Itinerary& planned : plan.agents) {
        mission.agents.push_back({planned.id, planned.kind, planned.start, planned.goal, planned.speed, body});
    }
    return mission;
}

// Which rules a plan breaks. One made by hand may say nothing of orders.
inline std::set<Rule> broken_rules(const Map& map, const Mission& mission, const Plan& plan) {
    std::set<Rule> broken;
    for (const Violation& violation : check(map, mission, plan)) broken.insert(violation.rule);
    if (plan.orders.empty()) broken.erase(Rule::orders);
    return broken;
}
inline std::set<Rule> broken_rules(const Map& map, const Plan& plan, const Rules& rules = {}, const Body& body = {}) {
    return broken_rules(map, mission_of(plan, rules, body), plan);
}

}  // namespace waybreaker

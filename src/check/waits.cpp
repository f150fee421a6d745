// What a plan explains of ground agents: that they wait there and then, for what a wait of theirs can be for, and gain
// so much. Whether something else was in the way for longer is not asked.
#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

// Waits shorter than this are rounding, and so may their ends be off.
constexpr double millionth = 1e-6;

// Whether the path stands there all that time.
bool stands(const Itinerary& agent, const Wait& wait, double hair, const Terms& terms) {
    const auto is_there = [&](const Waypoint& point) {
        return std::hypot(point.x - wait.at.x, point.y - wait.at.y) <= terms.tolerance;
    };
    for (auto first = agent.path.begin(); first != agent.path.end(); ++first) {
        if (!is_there(*first)) continue;
        const auto end = std::find_if_not(first, agent.path.end(), is_there);
        if (first->t <= wait.from + hair && wait.until <= (end - 1)->t + hair) return true;
        first = end - 1;
    }
    return false;
}

// Of one ground and one air agent the plan does not say who breaches.
bool breaches(const Plan& plan, const Breach& breach, const std::string& agent) {
    if (!breach.by.empty()) return breach.by == agent;
    return std::any_of(plan.agents.begin(), plan.agents.end(),
                       [&](const Itinerary& one) { return one.kind == AgentKind::air && one.id == agent; });
}

bool is_removed(const Plan& plan, const Rules& rules, ObstacleId obstacle) {
    const auto is_it = [&](const auto& one) { return one.obstacle == obstacle; };
    return std::any_of(rules.opened.begin(), rules.opened.end(), is_it) ||
           std::any_of(plan.breaches.begin(), plan.breaches.end(), is_it);
}

// Whether a zone holds for an agent, and for a time only, until then or longer.
bool is_over_after(const Zone& zone, const Itinerary& agent, double time) {
    const bool is_meant =
        zone.agents.empty() || std::find(zone.agents.begin(), zone.agents.end(), agent.id) != zone.agents.end();
    return is_meant && zone.kind == ZoneKind::keep_out && zone.has_window() && zone.until >= time;
}

// Whether that can be in the way until then.
bool can_hinder(const Plan& plan, const Rules& rules, const Itinerary& agent, double ready_at, const Wait& wait,
                double hair) {
    const bool names_nobody = wait.agent.empty();
    const bool names_obstacle = wait.reason == WaitReason::opening || wait.reason == WaitReason::rubble;
    if (wait.obstacle && !names_obstacle) return false;
    if (wait.zone > 0 && wait.reason != WaitReason::zone) return false;
    switch (wait.reason) {
        case WaitReason::nothing:
            return names_nobody;
        case WaitReason::readiness:
            return names_nobody && wait.until <= ready_at + hair;
        case WaitReason::opening:
            if (names_nobody && std::any_of(rules.opened.begin(), rules.opened.end(), [&](const TimedOpening& opening) {
                    return opening.obstacle == wait.obstacle && wait.until <= opening.at + hair;
                }))
                return true;
            return std::any_of(plan.breaches.begin(), plan.breaches.end(), [&](const Breach& breach) {
                return breach.obstacle == wait.obstacle && wait.until <= breach.cleared_at + hair &&
                       breaches(plan, breach, wait.agent);
            });
        case WaitReason::rubble:
            return names_nobody && rules.rubble > 0 && is_removed(plan, rules, wait.obstacle);
        case WaitReason::zone:
            return names_nobody && wait.zone > 0 && wait.zone <= rules.zones.size() &&
                   is_over_after(rules.zones[wait.zone - 1], agent, wait.until - hair);
        case WaitReason::agent:
            return wait.agent != agent.id &&
                   std::any_of(plan.agents.begin(), plan.agents.end(), [&](const Itinerary& other) {
                       return other.kind == AgentKind::ground && other.id == wait.agent;
                   });
    }
    return false;
}

}  // namespace

Violations judge_waits(const Plan& plan, const Itinerary& agent, double ready_at, const Terms& terms) {
    Violations found;
    double before = 0;
    for (const Wait& wait : agent.waits) {
        if (found.size() > enough_violations) break;
        const double hair = slack(terms, wait.until) + millionth;
        const auto report = [&](const std::string& what) {
            found.push_back({Rule::waits,
                             "the " + agent.id + " agent is said to wait at " + text(wait.at) + " from " +
                                 text(wait.from) + " to " + text(wait.until) + what,
                             agent.id, wait.obstacle, wait.at, wait.from});
        };
        if (wait.from >= wait.until || wait.from < before - hair || !stands(agent, wait, hair, terms)) {
            report(", but does not stand there then");
        } else if (!can_hinder(plan, terms.rules, agent, ready_at, wait, hair)) {
            report(" for what is not in its way until then");
        }
        before = wait.until;
    }
    return found;
}

Violations judge_gain(const Itinerary& agent, double ready_at, const std::optional<double>& alone, const Terms& terms) {
    if (!agent.gain) return {};
    if (!alone || agent.kind == AgentKind::air) {
        return {{Rule::gain, "the " + agent.id + " agent is said to gain, but has no way without removals", agent.id}};
    }
    const double gain = ready_at + *alone / agent.speed - agent.path.back().t;
    if (agree(terms, *agent.gain, gain)) return {};
    return {
        {Rule::gain, "the " + agent.id + " agent gains " + text(*agent.gain) + " instead of " + text(gain), agent.id}};
}

}  // namespace waybreaker::checker

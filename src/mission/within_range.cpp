#include "mission/within_range.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/stopwatch.hpp"
#include "mission/explain.hpp"
#include "model/bases.hpp"
#include "model/in_range.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double share_of_first = 0.5;       // of the time
constexpr double share_of_recharging = 0.7;  // of what is left, before nobody recharges

Mission without_ranges(Mission mission) {
    for (Agent& agent : mission.agents) {
        agent.range = agent.endurance = infinity;
        agent.reserve = agent.flown = 0;
        agent.recharge.reset();
        agent.bases.clear();
    }
    return mission;
}

// Aircraft never wait: who lands in time has flown no farther.
bool keeps_range(const Mission& mission, const Plan& plan) {
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Agent& agent = mission.agents[i];
        const std::vector<Waypoint>& path = plan.agents[i].path;
        if (agent.kind == AgentKind::air && !keeps_battery(agent, path, recharges_on(agent, path, plan.breaches)))
            return false;
    }
    return true;
}

// Where some recharge, and all get home without: the mission in which nobody does.
std::optional<Mission> flown_once(const Mission& mission) {
    Mission once = mission;
    bool recharges = false;
    for (Agent& agent : once.agents) {
        recharges = recharges || agent.recharge;
        agent.recharge.reset();
        agent.bases.clear();
        const double flight = agent.airspace.length(agent.begin(), agent.goal) / agent.speed;
        if (agent.kind == AgentKind::air && !agent.may_land_at(agent.ready_at + flight)) return std::nullopt;
    }
    return recharges ? std::optional(std::move(once)) : std::nullopt;
}

double reached_by(const Mission& mission, const Plan& plan) {
    return value(plan.after, mission.rules.objective).value_or(infinity);
}

// What is proven of flights of any length holds of shorter ones.
void raise_bound(const Mission& mission, const std::optional<double>& proven, Plan& plan) {
    if (!proven || plan.status != PlanStatus::solved) return;
    const double reached = reached_by(mission, plan);
    plan.bound = std::min(std::max(plan.bound.value_or(0), *proven), reached);
    plan.gap = *plan.bound > 0 ? reached / *plan.bound - 1 : 0;
}

}  // namespace

Plan within_range(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                  const MissionPlanner& planned, Evaluated* evaluated) {
    if (!mission.limits_flights()) return planned(mission, method, limits);
    const Stopwatch total;
    const Deadline deadline(limits.seconds);
    Method plain = method;
    plain.explain = false;
    const auto in_time = [&](double share) {
        Limits left = limits;
        left.seconds = std::max(deadline.left() * share, 1e-3);
        left.progress = nullptr;
        return left;
    };
    Plan plan = planned(without_ranges(mission), plain, in_time(share_of_first));
    std::vector<Breach> beyond;  // what is opened where aircraft can fly any distance
    if (keeps_range(mission, plan)) {
        if (plan.status == PlanStatus::solved && limits.progress)
            limits.progress({reached_by(mission, plan), plan.bound.value_or(0)});
    } else {
        if (evaluated != nullptr) evaluated->plans.clear();
        beyond = std::move(plan.breaches);
        const std::optional<Mission> once = flown_once(mission);
        Limits left = in_time(once ? share_of_recharging : 1);
        left.progress = limits.progress;
        Plan kept = planned(protecting_out_of_range(map, mission), plain, left);
        raise_bound(mission, plan.bound, kept);
        if (once) {
            Plan other = planned(protecting_out_of_range(map, *once), plain, in_time(1));
            if (reached_by(mission, other) < reached_by(mission, kept)) {
                other.bound = std::nullopt;
                raise_bound(mission, kept.bound ? kept.bound : plan.bound, other);
                kept = std::move(other);
            }
        }
        kept.limit_reached = kept.limit_reached || plan.limit_reached;
        plan = std::move(kept);
    }
    if (evaluated != nullptr)
        std::erase_if(evaluated->plans, [&](const Plan& other) { return !keeps_range(mission, other); });
    const std::size_t others = evaluated != nullptr ? evaluated->plans.size() : 0;
    if (method.explain && plan.status == PlanStatus::solved) {
        const auto again = [&](const Mission& other, const Limits& left) { return planned(other, plain, left); };
        explain_team(map, protecting_out_of_range(map, mission), limits, deadline, again, plan);
        for (const Breach& breach : beyond) {
            if (auto why = out_of_range(map, mission, breach.obstacle)) plan.out_of_range.push_back(std::move(*why));
        }
    }
    if (evaluated != nullptr) evaluated->plans.resize(others);
    plan.seconds.total = total.seconds();
    return plan;
}

}  // namespace waybreaker

#include "mission/late_openings.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/stopwatch.hpp"
#include "mission/explain.hpp"
#include "mission/instead.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

// Whether an agent stands, and has not got farther than to the next point of its path by then.
bool stands_before(const std::vector<Waypoint>& path, double time) {
    for (std::size_t i = 1; i < path.size() && path[i - 1].t < time; ++i) {
        const bool stands = path[i].x == path[i - 1].x && path[i].y == path[i - 1].y && path[i].t > path[i - 1].t;
        if (stands && path[std::min(i + 1, path.size() - 1)].t >= time) return true;
    }
    return false;
}

// Whether a ground agent waits for it: enters it at once, or stands before it opens and nobody ever enters it.
bool is_waited_for(const Map& map, const Mission& mission, const Plan& plan, const TimedOpening& opening) {
    const double opens = opening.at + 1e-6 * (1 + opening.at);
    bool is_entered = false;
    bool is_stood_by = false;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Itinerary& agent = plan.agents[i];
        if (agent.kind == AgentKind::air) continue;
        const double radius = standing_radius(mission.agents[i].body);
        const auto touched = first_touch(map, opening.obstacle, agent.path, radius);
        if (touched && *touched <= opens) return true;
        is_entered = is_entered || touched;
        is_stood_by = is_stood_by || stands_before(agent.path, opening.at);
    }
    return is_stood_by && !is_entered;
}

// Of what opens by itself, the last that a ground agent waits for; and what opens when all have arrived.
std::vector<ObstacleId> late_for(const Map& map, const Mission& mission, const Plan& plan) {
    double arrived = 0;
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind == AgentKind::ground) arrived = std::max(arrived, agent.path.back().t);
    }
    double latest = -1;
    ObstacleId waited_for;
    for (const TimedOpening& opening : mission.rules.opened) {
        if (opening.at <= latest || !is_waited_for(map, mission, plan, opening)) continue;
        latest = opening.at;
        waited_for = opening.obstacle;
    }
    // Where no plan was found, the last of all.
    const auto& opened = mission.rules.opened;
    const auto last = std::ranges::max_element(opened, {}, &TimedOpening::at);
    if (plan.status != PlanStatus::solved && last != opened.end()) return {last->obstacle};
    std::vector<ObstacleId> late;
    for (const TimedOpening& opening : opened) {
        const bool is_useless = opening.at >= arrived;
        if (is_useless || opening.obstacle == waited_for) late.push_back(opening.obstacle);
    }
    return late;
}

bool says_gains(const Plan& plan) {
    return std::ranges::any_of(plan.agents, [](const Itinerary& agent) { return agent.gain.has_value(); });
}

}  // namespace

Plan around_late(const Map& map, Mission mission, const Limits& limits,
                 const std::function<Plan(const Mission&, double)>& planned) {
    const Deadline deadline(limits.seconds);
    Plan best = planned(mission, limits.seconds);
    if (mission.rules.opened.empty() || mission.rules.timing == Timing::ignore) return best;
    const auto reached = [&](const Plan& plan) {
        return value(plan.after, mission.rules.objective).value_or(std::numeric_limits<double>::infinity());
    };
    std::vector<ObstacleId> late = late_for(map, mission, best);
    while (!late.empty() && best.gap.value_or(1) > 1e-9 && !deadline.passed()) {
        for (const ObstacleId id : late) {
            std::erase_if(mission.rules.opened, [id](const TimedOpening& opening) { return opening.obstacle == id; });
            mission.rules.protect.push_back(id);
        }
        Plan other = planned(mission, deadline.left());
        late = late_for(map, mission, other);
        if (!(reached(other) < reached(best) * (1 - 1e-9))) continue;
        const bool explained = says_gains(best) || says_gains(other);
        other.before = best.before;
        if (explained) explain_agents(mission, other);
        best = instead(best, std::move(other), mission.rules.objective);
    }
    return best;
}

}  // namespace waybreaker

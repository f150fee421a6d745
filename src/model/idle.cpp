#include "model/idle.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/abilities.hpp"
#include "model/bases.hpp"
#include "model/objective.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

double flight_time(const Agent& agent) {
    return agent.ready_at + way_home(agent).lasts;
}

}  // namespace

ActivePart::ActivePart(const Mission& mission) : whole_(mission), active_{{}, mission.rules} {
    const auto is_idle = [](const Agent& agent) { return agent.kind == AgentKind::air && agent.breaches == 0; };
    const auto drives = [](const Agent& agent) { return agent.kind == AgentKind::ground; };
    const auto flies = [](const Agent& agent) { return agent.kind == AgentKind::air; };
    const bool one_drives = std::ranges::count_if(mission.agents, drives) == 1;
    for (const Agent& agent : mission.agents) idle_.push_back(is_idle(agent));
    const bool none_active = std::ranges::count_if(mission.agents, flies) == std::ranges::count(idle_, true);
    if (one_drives && none_active && !mission.clears()) {
        const auto kept = std::ranges::find_if(mission.agents, flies);
        if (kept != mission.agents.end()) idle_[std::size_t(kept - mission.agents.begin())] = false;
    }
    for (std::size_t i = 0; i < idle_.size(); ++i) {
        const Agent& agent = mission.agents[i];
        if (!idle_[i]) {
            active_.agents.push_back(agent);
            continue;
        }
        last_idle_ = std::max(last_idle_, flight_time(agent));
        sum_of_idle_ += weighted(agent.weight, flight_time(agent));
    }
    if (!one_drives) return;
    const bool is_pair = active_.agents.size() == 2 && !active_.clears();
    Rules more = active_.rules;
    ++more.removals;
    cut_ = Mission{active_.agents, more}.removals_allowed() < more.removals;
    active_.rules.removals = active_.removals_allowed();
    for (Agent& agent : active_.agents) {
        if (is_pair) agent.breaches = any_number;
    }
}

double ActivePart::with_idle(double objective) const {
    switch (whole_.rules.objective) {
        case Objective::makespan:
            return std::max(objective, last_idle_);
        case Objective::flowtime:
            return objective + sum_of_idle_;
        case Objective::ground_makespan:
            break;
    }
    return objective;
}

// The active agents of that kind, in order, as places in the whole mission.
std::vector<std::size_t> ActivePart::places_of(AgentKind kind) const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < idle_.size(); ++i) {
        if (!idle_[i] && whole_.agents[i].kind == kind) places.push_back(i);
    }
    return places;
}

void ActivePart::add_idle(Outcome& outcome) const {
    std::vector<Route> routes(whole_.agents.size());
    for (std::size_t i = 0; i < idle_.size(); ++i) {
        if (!idle_[i]) continue;
        const Agent& agent = whole_.agents[i];
        routes[i].kind = AgentKind::air;
        routes[i].path = route_home(agent);
        routes[i].length = path_length(routes[i].path);
    }
    for (const AgentKind kind : {AgentKind::ground, AgentKind::air}) {
        const std::vector<std::size_t> places = places_of(kind);
        auto place = places.begin();
        for (Route& route : outcome.routes) {
            if (route.kind == kind) routes[*place++] = std::move(route);
        }
    }
    outcome.routes = std::move(routes);
    if (outcome.makespan) outcome.makespan = std::max(*outcome.makespan, last_idle_);
    if (outcome.flowtime) *outcome.flowtime += sum_of_idle_;
}

Plan ActivePart::whole(const Map& map, Plan plan) const {
    if (cut_) plan.next.clear();
    if (all_active()) return plan;
    const auto reached = value(plan.after, whole_.rules.objective);
    for (Breach& breach : plan.breaches) {
        if (breach.saves && reached) breach.saves = with_idle(*reached + *breach.saves) - with_idle(*reached);
    }
    name_breacher(map, active_, plan.breaches);
    std::erase_if(plan.next, [&](NextBreach& next) {
        next.saves = with_idle(*reached) - with_idle(*reached - next.saves);
        return next.saves <= 0;
    });
    if (!plan.agents.empty()) {
        std::vector<Itinerary> agents;
        auto active = plan.agents.begin();
        for (std::size_t i = 0; i < idle_.size(); ++i) {
            const Agent& agent = whole_.agents[i];
            agents.push_back(
                idle_[i] ? Itinerary{agent.id, agent.kind, agent.speed, flight_home(agent), agent.start, agent.goal}
                         : std::move(*active++));
        }
        plan.agents = std::move(agents);
    }
    add_idle(plan.before);
    add_idle(plan.after);
    if (plan.bound) {
        plan.bound = with_idle(*plan.bound);
        const std::optional<double> with_all = value(plan.after, whole_.rules.objective);
        if (plan.gap && with_all) plan.gap = *plan.bound > 0 ? *with_all / *plan.bound - 1 : 0;
    }
    return plan;
}

}  // namespace waybreaker

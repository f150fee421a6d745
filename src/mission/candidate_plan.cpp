#include "mission/candidate_plan.hpp"

#include "mission/plan_status.hpp"
#include "model/idle.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

// Calls visit(agent, aircraft) for each agent; which of the task's aircraft it is, if it is one.
void for_each_agent(const Mission& mission, const auto& visit) {
    std::size_t aircraft = 0;
    for (const Agent& agent : mission.agents) {
        visit(agent, aircraft);
        if (agent.kind == AgentKind::air) ++aircraft;
    }
}

Route flight(const Agent& agent, std::size_t aircraft, const JointSchedule& schedule) {
    Route route{AgentKind::air};
    if (agent.recharge) {
        route.path = places(schedule.air[aircraft]);
        route.length = path_length(route.path);
        return route;
    }
    std::vector<Point> stops{agent.begin()};
    for (const TimedBreach& breach : schedule.breaches) {
        if (breach.aircraft == aircraft) stops.emplace_back(breach.at);
    }
    stops.emplace_back(agent.goal);
    route.path = agent.airspace.way_past(stops);
    route.length = path_length(route.path);
    return route;
}

std::vector<Itinerary> itineraries(const Mission& mission, const JointSchedule& schedule) {
    std::vector<Itinerary> agents;
    for_each_agent(mission, [&](const Agent& agent, std::size_t aircraft) {
        const std::vector<Waypoint>& path = agent.kind == AgentKind::ground ? schedule.ground : schedule.air[aircraft];
        agents.push_back({agent.id, agent.kind, agent.speed, path, agent.start, agent.goal});
    });
    return agents;
}

std::vector<Breach> breaches(const Task& task, const JointSchedule& schedule, std::span<const std::uint32_t> hits) {
    std::vector<Breach> breaches;
    for (const TimedBreach& made : schedule.breaches) {
        const Obstacle& obstacle = task.map.obstacle(made.obstacle);
        Breach& breach = breaches.emplace_back();
        breach.obstacle = obstacle.id;
        breach.source_id = obstacle.source_id;
        breach.cells = obstacle.cells;
        breach.hits = hits.empty() ? 0 : hits[obstacle.id.value];
        breach.at = made.at;
        breach.cleared_at = made.cleared_at;
        breach.entered_at = made.entered_at;
        if (task.aircraft.size() == 1) continue;  // nobody has to be told who
        breach.by = task.opens_own_way() ? task.driver.id : task.aircraft[made.aircraft]->id;
        breach.begun_at = made.begun_at;
    }
    return breaches;
}

}  // namespace

Outcome outcome_of(const Mission& mission, const Candidate& candidate) {
    Outcome result;
    result.routes.clear();
    for_each_agent(mission, [&](const Agent& agent, std::size_t aircraft) {
        result.routes.push_back(agent.kind == AgentKind::ground ? candidate.opening.ground
                                                                : flight(agent, aircraft, candidate.schedule));
    });
    if (candidate.opening.ground.length) {
        const Finish finish = finish_of(candidate.schedule.arrival(), candidate.schedule.home);
        result.makespan = finish.makespan();
        result.flowtime = finish.flowtime;
        result.ground_makespan = finish.ground;
    }
    return result;
}

Plan plan_of(const Task& task, const Mission& mission, const Candidate& candidate,
             std::span<const std::uint32_t> hits) {
    Plan plan;
    plan.status = plan_status(candidate.opening.status);
    plan.after = outcome_of(mission, candidate);
    plan.breaches = breaches(task, candidate.schedule, hits);
    if (plan.status == PlanStatus::solved) plan.agents = itineraries(mission, candidate.schedule);
    return plan;
}

}  // namespace waybreaker

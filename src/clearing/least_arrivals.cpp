#include "clearing/least_arrivals.hpp"

#include <algorithm>
#include <limits>

#include "clearing/tuning.hpp"
#include "map/gap.hpp"
#include "model/objective.hpp"

namespace waybreaker::clearing {
namespace {

std::vector<ObstacleId> obstacles_in(std::span<const TimedOpening> openings) {
    std::vector<ObstacleId> ids;
    for (const TimedOpening& opening : openings) ids.push_back(opening.obstacle);
    std::ranges::sort(ids);
    return ids;
}

}  // namespace

CrossingOptions LeastArrivals::options_for(const Agent& agent) const {
    CrossingOptions options;
    options.body = agent.body.is_point() ? point_body : agent.body;
    options.relaxed = true;
    options.limits = {.seconds = std::max(deadline_.left() * tuning::share_of_plan, 1e-3),
                      .expansions = limits_.expansions,
                      .stop = limits_.stop};
    return options;
}

// Of the way past what is removed and what opens by itself.
double LeastArrivals::length(std::size_t vehicle, std::vector<ObstacleId> removed) {
    for (const TimedOpening& opening : mission_.rules.opened) removed.push_back(opening.obstacle);
    const auto [known, is_new] = lengths_.try_emplace(std::pair(vehicle, removed), 0.0);
    if (!is_new) return known->second;
    const Agent& agent = mission_.agents[vehicle];
    CrossingOptions options = options_for(agent);
    options.removed = removed;
    const CrossingResult found = searchers_.crossing.find(map_, agent.start, agent.goal, options);
    known->second = found.status == SearchStatus::no_path ? infinity : found.lower_bound;
    return known->second;
}

double LeastArrivals::objective(std::span<const double> arrivals) const {
    Finish finish;
    for (std::size_t i = 0; i < arrivals.size(); ++i) {
        const Agent& agent = mission_.agents[i];
        if (agent.kind == AgentKind::air) continue;
        finish.add(agent, std::min(arrivals[i], unreached_at(mission_.rules, agent)));
    }
    return rank(mission_.rules.objective, finish).first;
}

double LeastArrivals::of_any() {
    const std::vector<ObstacleId> opened = obstacles_in(mission_.rules.opened);
    std::vector<double> arrivals;
    for (const Agent& agent : mission_.agents) {
        arrivals.push_back(0);
        if (agent.kind == AgentKind::air) continue;
        CrossingOptions options = options_for(agent);
        options.crossings = mission_.removals_allowed();
        options.removed = opened;
        const CrossingResult found = searchers_.crossing.find(map_, agent.start, agent.goal, options);
        arrivals.back() = agent.ready_at + found.lower_bound / agent.speed;
    }
    return objective(arrivals);
}

double LeastArrivals::arrival(std::size_t vehicle, std::span<const TimedOpening> removed, const Agent& left) {
    const Agent& agent = mission_.agents[vehicle];
    const double past_all = agent.ready_at + length(vehicle, obstacles_in(removed)) / agent.speed;
    const double straight = left.ready_at + distance(left.start, left.goal) / left.speed;
    if (agent.own_breaches > 0) return std::max(past_all, straight);
    // Through one of them, once that is open, or around all.
    double through = infinity;
    for (const TimedOpening& opening : removed) {
        const double beyond = gap(map_.obstacle(opening.obstacle).bounds, agent.goal) - agent.body.reach() - 1;
        through = std::min(through, opening.at + std::max(beyond, 0.0) / agent.speed);
    }
    if (through <= past_all) return past_all;
    const double around = agent.ready_at + length(vehicle, {}) / agent.speed;
    return std::min(around, through);
}

double LeastArrivals::of(std::span<const TimedOpening> removed, std::span<const Agent> agents) {
    std::vector<double> arrivals;
    for (std::size_t i = 0; i < agents.size(); ++i)
        arrivals.push_back(agents[i].kind == AgentKind::air ? 0 : arrival(i, removed, agents[i]));
    return objective(arrivals);
}

}  // namespace waybreaker::clearing

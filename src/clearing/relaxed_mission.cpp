#include "clearing/relaxed_mission.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "clearing/standing_place.hpp"

namespace waybreaker::clearing {
namespace {

// The longest way from a place at which a vehicle breaches an obstacle to a cell of the obstacle's boundary: to the
// obstacle, and from there to the middle of the cell beside it.
double to_boundary(const Agent& vehicle) {
    return vehicle.body.reach() + reach + std::numbers::sqrt2 / 2;
}

// What a time counts for that is lost by all.
double weight_of_all(const Mission& mission) {
    if (mission.rules.objective != Objective::flowtime) return 1;
    double weight = 0;
    for (const Agent& agent : mission.agents) weight += agent.weight;
    return weight;
}

}  // namespace

// No agent of a mission has a line break in its id.
std::string breacher_for(const Agent& vehicle) {
    return "\n" + vehicle.id;
}

RelaxedMission relaxed(const Mission& mission) {
    RelaxedMission relaxed{mission};
    double saved = 0;  // by an aircraft that is nearer, on each breach
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        const Agent& vehicle = mission.agents[i];
        if (vehicle.own_breaches == 0) continue;
        relaxed.mission.agents[i].own_breaches = 0;
        Agent breacher = aircraft(breacher_for(vehicle), vehicle.start, vehicle.goal);
        breacher.speed = vehicle.speed;
        breacher.ready_at = vehicle.ready_at;
        breacher.weight = 0;
        breacher.breaches = vehicle.own_breaches;
        relaxed.mission.agents.push_back(std::move(breacher));
        saved = std::max(saved, 2 * to_boundary(vehicle) / vehicle.speed);
    }
    // It is taken from the time of a breach, as far as that goes.
    double& of_breach = relaxed.mission.rules.breach_time.per_obstacle;
    const double taken = std::min(of_breach, saved);
    of_breach -= taken;
    relaxed.allowance = weight_of_all(mission) * mission.removals_allowed() * (saved - taken);
    return relaxed;
}

}  // namespace waybreaker::clearing

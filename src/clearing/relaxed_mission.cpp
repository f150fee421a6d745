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
    return vehicle.body.reach() + vehicle.reach + std::numbers::sqrt2 / 2;
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
    double left = 0;  // of what an aircraft that is nearer saves on each breach
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        const Agent& vehicle = mission.agents[i];
        if (vehicle.own_breaches == 0) continue;
        relaxed.mission.agents[i].own_breaches = 0;
        Agent breacher = aircraft(breacher_for(vehicle), vehicle.start, vehicle.goal);
        breacher.speed = vehicle.speed;
        breacher.ready_at = vehicle.ready_at;
        breacher.weight = 0;
        breacher.breaches = vehicle.own_breaches;
        breacher.can_breach = vehicle.can_breach;
        breacher.breach_time_per_cell = vehicle.breach_time_per_cell;
        // What it saves is taken from the time of a breach, as far as that goes.
        const double saved = 2 * to_boundary(vehicle) / vehicle.speed;
        const double of_breach = vehicle.breach_time.value_or(mission.rules.breach_time.per_obstacle);
        breacher.breach_time = std::max(of_breach - saved, 0.0);
        left = std::max(left, saved - (of_breach - *breacher.breach_time));
        relaxed.mission.agents.push_back(std::move(breacher));
    }
    relaxed.allowance = weight_of_all(mission) * mission.removals_allowed() * left;
    return relaxed;
}

}  // namespace waybreaker::clearing

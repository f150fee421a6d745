#include "team/in_lockstep.hpp"

#include <algorithm>

#include "lockstep/lockstep.hpp"
#include "team/tuning.hpp"

namespace waybreaker::team {
namespace {

bool are_alike(std::span<const Vehicle> vehicles) {
    return std::ranges::all_of(vehicles, [first = vehicles.front().agent](const Vehicle& vehicle) {
        const Agent& agent = vehicle.agent;
        return agent.body.radius == first.body.radius && agent.body.corners == first.body.corners &&
               agent.speed == first.speed && agent.ready_at == first.ready_at && agent.approach.empty();
    });
}

// A step from cell to cell takes as long as the agent needs for it.
Path timed(std::span<const Cell> cells, const Agent& agent) {
    Path path{{double(agent.start.x), double(agent.start.y), 0}};
    if (agent.ready_at > 0) path.push_back({path.front().x, path.front().y, agent.ready_at});
    for (std::size_t i = 1; i < cells.size(); ++i) {
        const bool goes_on = i + 1 < cells.size() && cells[i + 1].x - cells[i].x == cells[i].x - cells[i - 1].x &&
                             cells[i + 1].y - cells[i].y == cells[i].y - cells[i - 1].y;
        if (!goes_on)
            path.push_back({double(cells[i].x), double(cells[i].y), agent.ready_at + double(i) / agent.speed});
    }
    return path;
}

}  // namespace

bool move_in_lockstep(const Ground& ground, std::span<const Vehicle> vehicles, const Rules& rules,
                      const Interrupts& interrupts, Fleet& fleet) {
    if (!ground.openings.empty() || ground.rubble > 0 || !are_alike(vehicles)) return false;
    std::vector<lockstep::Trip> trips;
    for (const Vehicle& vehicle : vehicles) trips.push_back({vehicle.agent.start, vehicle.agent.goal});
    const Agent& any = vehicles.front().agent;
    const double apart = 2 * any.body.reach() + rules.separation;
    const Deadline deadline = interrupts.deadline.share(tuning::share_of_lockstep);
    const auto due = [&] { return interrupts.stop.stop_requested() || deadline.passed(); };
    const auto routes = lockstep::move_in_lockstep(
        ground.map, any.body, apart, trips,
        rules.objective == Objective::flowtime ? lockstep::Aim::sum : lockstep::Aim::last, due);
    if (!routes) return false;
    for (std::uint32_t i = 0; i < fleet.size(); ++i) fleet.withdraw(i);
    for (std::uint32_t i = 0; i < fleet.size(); ++i) fleet.put(i, timed((*routes)[i], vehicles[i].agent));
    return true;
}

}  // namespace waybreaker::team

#include "team/team.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "drive/centres.hpp"
#include "model/objective.hpp"
#include "safe_interval/driven.hpp"
#include "team/in_lockstep.hpp"
#include "team/neighbourhoods.hpp"
#include "team/tuning.hpp"

namespace waybreaker::team {
namespace {

// Short ways first where all arrivals count: they lose little on others, and others little on them. Where the last
// arrival counts, the longest way first.
std::vector<std::uint32_t> order_of(std::span<const Vehicle> vehicles, Objective objective) {
    std::vector<std::uint32_t> order(vehicles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return objective == Objective::flowtime ? vehicles[a].alone < vehicles[b].alone
                                                : vehicles[a].alone > vehicles[b].alone;
    });
    return order;
}

// Prioritised planning: one vehicle after the other, past those planned before. Where that leaves a few without a way,
// their neighbourhoods are replanned. If that does not help, or they are many, they come first in another round, as
// AA-SIPP(m) does (Andreychuk, Yakovlev: Two techniques that enhance the performance of multi-robot prioritized path
// planning, AAMAS 2018). A round is soon over, and replanning takes as long as several: at first, rounds come before
// it. Where the first round leaves too many without a way, vehicles crowd each other: if they are alike, they move in
// lockstep, and then each as early as it can. Ends with a path for each, or after a number of rounds.
void plan_all(const Ground& ground, const TeamPlan& plan, const Rules& rules, const Interrupts& interrupts,
              Fleet& fleet, NeighbourhoodSearch& search) {
    constexpr double any_time = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> order = order_of(plan.vehicles, rules.objective);
    const std::size_t most_missing = order.size() / tuning::share_missing + 1;
    const std::size_t most_missing_at_first = std::min(most_missing, tuning::most_missing_at_first);
    for (int round = 0; round < tuning::most_rounds && !interrupts.due(); ++round) {
        if (round == 1 && move_in_lockstep(ground, plan.vehicles, rules, interrupts, fleet)) {
            search.shorten_waits();
            return;
        }
        for (const std::uint32_t i : order) {
            if (!fleet.plan(i, any_time)) fleet.hold_longer(i);
        }
        if (fleet.cost().missing <= (round < tuning::first_rounds ? most_missing_at_first : most_missing))
            search.repair();
        if (fleet.cost().missing == 0) return;
        std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) { return !fleet.has_path(i); });
        for (const std::uint32_t i : order) fleet.withdraw(i);
    }
}

// The objective if each vehicle arrived at that time of its own.
double objective_of(std::span<const Vehicle> vehicles, double Vehicle::*arrival, Objective objective) {
    Finish finish;
    for (const Vehicle& vehicle : vehicles) finish.add(vehicle.agent, vehicle.*arrival);
    return rank(objective, finish).first;
}

// The relaxed body slips past what the disc must go around; where that is far, cell centres tell more.
void raise_bound(const OpenedMap& map, Vehicle& vehicle) {
    const Agent& agent = vehicle.agent;
    const double known = (vehicle.alone - agent.ready_at) * agent.speed;
    if (vehicle.way.empty() || !drives_by_crossing(agent.body) ||
        known <= worth_centres * (vehicle.bound - agent.ready_at) * agent.speed)
        return;
    const double least = least_through_centres(map, agent.start, agent.goal, agent.body, known, most_sight_lines);
    vehicle.bound = std::max(vehicle.bound, agent.ready_at + least / agent.speed);
}

// On its way as if it were alone, or at its start if it is not at its goal in time.
Path alone_on_its_way(const Ground& ground, const Vehicle& vehicle, const Rules& rules) {
    const Agent& agent = vehicle.agent;
    const SafeIntervalOptions options = driving(ground, vehicle);
    const double last = unreached_at(rules, agent);
    if (!vehicle.way.empty() && vehicle.way.back() == agent.goal) {
        Path path = safe_interval::driven(ground.map, vehicle.way, options);
        if (path.back().t <= last) return path;
    }
    const Waypoint start{double(agent.start.x), double(agent.start.y), options.since};
    return {start, {start.x, start.y, last}};
}

// Nobody is in anybody's way: each drives as if it were alone.
TeamPlan drive_alone(const Ground& ground, TeamPlan plan, const Rules& rules, const Interrupts& interrupts,
                     const Enough& enough, const std::function<void(const Cost&)>& improved) {
    for (const Vehicle& vehicle : plan.vehicles) {
        plan.paths.push_back(after_approach(vehicle.agent, alone_on_its_way(ground, vehicle, rules)));
    }
    plan.status = SearchStatus::found;
    improved(cost_of(plan.vehicles, plan.paths, rules.objective));
    enough(plan.vehicles);  // raises their bounds
    plan.limited = interrupts.due() || std::ranges::any_of(plan.vehicles, &Vehicle::limited);
    return plan;
}

}  // namespace

double objective_alone(std::span<const Vehicle> vehicles, Objective objective) {
    return objective_of(vehicles, &Vehicle::alone, objective);
}

TeamPlan plan_team(const OpenedMap& map, const Mission& mission, const Interrupts& interrupts,
                   CrossingSearcher& crossing, Searcher& theta, const std::function<void(const Cost&)>& improved) {
    TeamPlan plan;
    Ground ground{map, {}, mission.rules.rubble};
    if (mission.rules.timing == Timing::enforce) ground.openings = mission.rules.opened;
    for (const Agent& agent : mission.agents) {
        if (agent.kind != AgentKind::ground) continue;
        plan.vehicles.emplace_back().agent = agent;
        plan.status = go_alone(ground, interrupts, crossing, theta, plan.vehicles.back());
        count_unreached(mission.rules, plan.vehicles.back());
        const bool may_stay = plan.status == SearchStatus::no_path && mission.rules.unreached;
        if (plan.status != SearchStatus::found && !may_stay) return plan;
    }
    const auto enough = [&](std::span<Vehicle> vehicles) {
        const Deadline soon = interrupts.deadline.share(tuning::share_of_bounds);
        for (Vehicle& vehicle : vehicles) {
            if (interrupts.stop.stop_requested() || soon.passed()) break;
            raise_bound(map, vehicle);
        }
        if (interrupts.gap == 0) return 0.0;
        return objective_of(vehicles, &Vehicle::bound, mission.rules.objective) * (1 + interrupts.gap);
    };
    return plan_paths(ground, std::move(plan.vehicles), mission.rules, interrupts, enough, improved);
}

TeamPlan plan_paths(const Ground& ground, std::vector<Vehicle> vehicles, const Rules& rules,
                    const Interrupts& interrupts, const Enough& enough,
                    const std::function<void(const Cost&)>& improved) {
    TeamPlan plan;
    plan.vehicles = std::move(vehicles);
    if (!rules.collisions) return drive_alone(ground, std::move(plan), rules, interrupts, enough, improved);
    Fleet fleet(ground, plan.vehicles, rules, interrupts);
    NeighbourhoodSearch search(fleet, interrupts);
    plan_all(ground, plan, rules, interrupts, fleet, search);
    if (fleet.cost().missing > 0) {
        plan.status = interrupts.end_without_plan(false);
        return plan;
    }
    plan.status = SearchStatus::found;
    fleet.skip_standstill();
    improved(fleet.cost());
    search.improve(enough(plan.vehicles), [&] { improved(fleet.cost()); });
    fleet.skip_standstill();
    plan.limited = interrupts.due() || std::ranges::any_of(plan.vehicles, &Vehicle::limited);
    for (std::uint32_t i = 0; i < fleet.size(); ++i) plan.paths.push_back(fleet.path(i));
    return plan;
}

}  // namespace waybreaker::team

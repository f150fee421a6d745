#include "coalition/problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "map/gap.hpp"
#include "model/objective.hpp"

namespace waybreaker::coalition {

Set united(const Set& a, const Set& b) {
    Set both;
    std::ranges::set_union(a, b, std::back_inserter(both));
    return both;
}

double late_arrival(const Agent& agent, const Obstacle& obstacle, double opening) {
    const double left = gap(obstacle.bounds, agent.goal) - agent.body.reach() - 1;
    return opening + std::max(left, 0.0) / agent.speed;
}

bool contains(const Set& set, ObstacleId id) {
    return std::ranges::binary_search(set, id);
}

bool Problem::allows(std::span<const ObstacleId> set) const {
    if (set.size() > std::size_t(spare_removals_)) return false;
    double weight = 0;
    for (const ObstacleId id : set) weight += map_.obstacle(id).weight;
    return weight <= spare_budget_ * (1 + rounding);
}

Problem::Problem(const Map& map, const Mission& mission, const team::Interrupts& interrupts)
    : map_(map),
      mission_(mission),
      interrupts_(interrupts),
      forced_(mission.rules.force),
      earliest_(map.obstacles().size() + 1),
      asked_(map.obstacles().size() + 1) {
    std::int64_t capacity = 0;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::ground) {
            vehicles_.push_back(&agent);
        } else {
            aircraft_.push_back(&agent);
            capacity += agent.breaches;
        }
    }
    for (const Agent* vehicle : vehicles_) {
        const double price = mission.rules.rubble * vehicle->speed;
        rubble_prices_.emplace_back(price > 0 ? map.obstacles().size() + 1 : 0, price);
    }
    flight_weight_ = least_weight_of(aircraft_);
    const std::size_t must = forced_.size();
    for (const TimedOpening& opening : mission.rules.opened) opened_.push_back(opening.obstacle);
    std::ranges::sort(opened_);
    forced_.insert(forced_.end(), opened_.begin(), opened_.end());
    std::ranges::sort(forced_);
    const std::int64_t most =
        std::min({capacity, std::int64_t{mission.rules.removals}, std::int64_t(map.obstacles().size())});
    spare_removals_ = int(std::max<std::int64_t>(most - std::int64_t(must), 0));
    spare_budget_ = mission.rules.budget;
    for (const ObstacleId id : mission.rules.force) spare_budget_ -= map.obstacle(id).weight;
    least_openings_.assign(map.obstacles().size() + 1, infinity);
    short_detours_.assign(map.obstacles().size() + 1, infinity);
    least_breach_times_.assign(map.obstacles().size() + 1, infinity);
    for (const Obstacle& obstacle : map.obstacles()) {
        double& opening = least_openings_[obstacle.id.value];
        double& detour = short_detours_[obstacle.id.value];
        double& breach_time = least_breach_times_[obstacle.id.value];
        for (const Agent* agent : aircraft_) {
            const double stay = time_to_breach(*agent, obstacle, mission.rules);
            if (std::isinf(stay)) continue;
            breach_time = std::min(breach_time, stay);
            const double there =
                agent->ready_at + std::max(gap(obstacle.bounds, agent->begin()) - 1.5, 0.0) / agent->speed;
            const double home = std::max(gap(obstacle.bounds, agent->goal) - 1.5, 0.0) / agent->speed;
            opening = std::min(opening, there + stay);
            detour = std::min(detour, agent->weight * std::max(there + home - straight_flight(*agent), 0.0));
        }
        if (std::isinf(breach_time)) breach_time = detour = 0;
        if (mission.rules.timing == Timing::ignore) opening = 0;
    }
    for (const TimedOpening& opening : mission.rules.opened) {
        least_openings_[opening.obstacle.value] = mission.rules.timing == Timing::ignore ? 0 : opening.at;
        short_detours_[opening.obstacle.value] = 0;
        least_breach_times_[opening.obstacle.value] = 0;
    }
}

std::optional<double> Problem::given_opening(ObstacleId id) const {
    const auto found = std::ranges::find(rules().opened, id, &TimedOpening::obstacle);
    return found == rules().opened.end() ? std::nullopt : std::optional(found->at);
}

const Problem::Earliest& Problem::earliest(ObstacleId id) const {
    asked_[id.value].call([&] { earliest_[id.value] = find_earliest(id); });
    return earliest_[id.value];
}

Problem::Earliest Problem::find_earliest(ObstacleId id) const {
    if (const auto at = given_opening(id)) return {rules().timing == Timing::ignore ? 0 : *at, 0, 0};
    Earliest earliest;
    const std::vector<Cell> boundary = map_.boundary(id);
    for (const Agent* agent : aircraft_) {
        const double stay = time_to_breach(*agent, map_.obstacle(id), rules());
        if (std::isinf(stay)) continue;
        for (const Cell at : boundary) {
            const double there = agent->ready_at + distance(agent->begin(), at) / agent->speed + stay;
            earliest.opening = std::min(earliest.opening, there);
            const double home = there + distance(at, agent->goal) / agent->speed;
            earliest.home = std::min(earliest.home, home);
            earliest.detour = std::min(earliest.detour, agent->weight * (home - stay - straight_flight(*agent)));
        }
    }
    earliest.detour = std::max(earliest.detour, 0.0);
    if (rules().timing == Timing::ignore) earliest.opening = 0;
    return earliest;
}

}  // namespace waybreaker::coalition

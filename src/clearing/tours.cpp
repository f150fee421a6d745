#include "clearing/tours.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace waybreaker::clearing {

std::vector<ObstacleId> obstacles_of(const Tours& tours) {
    std::vector<ObstacleId> all;
    for (const Tour& tour : tours) {
        for (const Stop& stop : tour) all.push_back(stop.obstacle);
    }
    std::ranges::sort(all);
    return all;
}

bool are_all_in(std::span<const ObstacleId> obstacles, const Tours& tours) {
    return std::ranges::all_of(obstacles_of(tours), [obstacles](ObstacleId id) {
        return std::ranges::find(obstacles, id) != obstacles.end();
    });
}

std::optional<Rules> rules_beside(const Map& map, const Mission& mission, const Tours& tours) {
    Rules rules = mission.rules;
    for (const ObstacleId id : obstacles_of(tours)) {
        rules.budget -= map.obstacle(id).weight;
        std::erase(rules.force, id);
        --rules.removals;
    }
    std::int64_t capacity = 0;  // of aircraft
    for (const Agent& agent : mission.agents) capacity += agent.kind == AgentKind::air ? agent.breaches : 0;
    double budget = rules.budget;
    for (const ObstacleId id : rules.force) budget -= map.obstacle(id).weight;
    const bool may = rules.removals >= 0 && budget >= 0 &&
                     std::min<std::int64_t>(capacity, rules.removals) >= std::ssize(rules.force);
    return may ? std::optional(std::move(rules)) : std::nullopt;
}

std::vector<Tours> neighbours(const Tours& tours, std::span<const ObstacleId> pool, std::span<const int> capacities,
                              int most) {
    std::vector<Tours> found;
    std::set<Tours> seen{tours};
    const auto add = [&](Tours other) {
        for (std::size_t i = 0; i < other.size(); ++i) {
            if (std::ssize(other[i]) > capacities[i]) return;
        }
        if (std::ssize(obstacles_of(other)) > most || !seen.insert(other).second) return;
        found.push_back(std::move(other));
    };
    const std::vector<ObstacleId> used = obstacles_of(tours);
    const auto with = [](Tours changed, std::size_t tour, std::size_t place, const Stop& stop) {
        changed[tour].insert(changed[tour].begin() + std::ptrdiff_t(place), stop);
        return changed;
    };
    const auto without = [](Tours changed, std::size_t tour, std::size_t place) {
        changed[tour].erase(changed[tour].begin() + std::ptrdiff_t(place));
        return changed;
    };
    const auto add_with_any = [&](const Tours& base, ObstacleId id) {
        for (std::size_t i = 0; i < base.size(); ++i) {
            for (std::size_t place = 0; place <= base[i].size(); ++place) {
                for (const Place stand : {Place::onward, Place::soonest}) add(with(base, i, place, {id, stand}));
            }
        }
    };
    for (const ObstacleId id : pool) {
        if (!std::ranges::binary_search(used, id)) add_with_any(tours, id);
    }
    for (std::size_t i = 0; i < tours.size(); ++i) {
        for (std::size_t place = 0; place < tours[i].size(); ++place) {
            const Tours less = without(tours, i, place);
            add(less);
            add_with_any(less, tours[i][place].obstacle);
            for (const ObstacleId id : pool) {
                if (!std::ranges::binary_search(used, id)) add_with_any(less, id);
            }
        }
    }
    return found;
}

}  // namespace waybreaker::clearing

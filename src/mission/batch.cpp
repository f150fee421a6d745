// Plans, or what is wrong with the mission; one, or many on one map over several threads.
#include <algorithm>

#include "core/parallel.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

Expected<Plan> Planner::try_plan(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    try {
        return plan(map, mission, method, limits);
    } catch (const InputError& error) {
        return error.error();
    }
}

std::vector<Expected<Plan>> plan_all(const Map& map, std::span<const Mission> missions, const Method& method,
                                     const Limits& limits, unsigned threads) {
    std::vector<Expected<Plan>> plans(missions.size(), Plan());
    std::vector<Planner> planners(std::min<std::size_t>(thread_count(threads), missions.size()));
    for_each_index(missions.size(), threads, [&](std::size_t i, std::size_t thread) {
        plans[i] = planners[thread].try_plan(map, missions[i], method, limits);
    });
    return plans;
}

}  // namespace waybreaker

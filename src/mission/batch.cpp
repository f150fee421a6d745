// Many missions on one map, over several threads.
#include <algorithm>

#include "core/parallel.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

std::vector<BatchPlan> plan_all(const Map& map, std::span<const Mission> missions, const Method& method,
                                const Limits& limits, unsigned threads) {
    std::vector<BatchPlan> plans(missions.size());
    std::vector<MissionPlanner> planners(std::min<std::size_t>(thread_count(threads), missions.size()));
    for_each_index(missions.size(), threads, [&](std::size_t i, std::size_t thread) {
        try {
            plans[i].plan = planners[thread].plan(map, missions[i], method, limits);
        } catch (const InputError& error) {
            plans[i].error = error.what();
        }
    });
    return plans;
}

}  // namespace waybreaker

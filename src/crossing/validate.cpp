#include "crossing/validate.hpp"

#include <string>

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

void validate(const Map& map, const CrossingOptions& options) {
    const auto check_ids = [&map](std::span<const ObstacleId> ids, const char* what) {
        for (const ObstacleId id : ids) {
            if (id.value >= 1 && id.value <= map.obstacles().size()) continue;
            throw InputError("the map has no obstacle " + std::to_string(id.value) + " to " + what + "; it has " +
                             std::to_string(map.obstacles().size()));
        }
    };
    if (options.crossings < 0) throw InputError("the number of crossings cannot be negative");
    check_ids(options.removed, "remove");
    check_ids(options.protect, "protect");
    check_ids(options.only, "cross");
    if (!(options.budget >= 0)) throw InputError("the budget cannot be negative");
    if (options.weights.empty()) return;
    if (options.weights.size() != map.obstacles().size() + 1) {
        throw InputError("there are " + std::to_string(options.weights.size()) + " weights, not one for each of " +
                         std::to_string(map.obstacles().size()) + " obstacles and one for id 0");
    }
    for (std::size_t id = 1; id < options.weights.size(); ++id) {
        require_range(options.weights[id], least_weight, most_weight, "the weight of obstacle " + std::to_string(id));
    }
}

}  // namespace waybreaker

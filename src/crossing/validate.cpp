#include "crossing/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker {

void validate(const Map& map, const CrossingOptions& options, const crossing::Opener& opener) {
    const auto check_ids = [&map](std::span<const ObstacleId> ids, const char* what) {
        for (const ObstacleId id : ids) {
            if (id.value >= 1 && id.value <= map.obstacles().size()) continue;
            throw InputError(ErrorCode::unknown_obstacle, std::to_string(id.value),
                             "the map has no obstacle " + std::to_string(id.value) + " to " + what + "; it has " +
                                 std::to_string(map.obstacles().size()));
        }
    };
    if (options.crossings < 0) throw InputError("the number of crossings cannot be negative");
    check_ids(options.removed, "remove");
    check_ids(options.protect, "protect");
    check_ids(options.only, "cross");
    if (!(options.budget >= 0)) throw InputError("the budget cannot be negative");
    if (!options.prices.empty() && options.prices.size() != map.obstacles().size() + 1) {
        throw InputError("there must be a price for each obstacle of the map, by id");
    }
    if (std::ranges::any_of(options.prices, [](double price) { return !(price >= 0); })) {
        throw InputError("the price of an obstacle cannot be negative");
    }
    if (!(options.weight >= 1)) throw InputError("the weight of a crossing search must be 1 or more");
    if (options.weight > 1 && (options.opened_after || opener.done_after)) {
        throw InputError("a crossing search in time has no weight");
    }
    if (std::isnan(options.length_limit)) throw InputError("the limit of a path's cost must be a number");
    if (std::isnan(options.expected)) throw InputError("the expected cost of a path must be a number");
    validate(options.body);
    if (options.body.corners != Corners::none) {
        throw InputError("the crossing search moves an agent that passes no blocked corner");
    }
}

}  // namespace waybreaker

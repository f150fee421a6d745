#include "io/check_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace waybreaker::io {
namespace {

using Violations = std::vector<Violation>;

// Violations if the plan was not made for this map. For a map of another size, nothing else is checked.
Violations judge_size(const PlanFile& plan, const Map& map) {
    if (plan.width == map.width() && plan.height == map.height()) return {};
    return {{Rule::map, fmt::format("the plan is for a map of {} x {} cells, this one has {} x {}", plan.width,
                                    plan.height, map.width(), map.height())}};
}

Violations judge_digest(const PlanFile& plan, const MapFile& map) {
    if (plan.digest == map.digest) return {};
    return {{Rule::map, "the plan was made for another map file: the digests differ (see --ignore-digest)"}};
}

}  // namespace

Violations judge(const PlanFile& plan, const MapFile& map, const JudgeOptions& options) {
    Violations violations = judge_size(plan, map.map);
    if (!violations.empty()) return violations;
    if (!options.ignore_digest) violations = judge_digest(plan, map);
    const auto judge_on = [&](const Map& on) {
        const Violations of_plan = check(on, plan.mission, plan.plan, options.tolerance);
        violations.insert(violations.end(), of_plan.begin(), of_plan.end());
        return violations;
    };
    if (plan.weights.empty()) return judge_on(map.map);
    // Removed obstacles weigh what the plan file says: its weights may have been chosen for the mission.
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.map.obstacles()) weights.push_back(obstacle.weight);
    for (const auto& [obstacle, weight] : plan.weights) {
        if (obstacle.value < weights.size()) weights[obstacle.value] = weight;
    }
    return judge_on(map.map.with_weights(weights));
}

std::string check_json(const Violations& violations) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const Violation& violation : violations) {
        const std::optional<Point>& place = violation.place;
        list.push_back({{"rule", name(violation.rule)},
                        {"message", violation.message},
                        {"agent", violation.agent.empty() ? Json() : Json(violation.agent)},
                        {"obstacle", violation.obstacle ? Json(violation.obstacle.value) : Json()},
                        {"place", place ? Json::array({place->x, place->y}) : Json()},
                        {"time", violation.time ? Json(*violation.time) : Json()}});
    }
    const Json report{{"format", "waybreaker-check/1"}, {"valid", violations.empty()}, {"violations", list}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace waybreaker::io

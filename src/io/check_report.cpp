#include "io/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/weights.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;
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

Violations judge_weights(const PlanFile& plan, const Map& map) {
    Violations found;
    for (const auto& [obstacle, weight] : plan.weights) {
        if (obstacle.value < 1 || obstacle.value > map.obstacles().size()) continue;
        const double truth = map.obstacle(obstacle).weight;
        if (weight == truth) continue;
        found.push_back({Rule::budget,
                         fmt::format("obstacle {} weighs {:.9g}, not {:.9g} as the plan says; --weights gives others",
                                     obstacle.value, truth, weight),
                         "", obstacle});
    }
    return found;
}

void append(Violations& all, const Violations& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::optional<Map> reweighed(const PlanFile& plan, const MapFile& file, const JudgeOptions& options) {
    const Map& map = file.map;
    if (plan.area_budget) {
        return map.with_weights(area_weights(map, file.has_metres() ? file.cell_size : plan.cell_size));
    }
    if (options.weights) return map.with_weights(*options.weights);
    const auto counts_cells = [&](const PlanFile::Weight& stated) {
        return stated.obstacle.value >= 1 && stated.obstacle.value <= map.obstacles().size() &&
               stated.weight == map.obstacle(stated.obstacle).cells;
    };
    if (plan.weights.empty() || !std::ranges::all_of(plan.weights, counts_cells)) return std::nullopt;
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) weights.push_back(obstacle.cells);
    return map.with_weights(weights);
}

Violations judge(const PlanFile& plan, const MapFile& map, const JudgeOptions& options) {
    Violations violations = judge_size(plan, map.map);
    if (!violations.empty()) return violations;
    if (!options.ignore_digest) violations = judge_digest(plan, map);
    const std::optional<Map> other = reweighed(plan, map, options);
    const Map& on = other ? *other : map.map;
    append(violations, judge_weights(plan, on));
    append(violations, check(on, plan.mission, plan.plan, options.tolerance));
    return violations;
}

std::string check_json(const Violations& violations) {
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

#include "io/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "io/surface_judge.hpp"
#include "io/weights.hpp"
#include "site/demolition.hpp"
#include "waybreaker/error.hpp"

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
    if (map.overlays.empty() && !plan.asked.overlays.empty()) {
        return {{Rule::map, fmt::format("the plan was made with {} laid over the map; lay it over this one, too",
                                        plan.asked.overlays.front().file)}};
    }
    return {{Rule::map,
             "the plan was made for another map file: the digests differ (waybreaker check --ignore-digest judges it "
             "all the same)"}};
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

// Areas and sums of what is removed, from the cells of the map and the side of a cell that the plan states.
class DemolitionJudge {
  public:
    DemolitionJudge(const PlanFile& file, const MapFile& map, double tolerance)
        : file_(file), map_(map), tolerance_(tolerance) {}

    Violations judge() {
        std::vector<ObstacleId> removed;
        for (std::size_t i = 0; i < file_.plan.breaches.size(); ++i) {
            const ObstacleId id = file_.plan.breaches[i].obstacle;
            if (i < file_.areas.size()) expect_area(fmt::format("of obstacle {}", id.value), file_.areas[i], {&id, 1});
            removed.push_back(id);
        }
        for (const PlanFile::Step& step : file_.front) {
            expect_area(fmt::format("of the step of {} removals", step.removed.size()), step.area_m2, step.removed);
        }
        expect_area("that is demolished", file_.demolition.area_m2, removed);
        const site::Demolition truth = site::demolition(map_.map, map_.annotations.sections, known(removed));
        expect("the number of removals", file_.demolition.removals, double(file_.plan.breaches.size()));
        expect("the number of demolished cells", file_.demolition.cells, double(truth.cells));
        expect("the number of structures", file_.demolition.structures, double(truth.structures.size()));
        expect("the area of the least cells", file_.demolition.least_area_m2,
               square_metres(file_.plan.least_demolition.value_or(0), file_.cell_size), " m\u00b2");
        return std::move(found_);
    }

  private:
    // Those that the map has; others are judged elsewhere.
    std::vector<ObstacleId> known(std::span<const ObstacleId> ids) const {
        std::vector<ObstacleId> there;
        std::ranges::copy_if(ids, std::back_inserter(there),
                             [&](ObstacleId id) { return id && id.value <= map_.map.obstacles().size(); });
        return there;
    }

    void expect_area(const std::string& whose, const std::optional<double>& stated, std::span<const ObstacleId> ids) {
        std::uint64_t cells = 0;
        for (const ObstacleId id : known(ids)) cells += map_.map.obstacle(id).cells;
        expect("the area " + whose, stated, square_metres(cells, file_.cell_size), " m\u00b2");
    }

    template <class Number>
    void expect(const std::string& what, const std::optional<Number>& stated, double truth, const char* unit = "") {
        if (!stated || std::abs(double(*stated) - truth) <= tolerance_ * std::max(1.0, truth)) return;
        found_.push_back({Rule::cells, fmt::format("{} is {:.9g}{}, not {:.9g} as the plan says", what, truth, unit,
                                                   double(*stated))});
    }

    const PlanFile& file_;
    const MapFile& map_;
    double tolerance_;
    Violations found_;
};

void append(Violations& all, const Violations& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::optional<Map> reweighed(const PlanFile& plan, const MapFile& file, const JudgeOptions& options) {
    const Map& map = file.map;
    if (plan.asked.area_budget) {
        return map.with_weights(area_weights(map, file.has_metres() ? file.cell_size : plan.cell_size));
    }
    if (options.weights) return map.with_weights(*options.weights);
    const auto counts_cells = [&](const PlanFile::Weight& stated) {
        return stated.obstacle.value >= 1 && stated.obstacle.value <= map.obstacles().size() &&
               stated.weight == map.obstacle(stated.obstacle).cells;
    };
    if (plan.weights.empty() || !std::ranges::all_of(plan.weights, counts_cells)) return std::nullopt;
    return map.with_weights(cell_weights(map));
}

void require_map_of(const PlanFile& plan, const MapFile& map, const std::string& name) {
    const Violations size = judge_size(plan, map.map);
    if (!size.empty()) throw InputError(name, 0, size.front().message);
    if (plan.digest == map.digest) return;
    const bool lacks_overlays = map.overlays.empty() && !plan.asked.overlays.empty();
    throw InputError(name, 0,
                     lacks_overlays ? judge_digest(plan, map).front().message
                                    : "the plan was made for another map file: the digests differ");
}

void require_connectivity(const PlanFile& plan, Connectivity connectivity, const std::string& name) {
    if (plan.connectivity == connectivity) return;
    throw InputError(name + " is for a map of connectivity " + std::string(to_string(plan.connectivity)) +
                     ": make the map with it");
}

Violations judge(const PlanFile& plan, const MapFile& map, const JudgeOptions& options) {
    Violations violations = judge_size(plan, map.map);
    if (!violations.empty()) return violations;
    if (!options.ignore_digest) violations = judge_digest(plan, map);
    const std::optional<Map> other = reweighed(plan, map, options);
    const Map& on = other ? *other : map.map;
    append(violations, judge_weights(plan, on));
    append(violations, DemolitionJudge(plan, map, options.tolerance).judge());
    append(violations, check(on, plan.asked.mission, plan.plan, options.tolerance));
    // Files of earlier versions say nothing of orders.
    if (!plan.states_orders) std::erase_if(violations, [](const Violation& v) { return v.rule == Rule::orders; });
    // Of paths that lead through walls, or nowhere, nobody asks over what.
    if (violations.empty()) append(violations, judge_surfaces(plan, map, options));
    return violations;
}

Violations judge_after(const PlanFile& plan, const MapFile& map, const PlanFile& before, const State& state,
                       const JudgeOptions& options) {
    Violations violations = judge(plan, map, options);
    append(violations, check_continuity(before.asked.mission, before.plan, state, plan.asked.mission, plan.plan,
                                        options.tolerance));
    return violations;
}

std::string check_json(const Violations& violations) {
    Json list = Json::array();
    for (const Violation& violation : violations) {
        const std::optional<Point>& place = violation.place;
        list.push_back({{"rule", to_string(violation.rule)},
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

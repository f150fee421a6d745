#include "io/plan_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/option_words.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json place(Cell c) {
    return {c.x, c.y};
}

// A whole number of cells stands without a decimal point.
Json coordinate(double value) {
    return value == std::floor(value) && std::abs(value) < 1e9 ? Json(std::int64_t(value)) : number(value);
}

Json map_json(const MapFile& map, const ImageReading& image) {
    Json json{{"source", map.source},
              {"width", map.map.width()},
              {"height", map.map.height()},
              {"cell_size", number(map.cell_size)},
              {"digest", map.digest}};
    if (image.threshold) json["threshold"] = number(image.threshold);
    if (image.unknown_free) json["unknown"] = "free";
    return json;
}

Json options_json(const PlanContext& context) {
    const MissionOptions& options = context.options;
    const Motion& motion = options.search.motion;
    Json json{{"planner", word_of(planner_words, options.search.planner)},
              {"heuristic", word_of(heuristic_words, heuristic_of(options.search))},
              {"weight", number(options.search.weight)},
              {"tie_break", word_of(tie_break_words, options.search.tie_break)},
              {"select", word_of(selection_words, options.select)},
              {"flight", word_of(flight_words, options.flight)},
              {"timing", word_of(timing_words, options.timing)},
              {"objective", word_of(objective_words, options.objective)},
              {"removals", options.removals},
              {"breach_time", number(options.breach_time.per_obstacle)},
              {"breach_time_per_cell", number(options.breach_time.per_cell)},
              {"connectivity", context.connectivity == Connectivity::four ? 4 : 8},
              {"corners", word_of(corner_words, motion.corners)},
              {"radius", number(motion.radius)}};
    for (const ObstacleId id : options.protect) json["protect"].push_back(id.value);
    for (const ObstacleId id : options.force) json["force"].push_back(id.value);
    if (std::isfinite(options.budget)) json["budget"] = number(options.budget);
    return json;
}

Json outcome_json(const Outcome& outcome, bool timing_fields) {
    Json ground{{"length", number(outcome.ground.length)},
                {"expanded", outcome.ground.expanded},
                {"generated", outcome.ground.generated}};
    if (timing_fields) ground["seconds"] = number(outcome.ground.seconds);
    return {{"ground", std::move(ground)},
            {"air", {{"length", number(outcome.air.length)}}},
            {"makespan", number(outcome.makespan)},
            {"flowtime", number(outcome.flowtime)},
            {"ground_makespan", number(outcome.ground_makespan)}};
}

Json bound_json(const Plan& plan, Objective objective) {
    if (!plan.bound) return nullptr;
    const std::optional<double> reached = value(plan.after, objective);
    Json bound{{word_of(objective_keys, objective), number(plan.bound)}, {"gap", nullptr}};
    if (reached) bound["gap"] = number(*plan.bound > 0 ? *reached / *plan.bound - 1 : 0);
    return bound;
}

// Who an obstacle is in the world, as far as it is known.
void add_identity(Json& json, ObstacleId id, std::int64_t source_id, const MapFile& map) {
    if (source_id != 0) json["source_id"] = source_id;
    if (const std::string_view name = map.name_of(id); !name.empty()) json["name"] = name;
}

Json removal_json(const Removal& removal, const PlanContext& context) {
    const std::vector<double>& weights = context.options.weights;
    Json json{{"obstacle", removal.obstacle.value}, {"cells", removal.cells}, {"hits", removal.hits}};
    add_identity(json, removal.obstacle, removal.source_id, context.map);
    if (!weights.empty()) json["weight"] = number(weights[removal.obstacle.value]);
    json["at"] = place(removal.at);
    json["cleared_at"] = number(removal.cleared_at);
    json["entered_at"] = number(removal.entered_at);
    if (removal.saves) json["saves"] = number(removal.saves);
    return json;
}

Json next_json(const NextRemoval& next, const MapFile& map) {
    Json json{{"obstacle", next.obstacle.value}};
    add_identity(json, next.obstacle, next.source_id, map);
    json["saves"] = number(next.saves);
    return json;
}

Json agent_json(const AgentPlan& agent) {
    Json path = Json::array();
    for (const Waypoint& point : agent.path) {
        path.push_back(Json::array({coordinate(point.x), coordinate(point.y), number(point.t)}));
    }
    return {{"id", agent.id},
            {"kind", word_of(agent_words, agent.kind)},
            {"speed", number(agent.speed)},
            {"start", place(agent.start)},
            {"goal", place(agent.goal)},
            {"path", std::move(path)}};
}

// One step of the front: what so many removals reach.
Json step_json(const Plan& plan, Objective objective) {
    Json removed = Json::array();
    for (const Removal& removal : plan.removed) removed.push_back(removal.obstacle.value);
    return {{"makespan", number(plan.after.makespan)},
            {"flowtime", number(plan.after.flowtime)},
            {"ground_makespan", number(plan.after.ground_makespan)},
            {"bound", bound_json(plan, objective)},
            {"removed", std::move(removed)}};
}

Json seconds_json(const Plan::Seconds& seconds) {
    return {{"label", number(seconds.label)},
            {"search", number(seconds.search)},
            {"select", number(seconds.select)},
            {"flight", number(seconds.flight)},
            {"total", number(seconds.total)}};
}

// JSON for people: a line for each member of the document and for each object of a list, the rest on one line.
std::string pretty(const Json& json, const std::string& indent = "") {
    if (!json.is_structured() || json.empty()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool lines = indent.empty() || (json.is_array() && json.front().is_object());
    const std::string inner = indent + "  ";
    std::string text;
    for (const auto& [key, value] : json.items()) {
        if (!text.empty()) text += lines ? ",\n" + inner : ", ";
        if (json.is_object()) text += Json(key).dump() + ": ";
        text += pretty(value, inner);
    }
    if (lines) text = "\n" + inner + text + "\n" + indent;
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

}  // namespace

std::string plan_json(const Plan& plan, const PlanContext& context) {
    Json json{{"format", "waybreaker-plan/1"}, {"status", word_of(status_words, plan.status)}};
    if (plan.limit_reached) json["limit_reached"] = true;
    json.update(Json{{"map", map_json(context.map, context.image)},
                     {"options", options_json(context)},
                     {"before", outcome_json(plan.before, context.timing_fields)},
                     {"after", outcome_json(plan.after, context.timing_fields)},
                     {"bound", bound_json(plan, context.options.objective)},
                     {"removed", Json::array()}});
    for (const Removal& removal : plan.removed) {
        json["removed"].push_back(removal_json(removal, context));
    }
    for (const NextRemoval& next : plan.next) json["next"].push_back(next_json(next, context.map));
    json["agents"] = Json::array();
    for (const Plan& step : context.front) json["front"].push_back(step_json(step, context.options.objective));
    for (const AgentPlan& agent : plan.agents) json["agents"].push_back(agent_json(agent));
    if (context.timing_fields) json["seconds"] = seconds_json(plan.seconds);
    return pretty(json) + "\n";
}

}  // namespace waybreaker::io

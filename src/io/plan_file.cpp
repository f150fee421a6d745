#include "io/plan_file.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "io/json_field.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

constexpr int max_depth = 8;

std::optional<double> number_or_null(const std::optional<JsonField>& field) {
    return field ? std::optional(field->number()) : std::nullopt;
}

Cell cell(const JsonField& field) {
    const std::vector<JsonField> parts = field.items();
    if (parts.size() != 2) field.fail("is not a cell, [x, y]");
    return {int(parts[0].whole_number(INT_MIN, INT_MAX)), int(parts[1].whole_number(INT_MIN, INT_MAX))};
}

ObstacleId obstacle(const JsonField& field) {
    return {std::uint32_t(field.whole_number(0, UINT32_MAX))};
}

double not_negative(const JsonField& field) {
    const double value = field.number();
    if (value < 0) field.fail("is below 0");
    return value;
}

Motion motion(const JsonField& options) {
    Motion result;
    result.corners = options["corners"].one_of(corner_words);
    result.radius = options["radius"].number();
    if (result.radius < 0 || result.radius > 32) options["radius"].fail("is not between 0 and 32");
    return result;
}

CheckRules rules(const JsonField& options) {
    CheckRules result;
    result.motion = motion(options);
    result.timing = options["timing"].one_of(timing_words);
    result.objective = options["objective"].one_of(objective_words);
    // Without a number there is no limit but the budget.
    const auto removals = options.find("removals");
    result.removals = removals ? int(removals->whole_number(0, INT_MAX)) : INT_MAX;
    if (const auto time = options.find("breach_time")) result.breach_time.per_obstacle = not_negative(*time);
    if (const auto time = options.find("breach_time_per_cell")) result.breach_time.per_cell = not_negative(*time);
    if (const auto budget = options.find("budget")) result.budget = not_negative(*budget);
    if (const auto protect = options.find("protect")) {
        for (const JsonField& id : protect->items()) result.protect.push_back(obstacle(id));
    }
    if (const auto force = options.find("force")) {
        for (const JsonField& id : force->items()) result.force.push_back(obstacle(id));
    }
    return result;
}

SearchOptions search(const JsonField& options) {
    SearchOptions result;
    result.motion = motion(options);
    if (const auto planner = options.find("planner")) {
        result.planner = planner->one_of(planner_words);
    }
    if (const auto heuristic = options.find("heuristic")) {
        result.heuristic = heuristic->one_of(heuristic_words);
    }
    if (const auto weight = options.find("weight")) result.weight = not_negative(*weight);
    if (const auto rule = options.find("tie_break")) {
        result.tie_break = rule->one_of(tie_break_words);
    }
    return result;
}

Outcome outcome(const JsonField& field) {
    Outcome result;
    result.ground.length = field["ground"]["length"].number_or_null();
    const JsonField ground = field["ground"];
    if (const auto count = ground.find("expanded"))
        result.ground.expanded = std::uint64_t(count->whole_number(0, INT64_MAX));
    if (const auto count = ground.find("generated")) {
        result.ground.generated = std::uint64_t(count->whole_number(0, INT64_MAX));
    }
    if (const auto seconds = ground.find("seconds")) result.ground.seconds = not_negative(*seconds);
    result.air.length = field["air"]["length"].number();
    result.makespan = field["makespan"].number_or_null();
    result.flowtime = field["flowtime"].number_or_null();
    result.ground_makespan = number_or_null(field.find("ground_makespan"));
    return result;
}

Removal removal(const JsonField& field) {
    Removal result;
    result.obstacle = obstacle(field["obstacle"]);
    result.cells = std::uint32_t(field["cells"].whole_number(0, UINT32_MAX));
    result.at = cell(field["at"]);
    result.cleared_at = field["cleared_at"].number();
    result.entered_at = field["entered_at"].number_or_null();
    if (const auto id = field.find("source_id")) result.source_id = id->whole_number(INT64_MIN, INT64_MAX);
    if (const auto hits = field.find("hits")) result.hits = std::uint32_t(hits->whole_number(0, UINT32_MAX));
    result.saves = number_or_null(field.find("saves"));
    return result;
}

NextRemoval next_removal(const JsonField& field) {
    NextRemoval result;
    result.obstacle = obstacle(field["obstacle"]);
    if (const auto id = field.find("source_id")) result.source_id = id->whole_number(INT64_MIN, INT64_MAX);
    result.saves = field["saves"].number();
    return result;
}

// Plan files of the first version do not say where an agent should start and end: then its path says so.
Cell end_of(const JsonField& agent, const char* key, const Waypoint& point) {
    if (const auto field = agent.find(key)) return cell(*field);
    const auto whole = [](double value) { return int(std::lround(std::clamp(value, -1e9, 1e9))); };
    return {whole(point.x), whole(point.y)};
}

AgentPlan agent(const JsonField& field) {
    AgentPlan result;
    result.id = field["id"].text();
    result.kind = field["kind"].one_of(agent_words);
    result.speed = field["speed"].number();
    for (const JsonField& point : field["path"].items()) {
        const std::vector<JsonField> parts = point.items();
        if (parts.size() != 3) point.fail("is not [x, y, t]");
        result.path.push_back({parts[0].number(), parts[1].number(), parts[2].number()});
    }
    if (result.path.empty()) field["path"].fail("is empty");
    result.start = end_of(field, "start", result.path.front());
    result.goal = end_of(field, "goal", result.path.back());
    return result;
}

}  // namespace

PlanFile parse_plan(std::string_view bytes, const std::string& name) {
    const auto document = parse_json(bytes, name, max_depth);
    const JsonField root(document);
    if (root["format"].text() != "waybreaker-plan/1") root["format"].fail("is not waybreaker-plan/1");
    PlanFile file;
    file.plan.status = root["status"].one_of(status_words);
    if (const auto limited = root.find("limit_reached")) {
        file.plan.limit_reached = limited->truth();
    }
    file.width = int(root["map"]["width"].whole_number(1, max_side));
    file.height = int(root["map"]["height"].whole_number(1, max_side));
    file.digest = root["map"]["digest"].text();
    file.image.threshold = number_or_null(root["map"].find("threshold"));
    if (const auto unknown = root["map"].find("unknown")) {
        file.image.unknown_free = unknown->one_of<bool>({{"free", true}, {"blocked", false}});
    }
    const JsonField options = root["options"];
    file.connectivity = options["connectivity"].whole_number(4, 8) == 8 ? Connectivity::eight : Connectivity::four;
    file.rules = rules(options);
    file.search = search(options);
    file.plan.before = outcome(root["before"]);
    file.plan.after = outcome(root["after"]);
    if (const auto bound = root.find("bound")) {
        file.plan.bound = (*bound)[word_of(objective_keys, file.rules.objective).data()].number_or_null();
        file.rules.gap = number_or_null(bound->find("gap"));
    }
    for (const JsonField& field : root["removed"].items()) {
        file.plan.removed.push_back(removal(field));
        const auto weight = field.find("weight");
        file.rules.weights.push_back(weight ? not_negative(*weight) : 1);
    }
    if (const auto next = root.find("next")) {
        for (const JsonField& field : next->items()) file.plan.next.push_back(next_removal(field));
    }
    for (const JsonField& field : root["agents"].items()) file.plan.agents.push_back(agent(field));
    return file;
}

PlanFile read_plan_file(const std::string& path) {
    return parse_plan(read_whole(path, max_plan_bytes), path);
}

}  // namespace waybreaker::io

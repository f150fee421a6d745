#include "server/plan_request.hpp"

#include <algorithm>
#include <climits>

#include "io/json_field.hpp"
#include "io/option_words.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

using io::JsonField;

constexpr int max_depth = 8;
constexpr int most_removals = 32;
constexpr std::size_t most_methods = 8;

Cell cell(const JsonField& field) {
    const std::vector<JsonField> parts = field.items();
    if (parts.size() != 2) field.fail("is not a cell, [x, y]");
    return {int(parts[0].whole_number(INT_MIN, INT_MAX)), int(parts[1].whole_number(INT_MIN, INT_MAX))};
}

std::optional<Cell> cell_if(const std::optional<JsonField>& field) {
    return field ? std::optional(cell(*field)) : std::nullopt;
}

double positive(const JsonField& field) {
    const double value = field.number();
    if (!(value > 0)) field.fail("is not above 0");
    return value;
}

double not_negative(const JsonField& field) {
    const double value = field.number();
    if (value < 0) field.fail("is below 0");
    return value;
}

template <class Value>
void set_word(const JsonField& object, const char* key, const io::Words<Value>& words, Value& target) {
    if (const auto field = object.find(key)) target = field->one_of(words);
}

void set_truth(const JsonField& object, const char* key, bool& target) {
    if (const auto field = object.find(key)) target = field->truth();
}

ObstacleId obstacle(const JsonField& field) {
    return {std::uint32_t(field.whole_number(1, UINT32_MAX))};
}

MissionRequest mission(const JsonField& field) {
    field.allow({"start", "goal", "air_start", "air_goal", "ground_speed", "air_speed"});
    MissionRequest result;
    result.start = cell_if(field.find("start"));
    result.goal = cell_if(field.find("goal"));
    result.air_start = cell_if(field.find("air_start"));
    result.air_goal = cell_if(field.find("air_goal"));
    if (const auto speed = field.find("ground_speed")) result.ground_speed = positive(*speed);
    if (const auto speed = field.find("air_speed")) result.air_speed = positive(*speed);
    return result;
}

// Pairs [id, weight], or the word cells.
void set_weights(const JsonField& field, OptionsRequest& result) {
    result.weights.clear();
    result.weights_of_cells = field.json() == "cells";
    if (result.weights_of_cells) return;
    for (const JsonField& pair : field.items()) {
        const std::vector<JsonField> parts = pair.items();
        if (parts.size() != 2) pair.fail("is not [obstacle, weight]");
        result.weights.push_back({obstacle(parts[0]), positive(parts[1])});
    }
}

void set_search(const JsonField& field, OptionsRequest& result) {
    SearchOptions& search = result.options.search;
    if (const auto planner = field.find("planner")) {
        search.planner = planner->one_of(io::planner_words);
        result.planner_given = true;
    }
    if (const auto heuristic = field.find("heuristic")) search.heuristic = heuristic->one_of(io::heuristic_words);
    if (const auto weight = field.find("weight")) search.weight = weight->number();
    set_word(field, "tie_break", io::tie_break_words, search.tie_break);
    set_word(field, "corners", io::corner_words, search.motion.corners);
    if (const auto radius = field.find("radius")) search.motion.radius = not_negative(*radius);
    if (const auto moves = field.find("moves")) {
        const auto count = moves->whole_number(4, 8);
        if (count != 4 && count != 8) moves->fail("is neither 4 nor 8");
        search.motion.diagonal = count == 8;
    }
}

void set_choice(const JsonField& field, OptionsRequest& result) {
    MissionOptions& options = result.options;
    const auto removals = field.find("removals");
    if (removals) options.removals = int(removals->whole_number(0, most_removals));
    bool paper = false;
    set_truth(field, "paper", paper);
    if (paper) {
        options = paper_options(options);
        result.planner_given = true;
    }
    if (const auto budget = field.find("budget")) {
        options.budget = positive(*budget);
        result.budget_alone = !removals;
    }
    if (const auto weights = field.find("weights")) set_weights(*weights, result);
    if (const auto limit = field.find("time_limit")) options.time_limit = positive(*limit);
    if (const auto protect = field.find("protect")) {
        options.protect.clear();
        for (const JsonField& id : protect->items()) options.protect.push_back(obstacle(id));
    }
    if (const auto force = field.find("force")) {
        options.force.clear();
        for (const JsonField& id : force->items()) options.force.push_back(obstacle(id));
    }
}

// What `field` says, over what was there.
OptionsRequest options(const JsonField& field, OptionsRequest result = {}) {
    field.allow(
        {"paper",     "removals", "select",    "flight",  "timing", "objective", "breach_time", "breach_time_per_cell",
         "protect",   "force",    "budget",    "weights", "bound",  "explain",   "time_limit",  "planner",
         "heuristic", "weight",   "tie_break", "corners", "radius", "moves"});
    set_choice(field, result);
    MissionOptions& options = result.options;
    set_word(field, "select", io::selection_words, options.select);
    set_word(field, "flight", io::flight_words, options.flight);
    set_word(field, "timing", io::timing_words, options.timing);
    set_word(field, "objective", io::objective_words, options.objective);
    if (const auto time = field.find("breach_time")) options.breach_time.per_obstacle = not_negative(*time);
    if (const auto time = field.find("breach_time_per_cell")) options.breach_time.per_cell = not_negative(*time);
    set_truth(field, "bound", options.bound);
    set_truth(field, "explain", options.explain);
    set_search(field, result);
    return result;
}

std::vector<Method> methods(const JsonField& field, const OptionsRequest& common) {
    const std::vector<JsonField> items = field.items();
    if (items.size() > most_methods) field.fail("has more than " + std::to_string(most_methods) + " methods");
    std::vector<Method> result;
    for (const JsonField& item : items) {
        item.allow({"name", "options"});
        result.push_back({item["name"].text(), options(item["options"], common)});
    }
    return result;
}

bool has_search_words(const SearchOptions& search) {
    return search.heuristic || search.weight != 1 || search.tie_break != TieBreak::g_max;
}

// As the map says, unless the request does.
std::vector<double> weights_of(const OptionsRequest& request, const Map& map) {
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) {
        weights.push_back(request.weights_of_cells ? obstacle.cells : obstacle.weight);
    }
    for (const auto& [obstacle, weight] : request.weights) {
        if (obstacle.value >= weights.size()) {
            throw InputError("there is no obstacle " + std::to_string(obstacle.value) + " to weigh");
        }
        weights[obstacle.value] = weight;
    }
    return weights;
}

}  // namespace

PlanRequest parse_plan_request(std::string_view bytes, const std::string& name) {
    if (bytes.size() > max_request_bytes) throw InputError(name, 0, "is too large");
    const auto document = io::parse_json(bytes, name, max_depth);
    const JsonField root(document);
    root.allow({"mission", "options", "methods", "no_timing"});
    PlanRequest request;
    if (const auto field = root.find("mission")) request.mission = mission(*field);
    if (const auto field = root.find("options")) request.options = options(*field);
    if (const auto field = root.find("methods")) request.methods = methods(*field, request.options);
    if (const auto field = root.find("no_timing")) request.timing_fields = !field->truth();
    return request;
}

Mission mission_of(const MissionRequest& request, const io::MapFile& map) {
    const auto place = [&map](const std::optional<Cell>& given, std::optional<Cell> io::XmlTask::*in_file,
                              const std::string& member) {
        if (given) return *given;
        if (map.task) {
            if (const std::optional<Cell> said = (*map.task).*in_file) return *said;
        }
        throw InputError("mission." + member + " is missing, and the map does not say it");
    };
    const Cell start = place(request.start, &io::XmlTask::start, "start");
    const Cell goal = place(request.goal, &io::XmlTask::goal, "goal");
    Mission mission = ground_and_air(start, goal);
    for (Agent& agent : mission.agents) {
        const bool flies = agent.kind == AgentKind::air;
        agent.speed = flies ? request.air_speed : request.ground_speed;
        if (!flies) continue;
        agent.start = request.air_start.value_or(start);
        agent.goal = request.air_goal.value_or(goal);
    }
    return mission;
}

MissionOptions options_of(const OptionsRequest& request, const io::MapFile& map) {
    MissionOptions options = request.options;
    const bool weighed = request.weights_of_cells || !request.weights.empty();
    if (request.budget_alone) options.removals = int(std::min<std::size_t>(map.map.obstacles().size(), INT_MAX));
    if (weighed || request.budget_alone || options.budget < std::numeric_limits<double>::infinity()) {
        options.weights = weights_of(request, map.map);
    }
    if (!request.planner_given && has_search_words(options.search)) options.search.planner = Planner::theta;
    if (request.planner_given && options.search.planner == Planner::optimal &&
        planner_of(options) != Planner::optimal) {
        throw InputError(
            "the planner optimal drives an agent of radius 0.5 or 0 that passes no blocked corner, and "
            "counts no hits");
    }
    options.search.planner = planner_of(options);
    return options;
}

}  // namespace waybreaker::server

#include "request/plan_request.hpp"

#include <algorithm>
#include <climits>
#include <set>

#include "io/json_field.hpp"
#include "io/mission_json.hpp"
#include "io/option_words.hpp"
#include "io/weights.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::request {
namespace {

using io::JsonField;

constexpr int max_depth = io::max_mission_depth + 1;
constexpr int most_removals = 32;
constexpr std::size_t most_methods = 8;

std::optional<Cell> cell_if(const std::optional<JsonField>& field) {
    return field ? std::optional(io::read_cell(*field)) : std::nullopt;
}

double positive(const JsonField& field) {
    const double value = field.number();
    if (!(value > 0)) field.fail("is not above 0");
    return value;
}

void set_truth(const JsonField& object, const char* key, bool& target) {
    if (const auto field = object.find(key)) target = field->truth();
}

ShortMission short_mission(const JsonField& field) {
    field.allow({"start", "goal", "air_start", "air_goal", "ground_speed", "air_speed", "time_unit"});
    ShortMission result;
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
    std::set<ObstacleId> weighed;
    for (const JsonField& pair : field.items()) {
        const std::vector<JsonField> parts = pair.items();
        if (parts.size() != 2) pair.fail("is not [obstacle, weight]");
        result.weights.push_back({io::read_obstacle(parts[0]), positive(parts[1])});
        if (!weighed.insert(result.weights.back().obstacle).second) parts[0].fail("has a weight already");
    }
}

void set_paper(const JsonField& field, OptionsRequest& result) {
    bool paper = false;
    set_truth(field, "paper", paper);
    if (!paper) return;
    follow_paper(result.asked.mission.rules, result.asked.method);
    result.planner_given = true;
}

bool has_search_words(const Method& method) {
    return method.heuristic || method.weight != 1 || method.tie_break != TieBreak::g_max;
}

// What `field` says, over what was there.
OptionsRequest options(const JsonField& field, OptionsRequest result = {}) {
    field.allow({"paper",       "removals",
                 "select",      "flight",
                 "timing",      "objective",
                 "breach_time", "breach_time_per_cell",
                 "rubble",      "protect",
                 "force",       "budget",
                 "budget_m2",   "weights",
                 "bound",       "explain",
                 "time_limit",  "gap",
                 "planner",     "heuristic",
                 "weight",      "tie_break",
                 "corners",     "radius",
                 "moves",       "minimise_demolition"});
    if (const auto removals = field.find("removals")) {
        result.asked.mission.rules.removals = int(removals->whole_number(0, most_removals));
        result.removals_given = true;
    }
    set_paper(field, result);
    for (const char* const key : {"budget", "budget_m2"}) {
        const auto budget = field.find(key);
        if (!budget) continue;
        positive(*budget);
        result.budget_given = true;
    }
    if (const auto weights = field.find("weights")) set_weights(*weights, result);
    if (const auto limit = field.find("time_limit")) result.asked.limits.seconds = positive(*limit);
    if (const auto gap = field.find("gap")) result.asked.limits.gap = io::read_share(*gap);
    io::read_rules(field, result.asked);
    io::read_method(field, result.asked.method);
    result.planner_given = result.planner_given || field.find("planner");
    // What only a search from cell to cell knows asks for one; a mission file names its planner itself.
    const bool asks = field.find("heuristic") || field.find("weight") || field.find("tie_break");
    Method& method = result.asked.method;
    if (asks && !result.planner_given && has_search_words(method)) method.planner = Algorithm::theta;
    if (const auto radius = field.find("radius")) result.radius = io::read_not_negative(*radius);
    if (const auto corners = field.find("corners")) result.corners = corners->one_of(io::corner_words);
    return result;
}

// A mission file inside a request, or as one.
void set_document(const JsonField& field, PlanRequest& request) {
    io::MissionDocument& asked = request.options.asked;
    asked = io::read_mission(field);
    asked.map.clear();  // it is for the map that the request is sent to
    if (asked.mission.rules.removals > most_removals) {
        field["rules"]["removals"].fail("is above " + std::to_string(most_removals));
    }
    request.options.removals_given = true;
}

std::vector<Variant> variants(const JsonField& field, const OptionsRequest& common) {
    const std::vector<JsonField> items = field.items();
    if (items.empty()) field.fail("names no method; leave it out for the usual ones");
    if (items.size() > most_methods) field.fail("has more than " + std::to_string(most_methods) + " methods");
    std::vector<Variant> result;
    for (const JsonField& item : items) {
        item.allow({"name", "options"});
        result.push_back({item["name"].text(), options(item["options"], common)});
    }
    return result;
}

std::vector<Agent> agents_of(const ShortMission& request, const io::MapFile& map) {
    const auto place = [&map](const std::optional<Cell>& given, std::optional<Cell> io::MapTask::*in_file,
                              const std::string& member) {
        if (given) return *given;
        if (map.task) {
            if (const std::optional<Cell> said = (*map.task).*in_file) return *said;
        }
        throw InputError("mission." + member + " is missing, and the map does not say it");
    };
    const Cell start = place(request.start, &io::MapTask::start, "start");
    const Cell goal = place(request.goal, &io::MapTask::goal, "goal");
    std::vector<Agent> agents = ground_and_air(start, goal).agents;
    for (Agent& agent : agents) {
        const bool flies = agent.kind == AgentKind::air;
        agent.speed = flies ? request.air_speed : request.ground_speed;
        if (!flies) continue;
        agent.start = request.air_start.value_or(start);
        agent.goal = request.air_goal.value_or(goal);
    }
    return agents;
}

// Weights of obstacles by id, if the request sets any.
std::optional<std::vector<double>> weights_of(const OptionsRequest& request, const Map& map) {
    if (!request.weights_of_cells && request.weights.empty()) return std::nullopt;
    if (request.asked.area_budget) {
        throw InputError("budget_m2 weighs obstacles by their area, which weights contradict");
    }
    if (request.weights_of_cells) return io::cell_weights(map);
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) weights.push_back(obstacle.weight);
    for (const auto& [obstacle, weight] : request.weights) {
        if (obstacle.value >= weights.size()) {
            throw InputError("there is no obstacle " + std::to_string(obstacle.value) + " to weigh");
        }
        weights[obstacle.value] = weight;
    }
    return weights;
}

// All of a request that is no mission file, but for methods.
void set_request(const JsonField& root, PlanRequest& request) {
    if (const auto field = root.find("mission")) {
        if (field->json().contains("format")) {
            set_document(*field, request);
        } else {
            request.mission = short_mission(*field);
            if (const auto unit = field->find("time_unit")) {
                request.options.asked.in_seconds = unit->one_of<bool>({{"s", true}});
            }
        }
    }
    if (const auto field = root.find("options")) request.options = options(*field, request.options);
    if (const auto field = root.find("no_timing")) request.timing_fields = !field->truth();
}

io::JsonDocument document_of(std::string_view bytes, const std::string& name) {
    if (bytes.size() > max_request_bytes) throw InputError(name, 0, "is too large");
    return io::parse_json(bytes, name, max_depth);
}

}  // namespace

PlanRequest parse_plan_request(std::string_view bytes, const std::string& name) {
    const auto document = document_of(bytes, name);
    const JsonField root(document);
    PlanRequest request;
    if (root.json().contains("format")) {
        set_document(root, request);
        return request;
    }
    root.allow({"mission", "options", "methods", "no_timing"});
    set_request(root, request);
    if (const auto field = root.find("methods")) request.variants = variants(*field, request.options);
    return request;
}

LiveRequest parse_live_request(std::string_view bytes, const std::string& name) {
    const auto document = document_of(bytes, name);
    const JsonField root(document);
    LiveRequest live;
    if (root.json().contains("format")) {
        live.map = root["map"].text();
        set_document(root, live.plan);
        return live;
    }
    root.allow({"map", "mission", "options", "reaction", "no_timing"});
    live.map = root["map"].text();
    set_request(root, live.plan);
    if (const auto field = root.find("reaction")) {
        live.reaction = io::read_not_negative(*field);
        if (live.reaction > most_breach_time) field->fail("is no time of a mission");
    }
    return live;
}

MissionOnMap on_map(const ShortMission& mission, const OptionsRequest& options, const io::MapFile& map) {
    MissionOnMap result{.asked = options.asked, .reweighted = {}};
    io::MissionDocument& asked = result.asked;
    if (asked.mission.agents.empty()) {
        asked.mission.agents = agents_of(mission, map);
        asked.unsized = {0};  // the vehicle
    }
    for (const std::size_t index : asked.unsized) {
        Body& body = asked.mission.agents[index].body;
        body.corners = options.corners.value_or(body.corners);
    }
    io::size_agents(asked, map);
    if (options.budget_given && !options.removals_given) {
        asked.mission.rules.removals = int(std::min<std::size_t>(map.map.obstacles().size(), INT_MAX));
    }
    for (Agent& agent : asked.mission.agents) {
        if (agent.kind == AgentKind::air) continue;
        agent.body.radius = options.radius.value_or(agent.body.radius);
        agent.body.corners = options.corners.value_or(agent.body.corners);
    }
    const Method& method = asked.method;
    if (options.planner_given && method.planner == Algorithm::optimal &&
        planner_of(method, asked.mission.ground_body()) != Algorithm::optimal) {
        throw InputError(
            "the planner optimal drives an agent that passes no blocked corner by eight moves, and counts no hits");
    }
    result.reweighted = io::settle(asked, map, weights_of(options, map.map));
    return result;
}

}  // namespace waybreaker::request

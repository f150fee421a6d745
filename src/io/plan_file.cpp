#include "io/plan_file.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>

#include "io/json_field.hpp"
#include "io/mission_json.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "io/state_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

std::optional<double> number_or_null(const std::optional<JsonField>& field) {
    return field ? std::optional(field->number()) : std::nullopt;
}

// Mission and method: as "options" say, which every plan file has, else as its copy of the mission file does.
MissionDocument asked(const JsonField& root, const std::vector<Itinerary>& itineraries) {
    MissionDocument result;
    const auto copy = root.find("mission");
    // Without a number there is no limit but the budget.
    result.mission.rules.removals = INT_MAX;
    if (copy) result = read_mission(*copy);
    if (!result.can_breach_tags.empty()) copy->fail("names what can be breached by tag, where a plan names ids");
    const JsonField options = root["options"];
    for (const char* member : {"timing", "objective", "corners"}) options[member].text();
    options["radius"].number();
    read_rules(options, result);
    if (!result.protect_tags.empty()) options.fail("protects by tag, where a plan names obstacles by their ids");
    read_method(options, result.method);
    if (!copy) {
        for (const Itinerary& agent : itineraries) {
            result.mission.agents.push_back({agent.id, agent.kind, agent.start, agent.goal, agent.speed});
        }
    }
    // A team's agents have bodies of their own.
    if (result.mission.is_team()) return result;
    Body body;
    read_body(options, body);
    for (Agent& agent : result.mission.agents) {
        if (agent.kind == AgentKind::ground) agent.body = body;
    }
    return result;
}

void read_search(const JsonField& field, Route& route) {
    if (const auto count = field.find("expanded")) route.expanded = std::uint64_t(count->whole_number(0, INT64_MAX));
    if (const auto count = field.find("generated")) route.generated = std::uint64_t(count->whole_number(0, INT64_MAX));
    if (const auto seconds = field.find("seconds")) route.seconds = read_not_negative(*seconds);
}

// One for each agent of a team, in the mission's order.
std::vector<Route> routes(const JsonField& list, const Mission& mission) {
    const std::vector<JsonField> fields = list.items();
    if (fields.size() != mission.agents.size()) list.fail("does not have a route for each agent of the mission");
    std::vector<Route> routes;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (read_agent_id(fields[i]["id"]) != mission.agents[i].id)
            fields[i]["id"].fail("is not that of the mission's agent");
        Route& route = routes.emplace_back();
        route.kind = mission.agents[i].kind;
        route.length = fields[i]["length"].number_or_null();
        read_search(fields[i], route);
    }
    return routes;
}

Outcome outcome(const JsonField& field, const Mission& mission) {
    Outcome result;
    if (const auto list = field.find("routes")) {
        result.routes = routes(*list, mission);
    } else {
        result.ground().length = field["ground"]["length"].number_or_null();
        read_search(field["ground"], result.ground());
        result.air().length = field["air"]["length"].number_or_null();
    }
    result.makespan = field["makespan"].number_or_null();
    result.flowtime = field["flowtime"].number_or_null();
    result.ground_makespan = number_or_null(field.find("ground_makespan"));
    return result;
}

IfFailed if_failed(const JsonField& field) {
    constexpr double no_plan = std::numeric_limits<double>::infinity();
    IfFailed result{field["objective"].number_or_null().value_or(no_plan)};
    for (const JsonField& id : field["removed"].items()) result.removed.push_back(read_obstacle(id));
    return result;
}

Breach breach(const JsonField& field) {
    Breach result;
    result.obstacle = read_obstacle(field["obstacle"], 0);
    result.cells = std::uint32_t(field["cells"].whole_number(0, UINT32_MAX));
    result.at = read_cell(field["at"]);
    result.cleared_at = field["cleared_at"].number();
    result.entered_at = field["entered_at"].number_or_null();
    if (const auto id = field.find("source_id")) result.source_id = id->whole_number(INT64_MIN, INT64_MAX);
    if (const auto hits = field.find("hits")) result.hits = std::uint32_t(hits->whole_number(0, UINT32_MAX));
    result.saves = number_or_null(field.find("saves"));
    if (const auto plan_b = field.find("if_failed")) result.if_failed = if_failed(*plan_b);
    if (const auto agent = field.find("by")) result.by = read_agent_id(*agent);
    result.begun_at = number_or_null(field.find("begun_at"));
    return result;
}

NextBreach next_breach(const JsonField& field) {
    NextBreach result;
    result.obstacle = read_obstacle(field["obstacle"], 0);
    if (const auto id = field.find("source_id")) result.source_id = id->whole_number(INT64_MIN, INT64_MAX);
    result.saves = field["saves"].number();
    return result;
}

OutOfRange out_of_range(const JsonField& field) {
    OutOfRange result;
    result.obstacle = read_obstacle(field["obstacle"], 0);
    if (const auto id = field.find("source_id")) result.source_id = id->whole_number(INT64_MIN, INT64_MAX);
    result.agent = read_agent_id(field["agent"]);
    result.flight = field["flight"].number();
    result.longest = field["longest"].number();
    return result;
}

// Plan files of the first version do not say where an agent should start and end: then its path says so.
Cell end_of(const JsonField& agent, const char* key, const Waypoint& point) {
    if (const auto field = agent.find(key)) return read_cell(*field);
    const auto whole = [](double value) { return int(std::lround(std::clamp(value, -1e9, 1e9))); };
    return {whole(point.x), whole(point.y)};
}

Wait wait(const JsonField& field) {
    const std::vector<JsonField> place = field["at"].items();
    if (place.size() != 2) field["at"].fail("is not a place, [x, y]");
    Wait result;
    result.at = {place[0].number(), place[1].number()};
    result.from = field["from"].number();
    result.until = field["until"].number();
    result.reason = field["reason"].one_of(wait_words);
    if (const auto obstacle = field.find("obstacle")) result.obstacle = read_obstacle(*obstacle, 0);
    if (const auto who = field.find("agent")) result.agent = read_agent_id(*who);
    if (const auto zone = field.find("zone")) result.zone = std::size_t(zone->whole_number(1, INT32_MAX));
    return result;
}

BarredBy barred_by(const JsonField& field) {
    return {std::size_t(field["zone"].whole_number(1, INT32_MAX)), read_agent_id(field["agent"]), field["at"].number()};
}

Itinerary agent(const JsonField& field) {
    Itinerary result;
    result.id = read_agent_id(field["id"]);
    result.kind = field["kind"].one_of(agent_words);
    result.speed = field["speed"].number();
    for (const JsonField& point : field["path"].items()) result.path.push_back(read_waypoint(point));
    if (result.path.empty()) field["path"].fail("is empty");
    result.start = end_of(field, "start", result.path.front());
    result.goal = end_of(field, "goal", result.path.back());
    if (const auto reached = field.find("reached")) result.reached = reached->truth();
    result.gain = number_or_null(field.find("gain"));
    if (const auto waits = field.find("waits")) {
        for (const JsonField& item : waits->items()) result.waits.push_back(wait(item));
    }
    if (const auto recharges = field.find("recharges")) {
        for (const JsonField& item : recharges->items()) {
            result.recharges.push_back(
                {read_cell(item["at"]), item["from"].number(), item["until"].number(), item["flown"].number()});
        }
    }
    return result;
}

Moment moment(const JsonField& field, const std::vector<Itinerary>& agents) {
    const std::string id = read_agent_id(field["agent"]);
    const auto found = std::ranges::find(agents, id, &Itinerary::id);
    if (found == agents.end()) field["agent"].fail("is no agent of the plan");
    Moment result;
    result.agent = std::size_t(found - agents.begin());
    result.point = std::size_t(field["point"].whole_number(0, std::int64_t(found->path.size()) - 1));
    if (const auto fraction = field.find("fraction")) result.fraction = fraction->number();
    const bool moves = result.fraction > 0;
    if (!(result.fraction >= 0 && result.fraction < 1)) field["fraction"].fail("is not at least 0 and below 1");
    if (moves && result.point + 1 == found->path.size()) field["fraction"].fail("is beyond the last point of the path");
    return result;
}

Order order(const JsonField& field, const std::vector<Itinerary>& agents) {
    Order result;
    result.before = moment(field["before"], agents);
    result.after = moment(field["after"], agents);
    result.reason = field["why"].one_of(order_words);
    if (const auto obstacle = field.find("obstacle")) result.obstacle = read_obstacle(*obstacle, 0);
    result.slack = field["slack"].number();
    return result;
}

PlanFile::Surface surface(const JsonField& agent) {
    const auto field = agent.find("surface");
    if (!field) return {};
    const auto length = [&field](const char* key) { return number_or_null(field->find(key)); };
    return {.ways = length("ways"),
            .off_ways = length("off_ways"),
            .unknown = length("unknown"),
            .near_water = length("near_water")};
}

std::optional<std::uint64_t> count(const JsonField& object, const char* key) {
    const auto field = object.find(key);
    return field ? std::optional(std::uint64_t(field->whole_number(0, INT64_MAX))) : std::nullopt;
}

// Of a step of the front.
std::vector<ObstacleId> obstacles(const JsonField& step) {
    std::vector<ObstacleId> ids;
    for (const JsonField& id : step["removed"].items()) ids.push_back(read_obstacle(id, 0));
    return ids;
}

// The file says the ways after removing once, in time; those before it does not say.
void set_ways(Plan& plan) {
    std::vector<Route>& routes = plan.after.routes;
    for (std::size_t i = 0; i < std::min(plan.agents.size(), routes.size()); ++i) {
        if (routes[i].kind != plan.agents[i].kind) continue;
        for (const Waypoint& at : plan.agents[i].path) {
            const Point point{at.x, at.y};
            if (routes[i].path.empty() || !(routes[i].path.back() == point)) routes[i].path.push_back(point);
        }
    }
}

Revised revised(const JsonField& field) {
    Revised result;
    result.number = int(field["number"].whole_number(1, INT_MAX));
    result.sequence = std::uint64_t(field["sequence"].whole_number(1, INT64_MAX));
    result.now = read_not_negative(field["now"]);
    if (const auto status = field.find("status")) result.status = status->one_of(revision_words);
    if (const auto reason = field.find("reason")) result.reason = reason->text();
    if (const auto halts = field.find("halts")) {
        for (const JsonField& item : halts->items()) {
            result.halts.push_back({read_agent_id(item["agent"]), std::size_t(item["point"].whole_number(0, INT_MAX)),
                                    read_not_negative(item["by"])});
        }
    }
    for (const JsonField& item : field["decided"].items()) {
        result.decisions.push_back(
            {read_agent_id(item["agent"]), std::size_t(item["point"].whole_number(0, INT_MAX)), item["time"].number()});
    }
    if (const auto found = field.find("found")) result.found = read_found(*found);
    return result;
}

double cell_size(const JsonField& field) {
    const double metres = field.number();
    if (!(metres >= least_cell_size && metres <= most_cell_size)) field.fail("is no size of a cell in metres");
    return metres;
}

}  // namespace

PlanFile read_plan(const JsonField& root) {
    root.require_format("waybreaker-plan/1");
    PlanFile file;
    file.plan.status = root["status"].one_of(status_words);
    if (const auto limited = root.find("limit_reached")) {
        file.plan.limit_reached = limited->truth();
    }
    if (const auto revision = root.find("revision")) {
        file.plan.revised = revised(*revision);
        if (const auto digest = revision->find("supersedes")) file.supersedes = digest->text();
    }
    file.width = int(root["map"]["width"].whole_number(1, max_side));
    file.height = int(root["map"]["height"].whole_number(1, max_side));
    file.digest = root["map"]["digest"].text();
    file.image.threshold = number_or_null(root["map"].find("threshold"));
    if (const auto unknown = root["map"].find("unknown")) {
        file.image.unknown_free = unknown->one_of<bool>({{"free", true}, {"blocked", false}});
    }
    if (const auto nav2 = root["map"].find("nav2")) file.image.nav2 = nav2->one_of(nav2_words);
    const JsonField connectivity = root["options"]["connectivity"];
    const std::int64_t neighbours = connectivity.whole_number(4, 8);
    if (neighbours != 4 && neighbours != 8) connectivity.fail("is neither 4 nor 8");
    file.connectivity = neighbours == 8 ? Connectivity::eight : Connectivity::four;
    for (const JsonField& field : root["agents"].items()) {
        file.plan.agents.push_back(agent(field));
        file.surfaces.push_back(surface(field));
    }
    if (const auto orders = root.find("orders")) {
        file.states_orders = true;
        for (const JsonField& field : orders->items()) file.plan.orders.push_back(order(field, file.plan.agents));
    }
    file.asked = asked(root, file.plan.agents);
    if (const auto size = root["map"].find("cell_size")) file.cell_size = cell_size(*size);
    file.plan.before = outcome(root["before"], file.asked.mission);
    file.plan.after = outcome(root["after"], file.asked.mission);
    set_ways(file.plan);
    if (const auto bound = root.find("bound")) {
        file.plan.bound = (*bound)[word_of(objective_keys, file.asked.mission.rules.objective).data()].number_or_null();
        file.plan.gap = number_or_null(bound->find("gap"));
    }
    for (const JsonField& field : root["removed"].items()) {
        file.plan.breaches.push_back(breach(field));
        file.areas.push_back(number_or_null(field.find("area_m2")));
        if (const auto weight = field.find("weight")) {
            file.weights.push_back({file.plan.breaches.back().obstacle, weight->number()});
            if (!(file.weights.back().weight >= least_weight && file.weights.back().weight <= most_weight)) {
                weight->fail("is no weight of an obstacle");
            }
        }
    }
    if (const auto demolition = root.find("demolition")) {
        file.plan.least_demolition = count(*demolition, "least_cells");
        file.demolition = {.removals = count(*demolition, "removals"),
                           .cells = count(*demolition, "cells"),
                           .structures = count(*demolition, "structures"),
                           .area_m2 = number_or_null(demolition->find("area_m2")),
                           .least_area_m2 = number_or_null(demolition->find("least_area_m2"))};
    }
    if (const auto front = root.find("front")) {
        for (const JsonField& field : front->items()) {
            if (const auto area = field.find("area_m2")) file.front.push_back({obstacles(field), area->number()});
        }
    }
    if (const auto next = root.find("next")) {
        for (const JsonField& field : next->items()) file.plan.next.push_back(next_breach(field));
    }
    if (const auto barred = root.find("barred_by")) file.plan.barred_by = barred_by(*barred);
    if (const auto far = root.find("out_of_range")) {
        for (const JsonField& field : far->items()) file.plan.out_of_range.push_back(out_of_range(field));
    }
    return file;
}

PlanFile parse_plan(std::string_view bytes, const std::string& name) {
    const auto document = parse_json(bytes, name, max_plan_depth);
    return read_plan(JsonField(document));
}

MapFile known_map(MapFile file, const Plan& plan) {
    if (plan.revised) file.map = laid_over(file.map, plan.revised->found);
    return file;
}

PlanFile read_plan_file(const std::string& path) {
    return parse_plan(read_whole(path, max_plan_bytes), path);
}

}  // namespace waybreaker::io

#include "io/plan_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/mission_json.hpp"
#include "io/option_words.hpp"
#include "io/plan_surfaces.hpp"
#include "io/state_json.hpp"
#include "io/structures_json.hpp"
#include "site/demolition.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
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
    if (image.nav2 != Nav2::jazzy) json["nav2"] = word_of(nav2_words, image.nav2);
    return json;
}

// What plan files of the first version say of mission and method.
Json options_json(const PlanContext& context) {
    const Rules& rules = context.asked.mission.rules;
    const Body& body = context.asked.mission.ground_body();
    const SearchOptions search = search_options(context.asked.method, body);
    Json json{{"planner", to_string(search.planner)},
              {"heuristic", to_string(heuristic_of(search))},
              {"weight", number(search.weight)},
              {"tie_break", to_string(search.tie_break)},
              {"select", to_string(context.asked.method.select)},
              {"flight", to_string(context.asked.method.flight)},
              {"timing", to_string(rules.timing)},
              {"objective", to_string(rules.objective)},
              {"removals", rules.removals},
              {"breach_time", number(rules.breach_time.per_obstacle)},
              {"breach_time_per_cell", number(rules.breach_time.per_cell)},
              {"connectivity", context.connectivity == Connectivity::four ? 4 : 8},
              {"corners", to_string(body.corners)},
              {"radius", number(body.radius)}};
    if (rules.rubble != 0) json["rubble"] = number(rules.rubble);
    if (rules.separation != 0) json["separation"] = number(rules.separation);
    if (rules.at_goal != AtGoal::stay) json["at_goal"] = to_string(rules.at_goal);
    for (const ObstacleId id : rules.protect) json["protect"].push_back(id.value);
    for (const ObstacleId id : rules.force) json["force"].push_back(id.value);
    if (std::isfinite(rules.budget)) json[context.asked.area_budget ? "budget_m2" : "budget"] = number(rules.budget);
    return json;
}

// What was asked and how it was planned; how long that may have taken is nothing that a plan depends on.
Json mission_copy(const PlanContext& context) {
    Json json = mission_json(context.asked);
    json.erase("limits");
    return json;
}

// Of a team: one for each agent, in the mission's order.
Json routes_json(const Outcome& outcome, const Mission& mission, bool timing_fields) {
    Json routes = Json::array();
    for (std::size_t i = 0; i < outcome.routes.size(); ++i) {
        const Route& route = outcome.routes[i];
        Json json{{"id", mission.agents[i].id}, {"length", number(route.length)}};
        if (route.kind == AgentKind::ground) {
            json["expanded"] = route.expanded;
            json["generated"] = route.generated;
            if (timing_fields) json["seconds"] = number(route.seconds);
        }
        routes.push_back(std::move(json));
    }
    return {{"routes", std::move(routes)},
            {"makespan", number(outcome.makespan)},
            {"flowtime", number(outcome.flowtime)},
            {"ground_makespan", number(outcome.ground_makespan)}};
}

Json outcome_json(const Outcome& outcome, const Mission& mission, bool timing_fields) {
    if (mission.is_team()) return routes_json(outcome, mission, timing_fields);
    Json ground{{"length", number(outcome.ground().length)},
                {"expanded", outcome.ground().expanded},
                {"generated", outcome.ground().generated}};
    if (timing_fields) ground["seconds"] = number(outcome.ground().seconds);
    return {{"ground", std::move(ground)},
            {"air", {{"length", number(outcome.air().length)}}},
            {"makespan", number(outcome.makespan)},
            {"flowtime", number(outcome.flowtime)},
            {"ground_makespan", number(outcome.ground_makespan)}};
}

Json bound_json(const Plan& plan, Objective objective) {
    if (!plan.bound) return nullptr;
    return {{word_of(objective_keys, objective), number(plan.bound)}, {"gap", number(plan.gap)}};
}

// Who an obstacle is in the world, as far as it is known.
void add_identity(Json& json, ObstacleId id, std::int64_t source_id, const MapFile& map) {
    if (source_id != 0) json["source_id"] = source_id;
    if (const std::string_view name = map.annotations.name_of(id); !name.empty()) json["name"] = name;
}

// What all removals destroy; empty where neither area nor structures are known.
Json demolition_json(const Plan& plan, const MapFile& map) {
    if (!map.has_metres() && map.annotations.sections.empty() && !plan.least_demolition) return nullptr;
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    const site::Demolition demolition = site::demolition(map.map, map.annotations.sections, removed);
    Json json{{"removals", demolition.removals}, {"cells", demolition.cells}};
    if (map.has_metres()) json["area_m2"] = number(map.square_metres(demolition.cells));
    if (!map.annotations.sections.empty()) json["structures"] = demolition.structures.size();
    if (!plan.least_demolition) return json;
    json["least_cells"] = *plan.least_demolition;
    if (map.has_metres()) json["least_area_m2"] = number(map.square_metres(*plan.least_demolition));
    return json;
}

Json breach_json(const Breach& breach, const PlanContext& context) {
    Json json{{"obstacle", breach.obstacle.value}, {"cells", breach.cells}, {"hits", breach.hits}};
    if (context.map.has_metres()) json["area_m2"] = number(context.map.square_metres(breach.cells));
    add_identity(json, breach.obstacle, breach.source_id, context.map);
    Json structures = structures_json(breach.obstacle, context.map.annotations.sections);
    if (!structures.empty()) json["structures"] = std::move(structures);
    const double weight = context.map.map.obstacle(breach.obstacle).weight;
    if (weight != 1 || std::isfinite(context.asked.mission.rules.budget)) json["weight"] = number(weight);
    json["at"] = cell_json(breach.at);
    if (!breach.by.empty()) json["by"] = breach.by;
    if (breach.begun_at) json["begun_at"] = number(breach.begun_at);
    json["cleared_at"] = number(breach.cleared_at);
    json["entered_at"] = number(breach.entered_at);
    if (breach.saves) json["saves"] = number(breach.saves);
    if (breach.if_failed) {
        Json& if_failed = json["if_failed"] = {{"objective", number(breach.if_failed->objective)}};
        if_failed["removed"] = Json::array();
        for (const ObstacleId id : breach.if_failed->removed) if_failed["removed"].push_back(id.value);
    }
    return json;
}

Json next_json(const NextBreach& next, const MapFile& map) {
    Json json{{"obstacle", next.obstacle.value}};
    add_identity(json, next.obstacle, next.source_id, map);
    json["saves"] = number(next.saves);
    return json;
}

Json out_of_range_json(const OutOfRange& far, const MapFile& map) {
    Json json{{"obstacle", far.obstacle.value}};
    add_identity(json, far.obstacle, far.source_id, map);
    json["agent"] = far.agent;
    json["flight"] = number(far.flight);
    json["longest"] = number(far.longest);
    return json;
}

Json wait_json(const Wait& wait) {
    Json json{{"at", Json::array({coordinate(wait.at.x), coordinate(wait.at.y)})},
              {"from", number(wait.from)},
              {"until", number(wait.until)},
              {"reason", to_string(wait.reason)}};
    if (wait.obstacle) json["obstacle"] = wait.obstacle.value;
    if (!wait.agent.empty()) json["agent"] = wait.agent;
    if (wait.zone > 0) json["zone"] = wait.zone;
    return json;
}

Json recharge_json(const Recharge& recharge) {
    return {{"at", cell_json(recharge.at)},
            {"from", number(recharge.from)},
            {"until", number(recharge.until)},
            {"flown", number(recharge.flown)}};
}

Json surface_json(const site::Surface& surface) {
    Json json{
        {"ways", number(surface.ways)}, {"off_ways", number(surface.off_ways)}, {"unknown", number(surface.unknown)}};
    if (surface.near_water) json["near_water"] = number(surface.near_water);
    return json;
}

Json agent_json(const Itinerary& agent, const std::optional<site::Surface>& surface) {
    Json path = Json::array();
    for (const Waypoint& point : agent.path) {
        path.push_back(Json::array({coordinate(point.x), coordinate(point.y), number(point.t)}));
    }
    Json json{{"id", agent.id},
              {"kind", to_string(agent.kind)},
              {"speed", number(agent.speed)},
              {"start", cell_json(agent.start)},
              {"goal", cell_json(agent.goal)}};
    if (!agent.reached) json["reached"] = false;
    if (agent.gain) json["gain"] = number(agent.gain);
    for (const Wait& wait : agent.waits) json["waits"].push_back(wait_json(wait));
    for (const Recharge& recharge : agent.recharges) json["recharges"].push_back(recharge_json(recharge));
    if (surface) json["surface"] = surface_json(*surface);
    json["path"] = std::move(path);
    return json;
}

Json moment_json(const Moment& moment, const Plan& plan) {
    Json json{{"agent", plan.agents[moment.agent].id}, {"point", moment.point}};
    if (moment.fraction != 0) json["fraction"] = number(moment.fraction);
    return json;
}

Json order_json(const Order& order, const Plan& plan) {
    Json json{{"before", moment_json(order.before, plan)},
              {"after", moment_json(order.after, plan)},
              {"why", to_string(order.reason)}};
    if (order.obstacle) json["obstacle"] = order.obstacle.value;
    json["slack"] = number(order.slack);
    return json;
}

// One step of the front: what so many removals reach.
Json step_json(const Plan& plan, Objective objective, const MapFile& map) {
    Json removed = Json::array();
    std::uint64_t cells = 0;
    for (const Breach& breach : plan.breaches) {
        removed.push_back(breach.obstacle.value);
        cells += breach.cells;
    }
    Json json{{"makespan", number(plan.after.makespan)},
              {"flowtime", number(plan.after.flowtime)},
              {"ground_makespan", number(plan.after.ground_makespan)},
              {"bound", bound_json(plan, objective)},
              {"removed", std::move(removed)}};
    // Whether there is no way, or none is known.
    if (plan.status != PlanStatus::solved) json["status"] = to_string(plan.status);
    if (map.has_metres()) json["area_m2"] = number(map.square_metres(cells));
    return json;
}

Json revision_json(const Revised& revised, const PlanContext& context) {
    Json json{{"number", revised.number},
              {"sequence", revised.sequence},
              {"now", number(revised.now)},
              {"status", to_string(revised.status)}};
    if (!context.supersedes.empty()) json["supersedes"] = context.supersedes;
    json["decided"] = Json::array();
    for (const Decision& decision : revised.decisions) {
        json["decided"].push_back(
            {{"agent", decision.agent}, {"point", decision.point}, {"time", number(decision.time)}});
    }
    if (!revised.reason.empty()) json["reason"] = revised.reason;
    for (const Halt& halt : revised.halts)
        json["halts"].push_back({{"agent", halt.agent}, {"point", halt.point}, {"by", number(halt.by)}});
    if (!revised.found.empty()) json["found"] = found_json(revised.found);
    return json;
}

Json seconds_json(const Plan::Seconds& seconds) {
    return {{"label", number(seconds.label)},
            {"search", number(seconds.search)},
            {"select", number(seconds.select)},
            {"flight", number(seconds.flight)},
            {"total", number(seconds.total)}};
}

}  // namespace

int removals_of(std::span<const Plan> front, const Rules& rules) {
    return int(front.size() + rules.force.size()) - 1;
}

std::string plan_json(const Plan& plan, const PlanContext& context) {
    Json json{{"format", "waybreaker-plan/1"}, {"status", to_string(plan.status)}};
    if (plan.limit_reached) json["limit_reached"] = true;
    if (plan.revised) json["revision"] = revision_json(*plan.revised, context);
    json.update(Json{{"map", map_json(context.map, context.image)},
                     {"options", options_json(context)},
                     {"mission", mission_copy(context)},
                     {"before", outcome_json(plan.before, context.asked.mission, context.timing_fields)},
                     {"after", outcome_json(plan.after, context.asked.mission, context.timing_fields)},
                     {"bound", bound_json(plan, context.asked.mission.rules.objective)},
                     {"removed", Json::array()}});
    for (const Breach& breach : plan.breaches) {
        json["removed"].push_back(breach_json(breach, context));
    }
    if (Json demolition = demolition_json(plan, context.map); !demolition.is_null()) {
        json["demolition"] = std::move(demolition);
    }
    for (const NextBreach& next : plan.next) json["next"].push_back(next_json(next, context.map));
    for (const OutOfRange& far : plan.out_of_range) json["out_of_range"].push_back(out_of_range_json(far, context.map));
    if (plan.barred_by) {
        const BarredBy& by = *plan.barred_by;
        json["barred_by"] = {{"zone", by.zone}, {"agent", by.agent}, {"at", number(by.at)}};
    }
    json["agents"] = Json::array();
    for (const Plan& step : context.front) {
        json["front"].push_back(step_json(step, context.asked.mission.rules.objective, context.map));
    }
    const std::vector<std::optional<site::Surface>> surfaces = plan_surfaces(plan, context.map);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        json["agents"].push_back(agent_json(plan.agents[i], surfaces[i]));
    }
    if (plan.status == PlanStatus::solved) json["orders"] = Json::array();
    for (const Order& order : plan.orders) json["orders"].push_back(order_json(order, plan));
    if (context.timing_fields) json["seconds"] = seconds_json(plan.seconds);
    return pretty(json) + "\n";
}

}  // namespace waybreaker::io

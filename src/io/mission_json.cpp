#include "io/mission_json.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/range.hpp"
#include "io/option_words.hpp"
#include "io/zones_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto format = "waybreaker-mission/1";
constexpr double widest_overlay = 10000;  // metres

template <class Value>
void read_word(const JsonField& object, const char* key, const Words<Value>& words, Value& target) {
    if (const auto field = object.find(key)) target = field->one_of(words);
}

void read_truth(const JsonField& object, const char* key, bool& target) {
    if (const auto field = object.find(key)) target = field->truth();
}

void read_ids(const JsonField& object, const char* key, std::vector<ObstacleId>& ids) {
    const auto field = object.find(key);
    if (!field) return;
    ids.clear();
    for (const JsonField& id : field->items()) ids.push_back(read_obstacle(id));
}

void read_protected(const JsonField& object, MissionDocument& document) {
    if (const auto field = object.find("protect"))
        read_obstacles(*field, document.mission.rules.protect, document.protect_tags);
}

site::OverlaySource read_overlay(const JsonField& field) {
    Words<site::OverlayUse> words;
    for (const std::string_view word : site::overlay_use_words) {
        words.emplace_back(word, site::OverlayUse(words.size()));
    }
    field.allow({"file", "as", "width"});
    site::OverlaySource overlay{.file = field["file"].text()};
    if (overlay.file.empty()) field["file"].fail("is empty");
    overlay.use = field["as"].one_of(words);
    if (const auto width = field.find("width")) overlay.width = read_between(*width, 0, widest_overlay);
    return overlay;
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json overlay_json(const site::OverlaySource& overlay) {
    Json json{{"file", overlay.file}, {"as", site::overlay_use_words[std::size_t(overlay.use)]}};
    if (overlay.width > 0) json["width"] = overlay.width;
    return json;
}

Json ids_json(const std::vector<ObstacleId>& ids) {
    Json json = Json::array();
    for (const ObstacleId id : ids) json.push_back(id.value);
    return json;
}

Json rules_json(const MissionDocument& document) {
    const Rules& rules = document.mission.rules;
    Json json{{"removals", rules.removals}};
    if (std::isfinite(rules.budget)) json[document.area_budget ? "budget_m2" : "budget"] = number(rules.budget);
    json["protect"] = ids_json(rules.protect);
    for (const site::TagFilter& tag : document.protect_tags) json["protect"].push_back(tag.text());
    json["force"] = ids_json(rules.force);
    for (const TimedOpening& opening : rules.opened)
        json["opened"].push_back({{"obstacle", opening.obstacle.value}, {"at", opening.at}});
    if (!rules.failed.empty()) json["failed"] = ids_json(rules.failed);
    if (rules.retries != 0) json["retries"] = rules.retries;
    if (!rules.zones.empty()) json["zones"] = zones_json(rules.zones);
    json["breach_time"] = number(rules.breach_time.per_obstacle);
    json["breach_time_per_cell"] = number(rules.breach_time.per_cell);
    if (rules.rubble != 0) json["rubble"] = number(rules.rubble);
    json["timing"] = to_string(rules.timing);
    json["objective"] = to_string(rules.objective);
    if (rules.minimise_demolition) json["minimise_demolition"] = number(*rules.minimise_demolition);
    if (!rules.collisions) json["collisions"] = false;
    if (rules.unreached) json["unreached"] = number(*rules.unreached);
    if (rules.separation != 0) json["separation"] = number(rules.separation);
    if (rules.at_goal != AtGoal::stay) json["at_goal"] = to_string(rules.at_goal);
    return json;
}

Json method_json(const Method& method) {
    Json json{{"select", to_string(method.select)},
              {"flight", to_string(method.flight)},
              {"planner", to_string(method.planner)}};
    if (method.heuristic) json["heuristic"] = to_string(*method.heuristic);
    json["weight"] = number(method.weight);
    json["tie_break"] = to_string(method.tie_break);
    json["moves"] = method.diagonal ? 8 : 4;
    json["bound"] = method.bound;
    json["explain"] = method.explain;
    return json;
}

Json limits_json(const Limits& limits) {
    Json json{{"seconds", number(limits.seconds)}};
    if (limits.expansions < UINT64_MAX) json["expansions"] = limits.expansions;
    if (limits.gap != 0) json["gap"] = number(limits.gap);
    return json;
}

void read_limits(const JsonField& field, Limits& limits) {
    field.allow({"seconds", "expansions", "gap"});
    if (field.json().contains("seconds")) {
        const auto seconds = field.find("seconds");
        limits.seconds = seconds ? read_positive(*seconds) : std::numeric_limits<double>::infinity();
    }
    if (const auto count = field.find("expansions"))
        limits.expansions = std::uint64_t(count->whole_number(1, INT64_MAX));
    if (const auto gap = field.find("gap")) limits.gap = read_share(*gap);
}

void read_budget(const JsonField& field, MissionDocument& document) {
    const auto weight = field.find("budget");
    const auto area = field.find("budget_m2");
    if (weight && area) area->fail("stands beside budget; give one of them");
    if (!weight && !area) return;
    document.mission.rules.budget = read_not_negative(weight ? *weight : *area);
    document.area_budget = area.has_value();
}

std::string pretty(const Json& json, const std::string& indent) {
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

Json cell_json(Cell c) {
    return {c.x, c.y};
}

Cell read_cell(const JsonField& field) {
    const std::vector<JsonField> parts = field.items();
    if (parts.size() != 2) field.fail("is not a cell, [x, y]");
    return {int(parts[0].whole_number(INT_MIN, INT_MAX)), int(parts[1].whole_number(INT_MIN, INT_MAX))};
}

ObstacleId read_obstacle(const JsonField& field, std::uint32_t least) {
    return {std::uint32_t(field.whole_number(least, UINT32_MAX))};
}

double read_not_negative(const JsonField& field) {
    const double value = field.number();
    if (value < 0) field.fail("is below 0");
    return value;
}

double read_share(const JsonField& field) {
    return read_between(field, 0, 1);
}

std::vector<TimedOpening> read_openings(const JsonField& list) {
    std::vector<TimedOpening> openings;
    for (const JsonField& item : list.items()) {
        item.allow({"obstacle", "at"});
        openings.push_back({read_obstacle(item["obstacle"]), read_between(item["at"], 0, most_breach_time)});
    }
    return openings;
}

void read_rules(const JsonField& field, MissionDocument& document) {
    Rules& rules = document.mission.rules;
    if (const auto count = field.find("removals")) rules.removals = int(count->whole_number(0, INT_MAX));
    read_budget(field, document);
    read_protected(field, document);
    read_ids(field, "force", rules.force);
    if (const auto list = field.find("opened")) rules.opened = read_openings(*list);
    read_ids(field, "failed", rules.failed);
    if (const auto count = field.find("retries")) rules.retries = int(count->whole_number(0, INT_MAX));
    if (const auto zones = field.find("zones")) {
        ZoneCollection given = read_zones(*zones);
        if (!given.in_cells) {
            zones->fail(
                "are not in cells: give cells, and \"crs\": \"cells\" beside \"features\"; the option --zones "
                "of the command reads longitude and latitude");
        }
        rules.zones = std::move(given.zones);
    }
    if (const auto time = field.find("breach_time"))
        rules.breach_time.per_obstacle = read_between(*time, 0, most_breach_time);
    if (const auto time = field.find("breach_time_per_cell"))
        rules.breach_time.per_cell = read_between(*time, 0, most_breach_time);
    if (const auto time = field.find("rubble")) rules.rubble = read_between(*time, 0, most_breach_time);
    read_word(field, "timing", timing_words, rules.timing);
    read_word(field, "objective", objective_words, rules.objective);
    if (const auto tolerance = field.find("minimise_demolition")) rules.minimise_demolition = read_share(*tolerance);
    read_truth(field, "collisions", rules.collisions);
    if (const auto time = field.find("unreached")) rules.unreached = read_between(*time, 0, most_breach_time);
    if (const auto room = field.find("separation")) rules.separation = read_between(*room, 0, most_radius);
    read_word(field, "at_goal", at_goal_words, rules.at_goal);
}

void read_method(const JsonField& field, Method& method) {
    read_word(field, "select", selection_words, method.select);
    read_word(field, "flight", flight_words, method.flight);
    read_word(field, "planner", planner_words, method.planner);
    if (const auto heuristic = field.find("heuristic")) method.heuristic = heuristic->one_of(heuristic_words);
    if (const auto weight = field.find("weight")) method.weight = read_between(*weight, 1, most_heuristic_weight);
    read_word(field, "tie_break", tie_break_words, method.tie_break);
    if (const auto moves = field.find("moves")) {
        const auto count = moves->whole_number(4, 8);
        if (count != 4 && count != 8) moves->fail("is neither 4 nor 8");
        method.diagonal = count == 8;
    }
    read_truth(field, "bound", method.bound);
    read_truth(field, "explain", method.explain);
}

MissionDocument read_mission(const JsonField& document, const Limits& limits) {
    document.require_format(format);
    document.allow({"format", "map", "overlays", "time_unit", "agents", "rules", "method", "limits", "page"});
    MissionDocument result;
    if (const auto map = document.find("map")) result.map = map->text();
    if (const auto overlays = document.find("overlays")) {
        for (const JsonField& overlay : overlays->items()) result.overlays.push_back(read_overlay(overlay));
    }
    if (const auto unit = document.find("time_unit")) result.in_seconds = unit->one_of<bool>({{"s", true}});
    result.limits = limits;
    std::vector<Agent>& agents = result.mission.agents;
    for (const JsonField& agent : document["agents"].items()) {
        std::vector<site::TagFilter> tags;
        agents.push_back(read_agent_of_mission(agent, &tags));
        if (!tags.empty()) result.can_breach_tags[agents.size() - 1] = std::move(tags);
        if (agents.back().kind == AgentKind::ground && !agent.find("radius"))
            result.unsized.push_back(agents.size() - 1);
    }
    if (agents.empty()) document["agents"].fail("names nobody: a mission has at least one ground agent");
    if (const auto rules = document.find("rules")) {
        rules->allow({"removals", "budget", "budget_m2", "protect", "force", "opened", "failed", "retries", "zones",
                      "breach_time", "breach_time_per_cell", "rubble", "timing", "objective", "minimise_demolition",
                      "collisions", "unreached", "separation", "at_goal"});
        read_rules(*rules, result);
    }
    if (const auto method = document.find("method")) {
        method->allow({"select", "flight", "planner", "heuristic", "weight", "tie_break", "moves", "bound", "explain"});
        read_method(*method, result.method);
    }
    if (const auto said = document.find("limits")) read_limits(*said, result.limits);
    return result;
}

MissionDocument parse_mission(std::string_view bytes, const std::string& name, const Limits& limits) {
    const auto document = parse_json(bytes, name, max_mission_depth);
    return read_mission(JsonField(document), limits);
}

Json mission_json(const MissionDocument& document) {
    Json agents = Json::array();
    for (std::size_t i = 0; i < document.mission.agents.size(); ++i) {
        const auto tagged = document.can_breach_tags.find(i);
        const bool has_tags = tagged != document.can_breach_tags.end();
        agents.push_back(
            mission_agent_json(document.mission.agents[i], has_tags ? tagged->second : std::vector<site::TagFilter>()));
    }
    Json json{{"format", format}};
    if (!document.map.empty()) json["map"] = document.map;
    for (const site::OverlaySource& overlay : document.overlays) json["overlays"].push_back(overlay_json(overlay));
    if (document.in_seconds) json["time_unit"] = "s";
    json["agents"] = std::move(agents);
    json["rules"] = rules_json(document);
    json["method"] = method_json(document.method);
    json["limits"] = limits_json(document.limits);
    return json;
}

std::string mission_text(const MissionDocument& document) {
    return pretty(mission_json(document)) + "\n";
}

std::string pretty(const Json& json) {
    return pretty(json, "");
}

}  // namespace waybreaker::io

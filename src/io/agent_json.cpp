#include "io/agent_json.hpp"

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/range.hpp"
#include "io/mission_json.hpp"
#include "io/option_words.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_id = 100;  // characters

// An aircraft may take off anywhere.
void read_start(const JsonField& field, Agent& agent) {
    const std::vector<JsonField> parts = field.items();
    const auto is_whole = [](const JsonField& part) { return part.json().is_number_integer(); };
    if (agent.kind == AgentKind::ground || parts.size() != 2 || std::ranges::all_of(parts, is_whole)) {
        agent.start = read_cell(field);
        return;
    }
    const auto whole = [](double value) { return int(std::lround(std::clamp(value, -1e9, 1e9))); };
    agent.from = Point(parts[0].number(), parts[1].number());
    agent.start = {whole(agent.from->x), whole(agent.from->y)};
    if (agent.from == Point(agent.start)) agent.from.reset();
}

}  // namespace

double read_positive(const JsonField& field) {
    const double value = field.number();
    if (!(value > 0)) field.fail("is not above 0");
    return value;
}

double read_between(const JsonField& field, double least, double most) {
    const double value = field.number();
    if (!(value >= least && value <= most))
        field.fail("is not between " + number_text(least) + " and " + number_text(most));
    return value;
}

std::string read_agent_id(const JsonField& field) {
    std::string id = field.text();
    const auto begins_character = [](unsigned char c) { return (c & 0xC0U) != 0x80U; };
    if (std::size_t(std::ranges::count_if(id, begins_character)) > longest_id) {
        field.fail("has more than " + std::to_string(longest_id) + " characters");
    }
    return id;
}

void read_body(const JsonField& field, Body& body) {
    if (const auto corners = field.find("corners")) body.corners = corners->one_of(corner_words);
    if (const auto radius = field.find("radius")) body.radius = read_between(*radius, 0, most_radius);
}

Waypoint read_waypoint(const JsonField& field) {
    const std::vector<JsonField> parts = field.items();
    if (parts.size() != 3) field.fail("is not [x, y, t]");
    return {parts[0].number(), parts[1].number(), parts[2].number()};
}

Agent read_agent_of_mission(const JsonField& field) {
    field.allow({"id", "kind", "start", "goal", "speed", "radius", "corners", "ready_at", "weight", "breaches", "range",
                 "endurance", "reserve", "flown", "approach"});
    Agent agent;
    agent.id = read_agent_id(field["id"]);
    agent.kind = field["kind"].one_of(agent_words);
    read_start(field["start"], agent);
    agent.goal = read_cell(field["goal"]);
    if (const auto speed = field.find("speed")) agent.speed = read_between(*speed, least_speed, most_speed);
    if (const auto time = field.find("ready_at")) agent.ready_at = read_between(*time, 0, most_breach_time);
    if (const auto approach = field.find("approach")) {
        for (const JsonField& point : approach->items()) agent.approach.push_back(read_waypoint(point));
    }
    if (const auto weight = field.find("weight")) agent.weight = read_between(*weight, 0, most_weight_of_agent);
    if (const auto count = field.find("breaches")) {
        const auto most = int(count->whole_number(0, INT_MAX));
        (agent.kind == AgentKind::air ? agent.breaches : agent.own_breaches) = most;
    }
    if (const auto range = field.find("range")) agent.range = read_positive(*range);
    if (const auto endurance = field.find("endurance")) agent.endurance = read_positive(*endurance);
    if (const auto reserve = field.find("reserve")) agent.reserve = read_share(*reserve);
    if (const auto flown = field.find("flown")) agent.flown = read_between(*flown, 0, most_breach_time);
    read_body(field, agent.body);
    return agent;
}

Json mission_agent_json(const Agent& agent) {
    Json json{{"id", agent.id},
              {"kind", to_string(agent.kind)},
              {"start", agent.from ? Json{agent.from->x, agent.from->y} : cell_json(agent.start)},
              {"goal", cell_json(agent.goal)},
              {"speed", agent.speed}};
    if (agent.ready_at != 0) json["ready_at"] = agent.ready_at;
    for (const Waypoint& p : agent.approach) json["approach"].push_back({p.x, p.y, p.t});
    if (agent.weight != 1) json["weight"] = agent.weight;
    if (agent.breaches != any_number) json["breaches"] = agent.breaches;
    if (agent.own_breaches > 0) json["breaches"] = agent.own_breaches;
    if (std::isfinite(agent.range)) json["range"] = agent.range;
    if (std::isfinite(agent.endurance)) json["endurance"] = agent.endurance;
    if (agent.reserve != 0) json["reserve"] = agent.reserve;
    if (agent.flown != 0) json["flown"] = agent.flown;
    if (agent.kind == AgentKind::air) return json;
    json["radius"] = agent.body.radius;
    json["corners"] = to_string(agent.body.corners);
    return json;
}

}  // namespace waybreaker::io

#include "io/agent_json.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/range.hpp"
#include "io/mission_json.hpp"
#include "io/option_words.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

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

CanBreach read_can_breach(const JsonField& field, std::vector<site::TagFilter>* tags) {
    field.allow({"most_cells", "only"});
    CanBreach can;
    if (const auto most = field.find("most_cells")) can.most_cells = std::uint32_t(most->whole_number(1, UINT32_MAX));
    if (const auto only = field.find("only")) {
        std::vector<site::TagFilter> named;
        read_obstacles(*only, can.only.emplace(), named);
        if (tags == nullptr && !named.empty()) only->fail("names tags, where only ids of obstacles can be");
        if (tags != nullptr) *tags = std::move(named);
    }
    return can;
}

Json can_breach_json(const CanBreach& can, std::span<const site::TagFilter> tags) {
    Json json = Json::object();
    if (can.most_cells < UINT32_MAX) json["most_cells"] = can.most_cells;
    if (!can.only) return json;
    Json& only = json["only"] = Json::array();
    for (const ObstacleId id : *can.only) only.push_back(id.value);
    for (const site::TagFilter& tag : tags) only.push_back(tag.text());
    return json;
}

}  // namespace

void read_obstacles(const JsonField& list, std::vector<ObstacleId>& ids, std::vector<site::TagFilter>& tags) {
    ids.clear();
    tags.clear();
    for (const JsonField& item : list.items()) {
        if (!item.json().is_string()) {
            ids.push_back(read_obstacle(item));
            continue;
        }
        try {
            std::ranges::move(site::parse_tag_filters(item.text()), std::back_inserter(tags));
        } catch (const InputError& error) {
            item.fail(std::string("is no tag: ") + error.what());
        }
    }
}

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

Agent read_agent_of_mission(const JsonField& field, std::vector<site::TagFilter>* tags) {
    field.allow({"id",
                 "kind",
                 "start",
                 "goal",
                 "speed",
                 "radius",
                 "corners",
                 "ready_at",
                 "weight",
                 "breaches",
                 "range",
                 "endurance",
                 "reserve",
                 "flown",
                 "recharge",
                 "bases",
                 "approach",
                 "breach_time",
                 "breach_time_per_cell",
                 "can_breach",
                 "reach"});
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
    if (const auto recharge = field.find("recharge")) agent.recharge = read_positive(*recharge);
    if (const auto bases = field.find("bases")) {
        for (const JsonField& base : bases->items()) agent.bases.push_back(read_cell(base));
    }
    if (const auto time = field.find("breach_time")) agent.breach_time = read_between(*time, 0, most_breach_time);
    if (const auto time = field.find("breach_time_per_cell"))
        agent.breach_time_per_cell = read_between(*time, 0, most_breach_time);
    if (const auto can = field.find("can_breach")) agent.can_breach = read_can_breach(*can, tags);
    if (const auto reach = field.find("reach")) agent.reach = read_between(*reach, 0, most_reach);
    read_body(field, agent.body);
    return agent;
}

Json mission_agent_json(const Agent& agent, std::span<const site::TagFilter> tags) {
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
    if (agent.recharge) json["recharge"] = *agent.recharge;
    for (const Cell base : agent.bases) json["bases"].push_back(cell_json(base));
    if (agent.breach_time) json["breach_time"] = *agent.breach_time;
    if (agent.breach_time_per_cell) json["breach_time_per_cell"] = *agent.breach_time_per_cell;
    if (agent.can_breach) json["can_breach"] = can_breach_json(*agent.can_breach, tags);
    if (agent.kind == AgentKind::air) return json;
    if (agent.reach != 1) json["reach"] = agent.reach;
    json["radius"] = agent.body.radius;
    json["corners"] = to_string(agent.body.corners);
    return json;
}

}  // namespace waybreaker::io

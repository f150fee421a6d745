#include "io/state_json.hpp"

#include <algorithm>
#include <climits>

#include "io/mission_json.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto format = "waybreaker-state/1";
constexpr std::size_t max_state_bytes = std::size_t{1} << 22U;
const Words<Doing> doing_words = all_words<Doing>();

double read_time(const JsonField& field) {
    const double time = field.number();
    if (!(time >= 0 && time <= most_breach_time)) field.fail("is no time of a mission");
    return time;
}

Json openings_json(std::span<const TimedOpening> openings) {
    Json list = Json::array();
    for (const TimedOpening& opening : openings)
        list.push_back({{"obstacle", opening.obstacle.value}, {"at", opening.at}});
    return list;
}

AgentState read_agent(const JsonField& field) {
    field.allow({"id", "passed", "at", "doing", "goal", "flown"});
    AgentState agent;
    agent.id = read_agent_id(field["id"]);
    agent.passed = std::size_t(field["passed"].whole_number(0, INT_MAX));
    if (const auto at = field.find("at")) {
        const std::vector<JsonField> parts = at->items();
        if (parts.size() != 2) at->fail("is not a place, [x, y]");
        agent.at = Point(parts[0].number(), parts[1].number());
    }
    if (const auto doing = field.find("doing")) agent.doing = doing->one_of(doing_words);
    if (const auto goal = field.find("goal")) agent.goal = read_cell(*goal);
    if (const auto flown = field.find("flown")) agent.flown = read_time(*flown);
    return agent;
}

Json agent_json(const AgentState& agent) {
    Json json{{"id", agent.id}, {"passed", agent.passed}};
    if (agent.at) json["at"] = {agent.at->x, agent.at->y};
    json["doing"] = to_string(agent.doing);
    if (agent.goal) json["goal"] = cell_json(*agent.goal);
    if (agent.flown) json["flown"] = *agent.flown;
    return json;
}

}  // namespace

std::vector<Found> read_found(const JsonField& list) {
    std::vector<Found> all;
    for (const JsonField& item : list.items()) {
        item.allow({"cells", "blocked", "destructible"});
        Found& found = all.emplace_back();
        for (const JsonField& cell : item["cells"].items()) found.cells.push_back(read_cell(cell));
        if (const auto blocked = item.find("blocked")) found.blocked = blocked->truth();
        if (const auto destructible = item.find("destructible")) found.destructible = destructible->truth();
        if (!found.blocked && found.destructible) item.fail("is free, and said to be destructible");
    }
    return all;
}

Json found_json(std::span<const Found> found) {
    Json list = Json::array();
    for (const Found& part : found) {
        Json json{{"cells", Json::array()}, {"blocked", part.blocked}};
        for (const Cell cell : part.cells) json["cells"].push_back(cell_json(cell));
        if (part.destructible) json["destructible"] = true;
        list.push_back(std::move(json));
    }
    return list;
}

State read_state(const JsonField& document) {
    document.require_format(format);
    document.allow({"format", "sequence", "now", "agents", "opened", "failed", "found", "joined"});
    State state;
    state.sequence = std::uint64_t(document["sequence"].whole_number(1, INT64_MAX));
    state.now = read_time(document["now"]);
    if (const auto agents = document.find("agents")) {
        for (const JsonField& agent : agents->items()) state.agents.push_back(read_agent(agent));
    }
    if (const auto opened = document.find("opened")) state.opened = read_openings(*opened);
    if (const auto failed = document.find("failed")) state.failed = read_openings(*failed);
    if (const auto found = document.find("found")) state.found = read_found(*found);
    if (const auto joined = document.find("joined")) {
        for (const JsonField& agent : joined->items()) state.joined.push_back(read_agent_of_mission(agent));
    }
    return state;
}

State parse_state(std::string_view bytes, const std::string& name) {
    const auto parsed = parse_json(bytes, name, max_mission_depth);
    return read_state(JsonField(parsed));
}

State read_state_file(const std::string& path) {
    return parse_state(read_whole(path, max_state_bytes), path);
}

Json state_json(const State& state) {
    Json json{{"format", format}, {"sequence", state.sequence}, {"now", state.now}, {"agents", Json::array()}};
    for (const AgentState& agent : state.agents) json["agents"].push_back(agent_json(agent));
    json["opened"] = openings_json(state.opened);
    json["failed"] = openings_json(state.failed);
    json["found"] = found_json(state.found);
    for (const Agent& agent : state.joined) json["joined"].push_back(mission_agent_json(agent));
    return json;
}

}  // namespace waybreaker::io

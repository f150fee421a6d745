#include "authors/agents_xml.hpp"

#include <array>

#include "authors/xml_values.hpp"

namespace waybreaker::authors {
namespace {

using Element = XmlFile::Element;

constexpr double most_radius = 32;  // cells

void require_one_more(const Element& element, std::size_t count) {
    if (count < most_agents) return;
    throw element.error("a mission has at most " + std::to_string(most_agents) + " agents");
}

// Of an agent, else of its defaults; empty where neither says it.
std::optional<XmlFile::Attribute> attribute_of(const Element& agent, const std::optional<Element>& defaults,
                                               const char* name) {
    if (const auto own = agent.attribute(name)) return own;
    return defaults ? defaults->attribute(name) : std::nullopt;
}

int coordinate(const Element& agent, const char* name) {
    const auto value = agent.attribute(name);
    if (!value) throw agent.error(std::string(name) + " is missing in 'agent'");
    return whole_number_of(*value, 0, max_side - 1);
}

Agent agent_of(const Element& element, const std::optional<Element>& defaults, std::size_t number) {
    if (element.attribute("start_id")) {
        throw element.error(
            "this agent starts at a node of a roadmap, and maps are grids here: give a task for a grid");
    }
    Agent agent;
    const auto id = element.attribute("id");
    agent.id = id ? std::string(id->value) : std::to_string(number);
    if (agent.id.empty()) throw element.error("the id of an agent must not be empty");
    const bool in_rows = element.attribute("start_i").has_value();
    const auto cell = [&](const char* x, const char* y) {
        return Cell{coordinate(element, x), coordinate(element, y)};
    };
    agent.start = in_rows ? cell("start_j", "start_i") : cell("start.x", "start.y");
    agent.goal = in_rows ? cell("goal_j", "goal_i") : cell("goal.x", "goal.y");
    if (const auto size = attribute_of(element, defaults, "size")) {
        agent.body.radius = number_of(*size, 0.001, most_radius);
    }
    if (const auto speed = attribute_of(element, defaults, "movespeed")) {
        agent.speed = number_of(*speed, least_speed, most_speed);
    }
    return agent;
}

XmlAgents elements(const Element& parent) {
    constexpr std::array turning{"rotationspeed", "start.heading", "goal.heading"};
    const std::optional<Element> defaults = parent.find("defaultparameters");
    XmlAgents result;
    parent.for_each_child([&](const Element& child) {
        if (!child.is("agent")) return;
        require_one_more(child, result.agents.size());
        result.agents.push_back(agent_of(child, defaults, result.agents.size()));
        for (const char* name : turning) {
            if (attribute_of(child, defaults, name)) result.turn = true;
        }
    });
    return result;
}

// Of one agent after the other: startx, starty, finishx, finishy.
XmlAgents sequence(const Element& map, const Element& count) {
    constexpr std::array tags{"startx", "starty", "finishx", "finishy"};
    std::vector<int> numbers;
    map.for_each_child([&](const Element& child) {
        const char* const expected = tags[numbers.size() % tags.size()];
        bool place = false;
        for (const char* tag : tags) place = place || child.is(tag);
        if (!place) return;
        if (!child.is(expected)) {
            throw child.error("<" + std::string(expected) + "> of agent " +
                              std::to_string(numbers.size() / tags.size()) + " must stand before <" + child.tag() +
                              ">");
        }
        require_one_more(child, numbers.size() / tags.size());
        numbers.push_back(whole_number_of(child, 0, max_side - 1));
    });
    const auto said = std::size_t(whole_number_of(count, 1, int(most_agents)));
    if (numbers.size() != said * tags.size()) {
        throw count.error("<agents> is " + std::to_string(said) + ", which takes " +
                          std::to_string(said * tags.size()) + " coordinates, but there are " +
                          std::to_string(numbers.size()));
    }
    XmlAgents result;
    for (std::size_t i = 0; i < said; ++i) {
        Agent& agent = result.agents.emplace_back();
        agent.id = std::to_string(i);
        agent.start = {numbers[4 * i], numbers[4 * i + 1]};
        agent.goal = {numbers[4 * i + 2], numbers[4 * i + 3]};
    }
    return result;
}

}  // namespace

XmlAgents agents_of(const Element& root) {
    if (const auto agents = root.find("agents")) return elements(*agents);
    if (const auto map = root.find("map")) {
        if (const auto count = map->find("agents")) return sequence(*map, *count);
    }
    return elements(root);
}

XmlAgents parse_agents_xml(std::string_view bytes, const std::string& name) {
    const XmlFile file(bytes, name);
    XmlAgents agents = agents_of(file.root());
    if (!agents.agents.empty()) return agents;
    throw InputError(name, 0,
                     "holds no agents: <agent> elements are expected, as tasks of AA-SIPP(m) and CCBS have them");
}

InputError no_map(const Element& root) {
    const auto has = [&root](const char* tag) {
        bool found = false;
        root.for_each_child([&](const Element& child) { found = found || child.is(tag); });
        return found;
    };
    const char* const seems = root.is("graphml")        ? "this is a roadmap (GraphML), and maps are grids here"
                              : has("agents")           ? "it holds agents: give its map, and this file as the agents"
                              : has("agent")            ? "it holds agents: give its map, and this file as the agents"
                              : has("dynamicobstacles") ? "it holds moving obstacles, which are not planned around"
                              : has("algorithm")        ? "it holds options of another program: give its map"
                                                        : nullptr;
    return root.error("<map> is missing in " + in_quotes(root.tag()) + (seems ? std::string("; ") + seems : ""));
}

}  // namespace waybreaker::authors

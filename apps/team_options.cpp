#include "team_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "authors/agents_xml.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "measure.hpp"
#include "note.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::apps {
namespace {

constexpr std::size_t max_agents_bytes = std::size_t{1} << 26U;

// How many of those that a file holds are asked for.
std::size_t count_of(const PlanOptions& options, std::size_t held, const std::string& name, const char* what) {
    const std::size_t count = std::size_t(options.count.value_or(int(std::min(held, most_agents))));
    if (held == 0) throw InputError(name, 0, fmt::format("holds no {}", what));
    if (count > held) throw InputError(name, 0, fmt::format("has {} {}; give a smaller --count", held, what));
    return count;
}

// The name of a map without folders and without what says its format: maps are converted.
std::string stem_of(const std::string& map) {
    const std::string name = map.substr(map.find_last_of("/\\") + 1);
    return name.substr(0, name.rfind('.'));
}

// The first lines of a scenario file, named by their numbers.
std::vector<Agent> scenario_agents(const PlanOptions& options, const std::string& text, const io::MapFile& file) {
    const Map& map = file.map;
    const std::string name = io::input_name(options.agents);
    const std::vector<Scenario> scenarios = read_movingai_scenarios(text, name);
    std::vector<Agent> agents(count_of(options, scenarios.size(), name, "scenarios"));
    std::optional<std::string> other;  // map that one of them is for
    for (std::size_t i = 0; i < agents.size(); ++i) {
        if (scenarios[i].width != map.width() || scenarios[i].height != map.height()) {
            throw InputError(name, 0,
                             fmt::format("is for a map of {} x {} cells, not {} x {}", scenarios[i].width,
                                         scenarios[i].height, map.width(), map.height()));
        }
        if (stem_of(scenarios[i].map) != stem_of(file.source)) other = other.value_or(scenarios[i].map);
        agents[i].id = std::to_string(i + 1);
        agents[i].start = scenarios[i].start;
        agents[i].goal = scenarios[i].goal;
    }
    if (other && !io::is_standard_input(options.map)) {
        warn(fmt::format("{} is for {}, and the map is {}", name, shown(*other), file.source));
    }
    return agents;
}

// The first of those that an XML task lists: the map's own, or one beside it.
std::vector<Agent> xml_agents(const PlanOptions& options, authors::XmlAgents listed, const std::string& name) {
    if (listed.turn) note(name, "headings and speeds of rotation are not heeded: agents turn at once");
    listed.agents.resize(count_of(options, listed.agents.size(), name, "agents"));
    return std::move(listed.agents);
}

std::vector<Agent> ground_agents(const PlanOptions& options, const io::MapFile& map) {
    if (options.agents.empty()) {
        return xml_agents(options, {map.task->agents, map.task->agents_turn}, io::input_name(options.map));
    }
    const std::string text = io::read_whole(options.agents, max_agents_bytes);
    if (!authors::is_xml(text)) return scenario_agents(options, text, map);
    const std::string name = io::input_name(options.agents);
    return xml_agents(options, authors::parse_agents_xml(text, name), name);
}

}  // namespace

bool lists_agents(const PlanOptions& options, const io::MapFile& map) {
    const bool places = options.start || options.goal || !options.mission.empty();
    return !options.agents.empty() || (!places && map.task && !map.task->agents.empty());
}

std::vector<Agent> team_of(const PlanOptions& options, const io::MapFile& map, const Base& base) {
    std::vector<Agent> agents = ground_agents(options, map);
    // One base for all aircraft.
    const Cell start = base.start.value_or(agents.front().start);
    for (int i = 0; i < options.aircraft.value_or(0); ++i) {
        Agent& agent = agents.emplace_back();
        agent.id = fmt::format("air{}", i + 1);
        agent.kind = AgentKind::air;
        agent.start = start;
        agent.goal = base.goal.value_or(start);
        agent.breaches = options.breaches.value_or(any_number);
    }
    return agents;
}

void share_out_flight(const PlanOptions& options, Mission& mission) {
    if (options.own_breaches) {
        mission.agents.pop_back();
        mission.agents.front().own_breaches = *options.own_breaches;
        return;
    }
    if (options.breaches) mission.agents.back().breaches = *options.breaches;
    const int aircraft = options.aircraft.value_or(1);
    if (aircraft == 1) return;
    const Agent one = mission.agents.back();
    mission.agents.pop_back();
    for (int i = 1; i <= aircraft; ++i) {
        mission.agents.push_back(one);
        mission.agents.back().id = fmt::format("air{}", i);
    }
}

void validate_sources_of_agents(const PlanOptions& options, const io::MapFile& map) {
    if (options.agents.empty()) {
        if (options.count && !lists_agents(options, map)) throw InputError("--count is for --agents FILE");
        if (options.aircraft && !options.mission.empty()) {
            throw InputError("--aircraft and --mission both say who flies; list the aircraft in the mission file");
        }
    } else if (!options.mission.empty()) {
        throw InputError("--agents and --mission both say who the agents are; drop one of them");
    }
    if (options.breaches && !options.aircraft) throw InputError("--breaches is for --aircraft N");
    const bool flies = options.aircraft || options.air_start || options.air_goal || options.air_speed;
    if (options.own_breaches && flies) {
        throw InputError(
            "--own-breaches is for a ground agent without aircraft; drop --aircraft, --air-start, --air-goal and "
            "--air-speed");
    }
    if (options.own_breaches && (!options.mission.empty() || lists_agents(options, map)))
        throw InputError("--own-breaches is for --start and --goal; in a mission file the agent has breaches");
}

void validate_team_options(const PlanOptions& options, const io::MapFile& map, const Mission& mission) {
    if (!mission.is_team()) return;
    const auto vehicles = std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind);
    const bool drives_alone = vehicles == 1 && mission.agents.size() > 1;
    const bool ways = options.paper || options.flight || options.planner || needs_search(options);
    if (ways && !drives_alone) {
        throw InputError(
            "--paper, --flight, --planner, --heuristic, --weight, --tie-break and --trace are for one ground agent "
            "with aircraft");
    }
    const auto breaches = [](const Agent& agent) { return agent.kind == AgentKind::air || agent.own_breaches > 0; };
    const bool selects = options.select.value_or(Selection::none) != Selection::none;
    const bool removes = options.removals.value_or(0) > 0 || selects || options.budget || !options.weights.empty();
    if (removes && std::ranges::none_of(mission.agents, breaches)) {
        throw InputError(
            "-n, --select, --budget and --weights need somebody who removes: add --aircraft N, or in a mission file an "
            "agent of kind air, or drop them");
    }
    const bool have_places = lists_agents(options, map) || !options.mission.empty();
    const bool elsewhere = (options.air_start || options.air_goal) && !options.aircraft;
    if (have_places && (options.start || options.goal || elsewhere)) {
        throw InputError(
            "--start and --goal are for one ground agent and its aircraft; these agents have places of their own");
    }
}

void add_team_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--agents", options.agents,
             "Plan for several ground agents: the lines of a MovingAI scenario file, or the agents of an XML task of "
             "AA-SIPP(m) or CCBS (default: those of the map's own file, if it lists any)");
    add_count(
        command, "--count", [&options](std::int64_t n) { options.count = int(n); }, 1, most_agents,
        "Only so many of them, the first ones (default: all)");
    add_count(
        command, "--aircraft", [&options](std::int64_t n) { options.aircraft = int(n); }, 1, most_agents,
        "So many aircraft that remove obstacles. With --agents they start at --air-start, or where the first ground "
        "agent does, and return there unless --air-goal says otherwise (default: none); without, they fly from start "
        "to goal (default: 1)");
    add_count(
        command, "--breaches", [&options](std::int64_t n) { options.breaches = int(n); }, 0, any_number,
        "How many obstacles each of the aircraft may breach (default: as many as may be removed)");
    add_count(
        command, "--own-breaches", [&options](std::int64_t n) { options.own_breaches = int(n); }, 1, any_number,
        "No aircraft flies: the ground agent itself breaches up to so many obstacles in its way, and stands before "
        "each "
        "for as long as that takes");
    add_measure(command, "--separation", options.separation, radii, length_units, "LENGTH",
                "Room between any two ground agents, in cells, or metres such as 2m (default: 0)");
    add_choice(command, "--at-goal", io::at_goal_words,
               says(options, [](io::MissionDocument& d) -> auto& { return d.mission.rules.at_goal; }),
               "Whether ground agents that have arrived stay, in the way of others, or leave (default: stay)");
}

}  // namespace waybreaker::apps

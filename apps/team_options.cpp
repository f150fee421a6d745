#include "team_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "measure.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::apps {
namespace {

constexpr std::size_t max_scenario_bytes = std::size_t{1} << 26U;

// The first lines of a scenario file, named by their numbers.
std::vector<Agent> scenario_agents(const PlanOptions& options, const Map& map) {
    const std::string text = io::read_whole(options.agents, max_scenario_bytes);
    std::vector<Scenario> scenarios = read_movingai_scenarios(text, io::input_name(options.agents));
    const std::size_t count = std::size_t(options.count.value_or(int(std::min(scenarios.size(), most_agents))));
    if (scenarios.empty()) throw InputError(io::input_name(options.agents), 0, "holds no scenarios");
    if (count > scenarios.size()) {
        throw InputError(io::input_name(options.agents), 0,
                         fmt::format("has {} scenarios; give a smaller --count", scenarios.size()));
    }
    std::vector<Agent> agents(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (scenarios[i].width != map.width() || scenarios[i].height != map.height()) {
            throw InputError(io::input_name(options.agents), 0,
                             fmt::format("is for a map of {} x {} cells, not {} x {}", scenarios[i].width,
                                         scenarios[i].height, map.width(), map.height()));
        }
        agents[i].id = std::to_string(i + 1);
        agents[i].start = scenarios[i].start;
        agents[i].goal = scenarios[i].goal;
    }
    return agents;
}

}  // namespace

std::vector<Agent> team_of(const PlanOptions& options, const Map& map, const Base& base) {
    std::vector<Agent> agents = scenario_agents(options, map);
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

void validate_sources_of_agents(const PlanOptions& options) {
    if (options.agents.empty()) {
        if (options.count) throw InputError("--count is for --agents FILE");
        if (options.aircraft && !options.mission.empty()) {
            throw InputError("--aircraft and --mission both say who flies; list the aircraft in the mission file");
        }
    } else if (!options.mission.empty()) {
        throw InputError("--agents and --mission both say who the agents are; drop one of them");
    }
    if (options.breaches && !options.aircraft) throw InputError("--breaches is for --aircraft N");
}

void validate_team_options(const PlanOptions& options, const Mission& mission) {
    if (!mission.is_team()) return;
    const bool ways = options.paper || options.select || options.flight || options.planner || needs_search(options);
    if (ways) {
        throw InputError(
            "--paper, --select, --flight, --planner, --heuristic, --weight, --tie-break and --trace are for one ground "
            "and one air agent");
    }
    const auto flies = [](const Agent& agent) { return agent.kind == AgentKind::air; };
    const bool removes = options.removals.value_or(0) > 0 || options.budget || !options.weights.empty();
    if (removes && std::ranges::none_of(mission.agents, flies)) {
        throw InputError(
            "-n, --budget and --weights need somebody who removes: add --aircraft N, or in a mission file an agent of "
            "kind air, or drop them");
    }
    const bool have_places = !options.agents.empty() || !options.mission.empty();
    const bool elsewhere = (options.air_start || options.air_goal) && !options.aircraft;
    if (have_places && (options.start || options.goal || elsewhere)) {
        throw InputError(
            "--start and --goal are for one ground agent and its aircraft; these agents have places of their own");
    }
}

void add_team_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--agents", options.agents,
             "Plan for several ground agents: the lines of a MovingAI scenario file");
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
    add_measure(command, "--separation", options.separation, radii, length_units, "LENGTH",
                "Room between any two ground agents, in cells, or metres such as 2m (default: 0)");
    add_choice(command, "--at-goal", io::at_goal_words, options.at_goal,
               "Whether ground agents that have arrived stay, in the way of others, or leave (default: stay)");
}

}  // namespace waybreaker::apps

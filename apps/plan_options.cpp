#include "plan_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>

#include "io/option_words.hpp"
#include "io/weights.hpp"
#include "option.hpp"
#include "team_options.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

const Choices<bool> move_counts{{"8", true}, {"4", false}};

constexpr int most_auto_removals = 32;

constexpr Range speeds{least_speed, most_speed};
constexpr Range breach_times{0, most_breach_time};
constexpr double default_seconds = 10;

// A whole number, or "auto".
void add_removals(CLI::App& command, PlanOptions& options) {
    CLI::Option* option = add_count(
        command, "-n,--removals", [&options](std::int64_t n) { options.removals = int(n); }, 0, INT_MAX,
        "How many obstacles may be removed; 0 means none, auto as many as gain anything (default: 3)");
    option->transform([&options](const std::string& given) {
        options.removals_auto = given == "auto";
        return options.removals_auto ? std::to_string(most_auto_removals) : given;
    });
    option->type_name("N|auto");
}

void add_mission_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--mission", options.mission,
             "Read the mission from a mission file (JSON); other options override what it says");
    add_team_options(command, options);
    add_cell(command, "--start", options.start, "Cell where both agents start (default: as the map file says)");
    add_cell(command, "--goal", options.goal, "Cell where both agents end (default: as the map file says)");
    add_cell(command, "--air-start", options.air_start, "Cell where the air agent starts, if elsewhere");
    add_cell(command, "--air-goal", options.air_goal, "Cell where the air agent ends, if elsewhere");
    add_number(
        command, "--ground-speed", [&options](double speed) { options.ground_speed = speed; }, speeds, "SPEED",
        "Cells per unit of time that the ground agent drives (default: 1)");
    add_number(
        command, "--air-speed", [&options](double speed) { options.air_speed = speed; }, speeds, "SPEED",
        "Cells per unit of time that the air agent flies (default: 1)");
    add_number(
        command, "--breach-time", [&options](double time) { options.breach_time = time; }, breach_times, "TIME",
        "How long the air agent stays to breach an obstacle, beside what the map says of each (default: 0)");
    add_number(
        command, "--breach-time-per-cell", [&options](double time) { options.breach_time_per_cell = time; },
        breach_times, "TIME", "How much longer for each cell of the obstacle (default: 0)");
    add_obstacles(command, "--protect", options.protect, "Obstacles that must stay");
    add_obstacles(command, "--force", options.force, "Obstacles that must go; they count among the removals");
    add_connectivity(command, options.connectivity);
    add_image_reading(command, options.image);
    add_number(
        command, "--cell-size", [&options](double metres) { options.cell_size = metres; },
        {io::least_cell_size, io::most_cell_size}, "METRES",
        "Side of a cell, for lengths in metres (default: as the map file says)");
}

// A weight, or an area such as 800m2.
void add_budget(CLI::App& command, PlanOptions& options) {
    CLI::Option* option = add_number(
        command, "--budget", [&options](double budget) { options.budget = budget; }, {least_weight, most_weight},
        "WEIGHT|AREA",
        "What the removed obstacles may weigh together, each 1 unless the map or --weights says otherwise; or how many "
        "square metres they may cover: 800m2. Alone it stands in place of a count");
    option->transform([&options](std::string given) {
        constexpr std::string_view unit = "m2";
        options.area_budget = given.ends_with(unit);
        if (options.area_budget) given.resize(given.size() - unit.size());
        return given;
    });
}

void add_method_options(CLI::App& command, PlanOptions& options) {
    command.add_flag("--paper", options.paper,
                     "The paper's method: --select hits --flight nearest --timing ignore --planner theta; for -n 1 its "
                     "exact flight past one obstacle");
    add_removals(command, options);
    add_choice(command, "--select", io::selection_words, options.select,
               "Obstacles chosen with a proven bound on every other choice; those that the search ran into most "
               "often, as in the paper; again and again the one that shortens the ground path most; or none "
               "(default: exact)");
    add_budget(command, options);
    add_file(command, "--weights", options.weights,
             "Weights of obstacles: a file with lines \"ID WEIGHT\", or the word cells for each obstacle's number of "
             "cells");
    add_time_limit(
        command, "--time-limit", options.time_limit,
        "Stop planning so long after the start, with the best plan known and how far it can be from the best; none "
        "takes the time it needs (default: 10)");
    command.add_flag("--bound", options.bound, "Prove a limit that no plan can beat also where the method proves none");
    command.add_flag("--explain", options.explain,
                     "Say what each removal saves, and which obstacle one removal more would take");
    add_choice(command, "--flight", io::flight_words, options.flight,
               "Shortest flight that touches every removed obstacle, or the paper's: past the cells nearest to the "
               "straight line (default: optimal)");
    add_choice(command, "--timing", io::timing_words, options.timing,
               "An obstacle is solid until it has been breached, so that the ground agent waits or drives around; or, "
               "as in the paper, removed obstacles are taken as never there (default: enforce)");
    add_choice(command, "--objective", io::objective_words, options.objective,
               "What the plan makes small: when the last agent arrives, the sum of all arrival times, or when the "
               "ground agent "
               "arrives, whenever the aircraft is home (default: makespan)");
}

void add_search_options(CLI::App& command, PlanOptions& options) {
    add_choice(
        command, "--planner", io::planner_words, options.planner,
        "Search of the ground agent (default: optimal; theta where the way to select, the agent or its moves need it)");
    add_choice(command, "--heuristic", io::heuristic_words, options.heuristic,
               "Estimate of the way to go (default: euclidean for theta and lazy-theta, octile for astar and jps)");
    add_number(
        command, "--weight", [&options](double weight) { options.weight = weight; }, {1, most_heuristic_weight}, "W",
        "Weight of the heuristic, at least 1 (default: 1)");
    add_choice(
        command, "--tie-break", io::tie_break_words, options.tie_break,
        "Of two equally promising nodes take the one farther from (g-max) or nearer to the start (default: g-max)");
    add_choice(command, "--corners", io::corner_words, options.corners,
               "Diagonal steps pass no blocked cell at their side, one, or two (default: none)");
    add_length(command, "--radius", options.radius, largest_radius,
               "Radius of the ground agent; 0 for a point (default: 0.5)");
    add_choice(command, "--moves", move_counts, options.diagonal, "Steps from a cell (default: 8)");
    add_count(
        command, "--expansion-limit", [&options](std::int64_t n) { options.expansion_limit = std::uint64_t(n); }, 1,
        INT64_MAX, "Give up a search after so many expansions");
}

void add_output_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--json", options.json, "Write the plan; - is standard output, here and below");
    add_file(command, "--save-mission", options.save_mission,
             "Write the mission, options included, as a mission file for --mission");
    add_file(command, "--svg", options.svg, "Write a picture");
    add_file(command, "--png", options.png, "Write a picture");
    add_file(command, "--html", options.html,
             "Write a page for a browser that plays the plan: one file, no network needed");
    add_file(command, "--trace", options.trace,
             "Write every step of the first ground search, for the Posthoc search visualiser (NAME.trace.json)");
    add_plan_exports(command, options.exports);
    command.add_flag("--no-timing", options.no_timing,
                     "Leave out measured times, so that equal input gives equal bytes");
}

}  // namespace

bool needs_search(const PlanOptions& options) {
    return options.heuristic || options.weight || options.tie_break || !options.trace.empty();
}

void add_plan_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "MAP", options.map,
             "A map: MovingAI, the authors' XML, GeoTIFF, the YAML of a ROS map, PNG, PGM, ...; - is standard input")
        ->required();
    command.option_defaults()->group("Mission");
    add_mission_options(command, options);
    command.option_defaults()->group("Method");
    add_method_options(command, options);
    command.option_defaults()->group("Ground search");
    add_search_options(command, options);
    command.option_defaults()->group("Output");
    add_output_options(command, options);
}

void validate(const PlanOptions& options) {
    if (options.planner == Planner::optimal && needs_search(options)) {
        throw InputError("--planner optimal has no --heuristic, --weight, --tie-break or --trace; use theta for them");
    }
    if (options.paper && options.planner && *options.planner != Planner::theta) {
        throw InputError(
            fmt::format("--paper stands for --planner theta, which --planner {} contradicts; drop one of them",
                        io::word_of(io::planner_words, *options.planner)));
    }
    if (options.paper && options.select && *options.select != Selection::hits) {
        throw InputError(
            fmt::format("--paper stands for --select hits, which --select {} contradicts; drop one of them",
                        io::word_of(io::selection_words, *options.select)));
    }
    if (options.paper && options.flight == FlightRule::optimal && options.removals.value_or(3) > 1) {
        throw InputError("--paper stands for --flight nearest, which --flight optimal contradicts; drop one of them");
    }
    if (options.paper && options.timing == Timing::enforce) {
        throw InputError("--paper stands for --timing ignore, which --timing enforce contradicts; drop one of them");
    }
    NamedFiles outputs = named_outputs(options.exports);
    outputs.insert(outputs.begin(), {{"--json", options.json},
                                     {"--svg", options.svg},
                                     {"--png", options.png},
                                     {"--html", options.html},
                                     {"--trace", options.trace},
                                     {"--save-mission", options.save_mission}});
    const NamedFiles inputs{{"MAP", options.map},
                            {"--weights", options.weights},
                            {"--mission", options.mission},
                            {"--agents", options.agents}};
    validate_inputs(inputs);
    validate_outputs(outputs, inputs);
}

std::optional<std::vector<double>> weights_of(const PlanOptions& options, const io::MissionDocument& mission,
                                              const io::MapFile& map) {
    if (mission.area_budget && !options.weights.empty()) {
        throw InputError("a budget of square metres weighs obstacles by their area, which --weights contradicts");
    }
    if (mission.area_budget) return io::area_weights(map);
    if (options.weights.empty()) return std::nullopt;
    if (options.weights != "cells") return io::read_weights(options.weights, map.map);
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.map.obstacles()) weights.push_back(obstacle.cells);
    return weights;
}

namespace {

void set_agents(const PlanOptions& options, const io::MapFile& map, Mission& mission) {
    if (!options.agents.empty()) mission.agents = team_of(options, map.map);
    validate_team_options(options, mission);
    const auto place = [&map](const std::optional<Cell>& given, std::optional<Cell> io::MapTask::*in_file,
                              const char* option) {
        if (given) return *given;
        if (map.task && (*map.task).*in_file) return *((*map.task).*in_file);
        throw InputError(fmt::format("{} X,Y is missing, and {} does not say it", option, map.source));
    };
    if (mission.agents.empty()) {
        mission = ground_and_air(place(options.start, &io::MapTask::start, "--start"),
                                 place(options.goal, &io::MapTask::goal, "--goal"));
        if (map.task) mission.agents.front().body = map.task->search.body;
    }
    for (Agent& agent : mission.agents) {
        const bool flies = agent.kind == AgentKind::air;
        if (options.start) agent.start = *options.start;
        if (options.goal) agent.goal = *options.goal;
        if (flies) {
            agent.start = options.air_start.value_or(agent.start);
            agent.goal = options.air_goal.value_or(agent.goal);
        } else {
            agent.body.corners = options.corners.value_or(agent.body.corners);
            agent.body.radius = options.radius.value_or(agent.body.radius);
        }
        agent.speed = (flies ? options.air_speed : options.ground_speed).value_or(agent.speed);
    }
}

void set_rules(const PlanOptions& options, const Map& map, Rules& rules) {
    if (options.budget) {
        rules.budget = *options.budget;
        // Without --removals, the budget replaces the count.
        if (options.mission.empty()) rules.removals = int(std::min<std::size_t>(map.obstacles().size(), INT_MAX));
    }
    rules.removals = options.removals.value_or(rules.removals);
    rules.breach_time.per_obstacle = options.breach_time.value_or(rules.breach_time.per_obstacle);
    rules.breach_time.per_cell = options.breach_time_per_cell.value_or(rules.breach_time.per_cell);
    if (!options.protect.empty()) rules.protect = options.protect;
    if (!options.force.empty()) rules.force = options.force;
    rules.objective = options.objective.value_or(rules.objective);
    rules.separation = options.separation.value_or(rules.separation);
    rules.at_goal = options.at_goal.value_or(rules.at_goal);
}

void set_method(const PlanOptions& options, Method& method) {
    method.select = options.select.value_or(method.select);
    method.flight = options.flight.value_or(method.flight);
    method.planner = options.planner.value_or(method.planner);
    if (options.heuristic) method.heuristic = options.heuristic;
    method.weight = options.weight.value_or(method.weight);
    method.tie_break = options.tie_break.value_or(method.tie_break);
    method.diagonal = options.diagonal.value_or(method.diagonal);
    method.bound = method.bound || options.bound;
    method.explain = method.explain || options.explain;
}

}  // namespace

io::MissionDocument mission_of(const PlanOptions& options, const io::MapFile& map) {
    const Limits limits{.seconds = default_seconds};
    io::MissionDocument result{.mission = {}, .limits = limits};
    if (!options.mission.empty()) result = io::read_mission_file(options.mission, limits);
    Mission& mission = result.mission;
    Method& method = result.method;
    const bool from_map = map.task && options.mission.empty() && options.agents.empty();
    set_agents(options, map, mission);
    set_rules(options, map.map, mission.rules);
    if (options.budget) result.area_budget = options.area_budget;
    if (from_map) {
        const SearchOptions& search = map.task->search;
        method.heuristic = search.heuristic;
        method.weight = search.weight;
        method.tie_break = search.tie_break;
        method.diagonal = search.diagonal;
        method.planner = search.planner;
    } else if (needs_search(options)) {
        method.planner = Planner::theta;
    }
    if (options.paper) follow_paper(mission.rules, method);
    set_method(options, method);
    mission.rules.timing = options.timing.value_or(mission.rules.timing);
    result.limits.seconds = options.time_limit.value_or(result.limits.seconds);
    result.limits.expansions = options.expansion_limit.value_or(result.limits.expansions);
    const Planner planner = planner_of(method, mission.ground_body());
    if (options.planner == Planner::optimal && planner != Planner::optimal) {
        throw InputError(
            "--planner optimal drives an agent that passes no blocked corner by eight moves, and counts no hits; "
            "drop it, or the option that contradicts it");
    }
    method.planner = planner;
    return result;
}

}  // namespace waybreaker::apps

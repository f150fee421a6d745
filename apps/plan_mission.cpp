// The mission that the options of `waybreaker plan` describe together with a map file.
#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "core/range.hpp"
#include "io/excerpt.hpp"
#include "io/output_file.hpp"
#include "io/weights.hpp"
#include "model/nearest_place.hpp"
#include "note.hpp"
#include "places.hpp"
#include "plan_options.hpp"
#include "range_options.hpp"
#include "team_options.hpp"
#include "waybreaker/error.hpp"
#include "zone_options.hpp"

namespace waybreaker::apps {
std::optional<std::vector<double>> weights_of(const PlanOptions& options, const io::MissionDocument& mission,
                                              const Map& map) {
    if (options.weights.empty()) return std::nullopt;
    if (mission.area_budget) {
        throw InputError("a budget of square metres weighs obstacles by their area, which --weights contradicts");
    }
    return options.weights == "cells" ? io::cell_weights(map) : io::read_weights(options.weights, map);
}

namespace {

constexpr double default_seconds = 10;

// What options mean on the map.
struct Places {
    std::optional<Cell> start, goal, air_start, air_goal;
    std::vector<Cell> bases;
};

Cell centre_of(const site::NamedPlace& place) {
    return {int(std::lround(place.at.x)), int(std::lround(place.at.y))};
}

Places places_of(const PlanOptions& options, const io::MapFile& map) {
    const auto cell = [&](const std::optional<GivenPlace>& place) -> std::optional<Cell> {
        if (!place) return std::nullopt;
        return place->is_name       ? centre_of(place_called(*place, map))
               : options.lon_lat    ? cell_at_lon_lat(*place, map)
               : options.map_metres ? cell_at_metres(*place, map)
                                    : cell_of(*place);
    };
    Places places{cell(options.start), cell(options.goal), cell(options.air_start), cell(options.air_goal), {}};
    for (const GivenPlace& base : options.bases) {
        places.bases.push_back(*cell(base));
        if (!map.map.grid().contains(places.bases.back()))
            throw InputError(fmt::format("--base {} is off the map: x goes from 0 to {}, y from 0 to {}",
                                         place_text(places.bases.back(), options, map), map.map.width() - 1,
                                         map.map.height() - 1));
    }
    return places;
}

// A name stands for the nearest cell where the ground agent has room.
void leave_obstacles(const PlanOptions& options, const io::MapFile& map, const Places& places, Mission& mission) {
    const OpenedMap closed(map.map);
    const auto leave = [&](const std::optional<GivenPlace>& given, const std::optional<Cell>& named, Cell Agent::*end) {
        if (!given || !given->is_name) return;
        const Cell at = nearest_place(closed, *named, mission.ground_body()).value_or(*named);
        const site::NamedPlace place = place_called(*given, map);
        note(map.source,
             fmt::format("{} is {} ({}): {}", given->option, place.name, place.what, place_text(at, options, map)));
        for (Agent& agent : mission.agents) {
            if (agent.*end == *named) agent.*end = at;
        }
    };
    leave(options.start, places.start, &Agent::start);
    leave(options.goal, places.goal, &Agent::goal);
}

// Thousandths of a cell count; of metres never less than asked for.
double radius_of(const Measure& radius, const io::MapFile& map) {
    constexpr double thousandths = 1000;
    const double cells = in_cells(radius, map, radii) * thousandths;
    return (radius.metric ? std::ceil(cells * (1 - 1e-12)) : std::round(cells)) / thousandths;
}

void set_agents(const PlanOptions& options, const io::MapFile& map, Mission& mission) {
    const Places places = places_of(options, map);
    validate_sources_of_agents(options, map);
    if (lists_agents(options, map)) mission.agents = team_of(options, map, {places.air_start, places.air_goal});
    const auto place = [&map](const std::optional<Cell>& given, std::optional<Cell> io::MapTask::*in_file,
                              const char* option) {
        if (given) return *given;
        if (map.task && (*map.task).*in_file) return *((*map.task).*in_file);
        throw InputError(fmt::format("{} X,Y is missing, and {} does not say it", option, map.source));
    };
    if (mission.agents.empty()) {
        const Cell start = place(places.start, &io::MapTask::start, "--start");
        const Cell goal = place(places.goal, &io::MapTask::goal, "--goal");
        mission = ground_and_air(start, goal);
        if (map.task) mission.agents.front().body = map.task->search.body;
        share_out_flight(options, mission);
    }
    validate_team_options(options, map, mission);
    for (Agent& agent : mission.agents) {
        const bool flies = agent.kind == AgentKind::air;
        agent.start = places.start.value_or(agent.start);
        agent.goal = places.goal.value_or(agent.goal);
        if (flies) {
            agent.start = places.air_start.value_or(agent.start);
            agent.goal = places.air_goal.value_or(agent.goal);
            if (!places.bases.empty()) agent.bases = places.bases;
        } else {
            agent.body.corners = options.corners.value_or(agent.body.corners);
            if (options.radius) agent.body.radius = radius_of(*options.radius, map);
        }
    }
    leave_obstacles(options, map, places, mission);
}

// Of whoever nobody has said how large it is.
void set_sizes(const PlanOptions& options, const io::MapFile& map, io::MissionDocument& document) {
    const bool from_task = map.task || !options.agents.empty();  // which say it, or mean the usual size
    if (options.mission.empty() && !from_task) {
        for (std::size_t i = 0; i < document.mission.agents.size(); ++i) {
            if (document.mission.agents[i].kind == AgentKind::ground) document.unsized.push_back(i);
        }
    }
    if (options.radius) document.unsized.clear();
    const std::optional<site::Profile> profile = map.annotations.profile;
    if (!io::size_agents(document, map) || !profile) return;
    note(map.source, fmt::format("is made for a {}, {} m wide: its radius is {} cells; --radius says another",
                                 site::profile_word(*profile), site::vehicle_width(*profile), io::usual_radius(map)));
}

// Speeds in metres per second make a unit of time a second, and so do times in seconds: without any speed both agents
// then move at 1 m/s.
void set_clock(const PlanOptions& options, const io::MapFile& map, io::MissionDocument& document) {
    const auto metric = [](const std::optional<Measure>& measure) { return measure && measure->metric; };
    const std::optional<Measure>* const times[] = {&options.breach_time, &options.breach_time_per_cell, &options.rubble,
                                                   &options.endurance};
    const auto* const metric_time = std::ranges::find_if(times, [&](const auto* time) { return metric(*time); });
    const auto given = [&options](const Agent& agent) -> const std::optional<Measure>& {
        return agent.kind == AgentKind::air ? options.air_speed : options.ground_speed;
    };
    for (Agent& agent : document.mission.agents) {
        if (const std::optional<Measure>& speed = given(agent)) agent.speed = in_cells(*speed, map, speeds);
    }
    if (metric(options.ground_speed) || metric(options.air_speed)) {
        const auto is_metric = [&](const Agent& agent) { return metric(given(agent)); };
        if (!document.in_seconds && !std::ranges::all_of(document.mission.agents, is_metric)) {
            throw InputError(fmt::format("with a speed in m/s a unit of time is a second: give {} in m/s, too",
                                         metric(options.air_speed) ? "--ground-speed" : "--air-speed"));
        }
        document.in_seconds = true;
    }
    if (metric_time == std::end(times) || document.in_seconds) return;
    const Measure time = (*metric_time)->value_or(Measure{});
    const auto usual = [](const Agent& agent) { return agent.speed == 1; };
    if (options.ground_speed || options.air_speed || !std::ranges::all_of(document.mission.agents, usual)) {
        throw InputError(
            fmt::format("{} {}: give the speeds in m/s, so that a unit of time is a second", time.option, time.text));
    }
    const Measure walking{.option = time.option, .text = time.text, .value = 1, .metric = true};
    for (Agent& agent : document.mission.agents) agent.speed = in_cells(walking, map, speeds);
    document.in_seconds = true;
}

double time_of(const Measure& time) {
    if (time.value <= breach_times.most) return time.value;
    throw InputError(fmt::format("{} {} is too long: at most {}s are possible", time.option, time.text,
                                 number_text(breach_times.most)));
}

void set_rules(const PlanOptions& options, const io::MapFile& file, Rules& rules) {
    const Map& map = file.map;
    if (options.budget) {
        rules.budget = *options.budget;
        // Without --removals, the budget replaces the count.
        if (options.mission.empty()) rules.removals = int(std::min<std::size_t>(map.obstacles().size(), INT_MAX));
    }
    rules.removals = options.removals.value_or(rules.removals);
    if (options.breach_time) rules.breach_time.per_obstacle = time_of(*options.breach_time);
    if (options.breach_time_per_cell) rules.breach_time.per_cell = time_of(*options.breach_time_per_cell);
    if (options.rubble) rules.rubble = time_of(*options.rubble);
    if (!options.force.empty()) rules.force = options.force;
    if (!options.zones.empty()) rules.zones = read_zones_file(options.zones, file);
    if (options.separation) rules.separation = in_cells(*options.separation, file, radii);
}

void set_protected(const PlanOptions& options, io::MissionDocument& document) {
    if (options.protect.empty() && options.protect_tags.empty()) return;
    document.mission.rules.protect = options.protect;
    document.protect_tags = options.protect_tags;
}

void set_method(const PlanOptions& options, Method& method) {
    method.select = options.select.value_or(method.select);
    method.flight = options.flight.value_or(method.flight);
    method.planner = options.planner.value_or(method.planner);
    if (options.heuristic) method.heuristic = options.heuristic;
    method.weight = options.weight.value_or(method.weight);
    method.tie_break = options.tie_break.value_or(method.tie_break);
    method.bound = method.bound || options.bound;
    method.explain = method.explain || options.explain;
}

// A ground agent breaches nothing unless it is said to.
void note_idle_breachers(const std::string& file, const Mission& mission) {
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air || agent.own_breaches > 0) continue;
        if (!agent.can_breach && !agent.breach_time && !agent.breach_time_per_cell) continue;
        note(file, fmt::format("agent {} has no breaches, so it breaches nothing: give it how many it may make",
                               io::excerpt(agent.id)));
    }
}

}  // namespace

io::MissionDocument given_mission(const PlanOptions& options) {
    const Limits limits{.seconds = default_seconds};
    io::MissionDocument result{.mission = {}, .limits = limits};
    if (!options.mission.empty()) result = io::read_mission_file(options.mission, limits);
    result.map.clear();  // it is for the map given
    if (!options.overlays.files.empty()) result.overlays = overlays_of(options.overlays);
    return result;
}

io::MissionDocument mission_of(const PlanOptions& options, io::MissionDocument given, const io::MapFile& map) {
    io::MissionDocument result = std::move(given);
    Mission& mission = result.mission;
    Method& method = result.method;
    const bool from_map = map.task && options.mission.empty() && !lists_agents(options, map);
    if (!options.mission.empty()) note_idle_breachers(io::input_name(options.mission), mission);
    set_agents(options, map, mission);
    set_sizes(options, map, result);
    set_clock(options, map, result);
    set_ranges(options, map, result);
    set_rules(options, map, mission.rules);
    if (options.budget) result.area_budget = options.area_budget;
    set_protected(options, result);
    if (from_map) {
        const SearchOptions& search = map.task->search;
        method.heuristic = search.heuristic;
        method.weight = search.weight;
        method.tie_break = search.tie_break;
        method.diagonal = search.diagonal;
        method.planner = search.planner;
    } else if (needs_search(options)) {
        method.planner = Algorithm::theta;
    }
    say(options, result);
    set_method(options, method);
    result.limits.threads = options.threads;
    const Algorithm planner = planner_of(method, mission.ground_body());
    if (options.planner == Algorithm::optimal && planner != Algorithm::optimal) {
        throw InputError(
            "--planner optimal drives an agent that passes no blocked corner by eight moves, and counts no hits; "
            "drop it, or the option that contradicts it");
    }
    const bool by_steps = planner == Algorithm::astar || planner == Algorithm::jps || planner == Algorithm::dijkstra ||
                          planner == Algorithm::bfs;
    if (from_map && map.task->smoothing && by_steps) {
        note(map.source, "its <postsmoothing> is not heeded; --planner theta or optimal makes straight paths");
    }
    return result;
}

}  // namespace waybreaker::apps

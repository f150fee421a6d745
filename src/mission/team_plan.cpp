#include "mission/team_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "coalition/coalition.hpp"
#include "core/stopwatch.hpp"
#include "mission/entries.hpp"
#include "mission/plan_status.hpp"
#include "mission/team_hits.hpp"
#include "model/bases.hpp"
#include "model/objective.hpp"
#include "model/timeline.hpp"
#include "schedule/tour_times.hpp"
#include "select/hits.hpp"
#include "team/team.hpp"

namespace waybreaker {
namespace {

void set_figures(Outcome& outcome, const Finish& finish) {
    outcome.makespan = finish.makespan();
    outcome.flowtime = finish.flowtime;
    outcome.ground_makespan = finish.ground;
}

Route flight(const Agent& agent) {
    Route route;
    route.kind = AgentKind::air;
    route.path = route_home(agent);
    route.length = path_length(route.path);
    return route;
}

Route drive(const team::Vehicle& vehicle, std::vector<Point> path) {
    Route route;
    route.length = path_length(path);
    route.path = std::move(path);
    route.expanded = vehicle.expanded;
    route.generated = vehicle.generated;
    route.seconds = vehicle.seconds;
    return route;
}

// Every agent as if it were alone, and the earliest that each can arrive; no figures of all where one has no way.
void add_alone(const Mission& mission, std::span<const team::Vehicle> vehicles, Plan& plan) {
    Finish alone;
    Finish least;
    bool all = true;
    plan.before.routes.clear();
    auto vehicle = vehicles.begin();
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) {
            plan.before.routes.push_back(flight(agent));
            const double time = agent.ready_at + way_home(agent).lasts;
            alone.add(agent, time);
            least.add(agent, time);
        } else {
            plan.before.routes.push_back(drive(*vehicle, {vehicle->way.begin(), vehicle->way.end()}));
            alone.add(agent, vehicle->alone);
            least.add(agent, vehicle->bound);
            if (vehicle->way.empty()) plan.before.routes.back().length.reset();
            all = all && (!vehicle->way.empty() || mission.rules.unreached);
            ++vehicle;
        }
    }
    if (!all) return;
    set_figures(plan.before, alone);
    plan.bound = rank(mission.rules.objective, least).first;
}

// Where the aircraft fly: in the mission's order, each straight home but for its landings.
using Flights = std::vector<team::Path>;

Flights straight_flights(const Mission& mission) {
    Flights flights;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::ground) continue;
        Tour landings;
        for (const Cell base : way_home(agent).landings) landings.push_back({Stop::base, base});
        flights.push_back(flown(agent, landings, [](std::size_t) { return 0.0; }));
    }
    return flights;
}

void add_paths(const Mission& mission, team::TeamPlan& team, Flights flights, Plan& plan) {
    Finish finish;
    plan.after.routes.clear();
    std::size_t vehicle = 0;
    std::size_t aircraft = 0;
    for (const Agent& agent : mission.agents) {
        std::vector<Waypoint> path;
        if (agent.kind == AgentKind::air) {
            path = std::move(flights[aircraft++]);
            Route& route = plan.after.routes.emplace_back();
            route.kind = AgentKind::air;
            // Who stays at home has a start and a goal all the same.
            route.path = path.size() == 2 ? flight(agent).path : places(path);
            route.length = path_length(route.path);
        } else {
            path = std::move(team.paths[vehicle]);
            plan.after.routes.push_back(drive(team.vehicles[vehicle], places(path)));
            ++vehicle;
        }
        finish.add(agent, path.back().t);
        const bool reached = Point(path.back().x, path.back().y) == Point(agent.goal);
        if (!reached) plan.after.routes.back().length.reset();
        plan.agents.push_back({agent.id, agent.kind, agent.speed, std::move(path), agent.start, agent.goal, reached});
    }
    set_figures(plan.after, finish);
    const double reached = rank(mission.rules.objective, finish).first;
    if (!plan.bound) return;
    const double bound = std::min(*plan.bound, reached);
    plan.bound = bound;
    plan.gap = bound > 0 ? reached / bound - 1 : 0;
}

std::size_t vehicles_in(const Mission& mission) {
    return std::size_t(std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind));
}

// Routes without a length, for a plan that there is none of.
void add_nothing(const Mission& mission, Outcome& outcome) {
    outcome.routes.clear();
    for (const Agent& agent : mission.agents) {
        outcome.routes.push_back(agent.kind == AgentKind::air ? flight(agent) : Route{});
    }
}

// By hits, of as many obstacles as `most`.
coalition::Choice choice_of(const Map& map, const Mission& mission, const Method& method,
                            std::span<const std::uint32_t> hits, int most) {
    using coalition::Selecting;
    switch (method.select) {
        case Selection::exact:
            return {Selecting::exact};
        case Selection::hits:
            return {mission.rules.timing == Timing::ignore ? Selecting::as_list : Selecting::listed,
                    most_hit(map, mission.rules, hits, most), method.bound};
        case Selection::greedy:
            return {Selecting::greedy, {}, method.bound};
        case Selection::none:
            break;
    }
    return {Selecting::none};
}

// Whether greedy steps drive all vehicles (validate).
bool moves_greedily(const Mission& mission, const Method& method) {
    return std::ranges::all_of(mission.agents, [&](const Agent& agent) {
        return agent.kind == AgentKind::air || planner_of(method, agent.body) == Algorithm::optimal;
    });
}

// Who is where when, and what is breached.
void add_schedule(const Map& map, const Mission& mission, std::span<const std::uint32_t> hits,
                  coalition::CoalitionPlan& made, Plan& plan) {
    plan.breaches = std::move(made.breaches);
    for (Breach& breach : plan.breaches) breach.hits = hits.empty() ? 0 : hits[breach.obstacle.value];
    add_paths(mission, made.team, std::move(made.flights), plan);
    add_entries(map, mission, plan);
}

Plan plan_coalition(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                    coalition::Fewer fewer, Searcher& searcher, CrossingSearcher& crossing, Evaluated* evaluated) {
    const Stopwatch total;
    const team::Interrupts interrupts{Deadline(limits.seconds), limits.stop, limits.expansions, limits.gap,
                                      limits.threads};
    const auto tell = [&](double objective, double bound) {
        if (limits.progress) limits.progress({.best = objective, .bound = bound});
    };
    std::vector<std::uint32_t> hits;
    const auto planned_by = [&](coalition::Choice choice) {
        if (evaluated != nullptr) choice.share = evaluated->share;
        return coalition::plan_coalition(map, mission, choice, fewer, interrupts, crossing, searcher, tell);
    };
    const auto choice_by = [&](const Method& how, int most) {
        if (how.select == Selection::hits && hits.empty()) hits = hits_of_team(map, mission, how, interrupts, searcher);
        return choice_of(map, mission, how, hits, most);
    };
    const int removals = mission.rules.removals;
    coalition::CoalitionPlan made = planned_by(choice_by(method, removals));
    // Takes the place of the plan if it is a better one.
    const auto take = [&](coalition::CoalitionPlan found) {
        if (found.status != SearchStatus::found || found.objective >= made.objective) return;
        found.bound = std::min(made.bound, found.objective);
        found.proven = made.proven;
        found.limited = found.limited || made.limited;
        found.missed = made.missed;
        made = std::move(found);
    };
    // The exact choice does not see collisions: other sets may let vehicles past each other where its own do not.
    const auto is_stuck = [&] {
        const bool lets_past = made.status == SearchStatus::found && !made.missed;
        return method.select == Selection::exact && !lets_past && made.status != SearchStatus::no_path &&
               !interrupts.due();
    };
    Method instead = method;
    instead.bound = false;
    for (const Selection select : {Selection::greedy, Selection::hits}) {
        if (!is_stuck() || (select == Selection::greedy && !moves_greedily(mission, method))) continue;
        instead.select = select;
        coalition::Choice choice = choice_by(instead, removals);
        // Of a list as much as is best.
        if (select == Selection::hits) choice.selecting = coalition::Selecting::listed;
        take(planned_by(choice));
    }
    // As a last resort the obstacles that are hit most, each number of them: more removals are no worse.
    instead.select = Selection::hits;
    const bool is_lost = is_stuck() && made.status != SearchStatus::found && mission.rules.timing == Timing::ignore;
    for (int most = 1; is_lost && most <= removals && !interrupts.due(); ++most) {
        coalition::Choice choice = choice_by(instead, most);
        if (int(choice.list.size()) < most) break;
        take(planned_by(choice));
    }
    if (method.select != Selection::hits) hits.clear();
    Plan plan;
    plan.status = plan_status(made.status);
    if (made.closed.size() == vehicles_in(mission)) {
        add_alone(mission, made.closed, plan);
    } else {
        add_nothing(mission, plan.before);
    }
    plan.bound.reset();
    if (plan.status == PlanStatus::solved) {
        if (made.proven) plan.bound = made.bound;
        add_schedule(map, mission, hits, made, plan);
        for (coalition::CoalitionPlan& other : made.alternatives) {
            Plan& alternative = evaluated->plans.emplace_back();
            alternative.status = plan.status;
            add_schedule(map, mission, hits, other, alternative);
        }
    } else {
        add_nothing(mission, plan.after);
    }
    plan.limit_reached = made.limited || plan.status == PlanStatus::limit_reached;
    for (const team::Vehicle& vehicle : made.closed) plan.seconds.search += vehicle.seconds;
    plan.seconds.total = total.seconds();
    plan.seconds.select = plan.seconds.total - plan.seconds.search;
    return plan;
}

}  // namespace

Plan plan_team(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
               coalition::Fewer fewer, Searcher& searcher, CrossingSearcher& crossing, Evaluated* evaluated) {
    const bool has_aircraft = std::ranges::count(mission.agents, AgentKind::air, &Agent::kind) > 0;
    if (has_aircraft && mission.rules.removals > 0) {
        return plan_coalition(map, mission, method, limits, fewer, searcher, crossing, evaluated);
    }
    const Stopwatch total;
    const team::Interrupts interrupts{Deadline(limits.seconds), limits.stop, limits.expansions, limits.gap};
    Plan plan;
    const auto tell = [&](const team::Cost& cost) {
        if (limits.progress) limits.progress({.best = cost.first});
    };
    std::vector<ObstacleId> opened;
    for (const TimedOpening& opening : mission.rules.opened) opened.push_back(opening.obstacle);
    team::TeamPlan team = team::plan_team(OpenedMap(map, opened), mission, interrupts, crossing, searcher, tell);
    plan.status = plan_status(team.status);
    // A limit may come before the last has been looked at.
    const bool all_alone = team.vehicles.size() == vehicles_in(mission) &&
                           (mission.rules.unreached ||
                            std::ranges::none_of(team.vehicles, &std::vector<Cell>::empty, &team::Vehicle::way));
    if (all_alone) {
        add_alone(mission, team.vehicles, plan);
    } else {
        add_nothing(mission, plan.before);
    }
    if (plan.status == PlanStatus::solved) {
        add_paths(mission, team, straight_flights(mission), plan);
    } else {
        add_nothing(mission, plan.after);
    }
    plan.limit_reached = team.limited || plan.status == PlanStatus::limit_reached;
    for (const team::Vehicle& vehicle : team.vehicles) plan.seconds.search += vehicle.seconds;
    plan.seconds.total = total.seconds();
    return plan;
}

}  // namespace waybreaker

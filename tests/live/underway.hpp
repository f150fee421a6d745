// Random missions under way, for RapidCheck.
#pragma once

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "abilities.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/revise.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker {

// Up to two aircraft.
inline Mission any_mission(const PlainMap& plain, int most_vehicles, int most_retries) {
    Mission mission;
    const int vehicles = *number(1, most_vehicles);
    for (int i = 0; i < vehicles; ++i) {
        Agent rover = vehicle("rover" + std::to_string(i), any_free_cell(plain), any_free_cell(plain));
        rover.speed = *rc::gen::element(0.5, 1.0, 2.0);
        rover.ready_at = *rc::gen::element(0.0, 0.0, 3.0);
        mission.agents.push_back(rover);
    }
    const int aircraft_count = *number(0, 2);
    for (int i = 0; i < aircraft_count; ++i) {
        mission.agents.push_back(
            aircraft("heli" + std::to_string(i), any_cell(plain), any_cell(plain), *rc::gen::element(0.5, 1.0, 4.0)));
    }
    Rules& rules = mission.rules;
    rules.removals = *number(0, 3);
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time.per_obstacle = *rc::gen::element(0.0, 0.0, 2.5, 8.0);
    rules.retries = *number(0, most_retries);
    return mission;
}

// Whether what is removed leaves rubble.
enum class Left { nothing, perhaps_rubble };

inline void leave(Left left, Mission& mission) {
    if (left == Left::perhaps_rubble) mission.rules.rubble = *rc::gen::element(0.0, 0.0, 0.0, 1.5, 4.0);
}

// A few missions of agents that may not breach everything.
inline void limit_some(const Map& map, Mission& mission) {
    if (*number(0, 4) == 0) give_abilities(map, mission, [](int count) { return *number(0, count - 1); });
}

struct Underway {
    Map map;
    Mission mission;
    Plan plan = {};
    State state = {};
};

// Triangles to pentagons whose corners are at centres, sides and corners of cells.
inline std::vector<Zone> some_zones(int side) {
    std::vector<Zone> zones;
    const int count = *number(1, 3);
    for (int i = 0; i < count; ++i) {
        Zone zone{.kind = *rc::gen::element(ZoneKind::no_fly, ZoneKind::no_fly, ZoneKind::keep_out)};
        std::vector<Point>& ring = zone.polygon.emplace_back();
        const Point middle(*number(0, 2 * side) / 2.0, *number(0, 2 * side) / 2.0);
        const int corners = *number(3, 5);
        for (int k = 0; k < corners; ++k)
            ring.emplace_back(middle.x + *number(-side / 2, side / 2) / 2.0,
                              middle.y + *number(-side / 2, side / 2) / 2.0);
        try {
            validate(zone, 1);
            zones.push_back(zone);
        } catch (const InputError&) {
        }
    }
    return zones;
}

// Some that bring aircraft home and little farther, some that have no end, some that are filled at bases.
inline void give_batteries(const PlainMap& plain, Mission& mission) {
    for (Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::ground || *number(0, 3) == 0) continue;
        agent.reserve = *rc::gen::element(0.0, 0.0, 0.2, 0.5);
        const bool recharges = *number(0, 1) == 0;
        const double flight = distance(agent.begin(), Point(agent.goal)) + 0.5 + 0.5 * *number(0, recharges ? 6 : 40);
        if (*number(0, 1) == 0)
            agent.range = flight / (1 - agent.reserve);
        else
            agent.endurance = flight / agent.speed / (1 - agent.reserve);
        if (!recharges) continue;
        agent.recharge = *rc::gen::element(0.1, 0.5, 3.0);
        for (int i = *number(0, 8); i > 0; --i) agent.bases.push_back(any_cell(plain));
    }
}

// One that has a plan, before it begins.
inline Underway any_planned(int side, int most_vehicles, int most_retries, bool zoned = false, bool batteries = false,
                            Left left = Left::nothing) {
    const PlainMap plain = *random_map(side, side);
    Underway drawn{Map(plain.grid()), any_mission(plain, most_vehicles, most_retries)};
    if (zoned) drawn.mission.rules.zones = some_zones(side);
    if (batteries) give_batteries(plain, drawn.mission);
    leave(left, drawn.mission);
    limit_some(drawn.map, drawn.mission);
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("two stand too near, or in a zone");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// Of one agent that opens its own way; before it begins.
inline Underway any_own_way(int side, int most_retries, Left left = Left::nothing) {
    const PlainMap plain = *random_map(side, side);
    Underway drawn{Map(plain.grid()), any_mission(plain, 1, most_retries)};
    drawn.mission.agents.resize(1);
    Agent& dozer = drawn.mission.agents.front();
    dozer.own_breaches = *number(1, 4);
    dozer.body.radius = *rc::gen::element(0.0, 0.4, 0.5, 0.9);
    drawn.mission.rules.removals = *number(1, 4);
    leave(left, drawn.mission);
    limit_some(drawn.map, drawn.mission);
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("no room");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// Of a vehicle that clears for up to two others, perhaps beside an aircraft; before it begins.
inline Underway any_clearing(int side, int most_retries, Left left = Left::nothing) {
    const PlainMap plain = *random_map(side, side);
    Underway drawn{Map(plain.grid()), any_mission(plain, 3, most_retries)};
    drawn.mission.agents.front().own_breaches = *number(1, 3);
    for (Agent& agent : drawn.mission.agents) {
        if (agent.kind == AgentKind::air) agent.breaches = *rc::gen::element(any_number, any_number, 1);
    }
    leave(left, drawn.mission);
    limit_some(drawn.map, drawn.mission);
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("two stand too near");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// From one hospital to several places, some of which may not be reached in time; before it begins.
inline Underway any_places(int side, int most_retries) {
    const PlainMap plain = *random_map(side, side);
    Underway drawn{Map(plain.grid()), any_mission(plain, 5, most_retries)};
    drawn.mission.rules.collisions = false;
    drawn.mission.rules.unreached = *rc::gen::element(8.0, 20.0, 60.0);
    leave(Left::perhaps_rubble, drawn.mission);
    limit_some(drawn.map, drawn.mission);
    for (Agent& agent : drawn.mission.agents) {
        if (agent.kind == AgentKind::air) continue;
        agent.start = drawn.mission.agents.front().start;
        agent.weight = *rc::gen::element(0.0, 1.0, 1.0, 2.5, 40.0);
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// Some time after it began; nothing is reported but that.
inline Underway any_underway(int side, bool zoned = false, bool batteries = false) {
    Underway drawn = any_planned(side, 2, 1, zoned, batteries, Left::perhaps_rubble);
    double last = 0;
    for (const Itinerary& agent : drawn.plan.agents) last = std::max(last, agent.path.back().t);
    drawn.state.sequence = 1;
    drawn.state.now = last * *number(0, 100) / 100;
    return drawn;
}

// The same with zones, most of which hold for a time only.
inline Underway any_windowed_underway(int side) {
    Underway drawn = any_underway(side);
    drawn.mission.rules.zones = some_zones(side);
    for (Zone& zone : drawn.mission.rules.zones) {
        zone.from = *rc::gen::element(0.0, 1.0, 4.0, 9.0);
        zone.until = *rc::gen::element(zone.from + 1, zone.from + 5, zone.from + 20, Zone().until);
    }
    try {
        validate(drawn.map, drawn.mission);
    } catch (const InputError&) {
        RC_DISCARD("somebody starts or ends in a zone");
    }
    drawn.plan = Planner().plan(drawn.map, drawn.mission);
    RC_PRE(drawn.plan.status == PlanStatus::solved);
    return drawn;
}

// Agents that are late, lost or have stopped, cells that are blocked.
inline void report_any_news(Underway& mission) {
    State& state = mission.state;
    for (const Itinerary& agent : mission.plan.agents) {
        if (mostly()) continue;
        AgentState& said = state.agents.emplace_back();
        said.id = agent.id;
        // Late: where it was a while ago.
        const double late = *rc::gen::element(0.0, 0.5, 3.0);
        const double then = std::max(state.now - late, agent.path.front().t);
        std::size_t next = 0;
        while (next < agent.path.size() && agent.path[next].t <= then) ++next;
        said.passed = next - 1;
        const Waypoint& a = agent.path[next - 1];
        said.at = Point(a.x, a.y);
        if (next < agent.path.size()) {
            const Waypoint& b = agent.path[next];
            const double share = (then - a.t) / (b.t - a.t);
            said.at = Point(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
        }
        if (agent.kind == AgentKind::air && *number(0, 3) == 0) said.doing = Doing::lost;
        if (agent.kind == AgentKind::ground && *number(0, 7) == 0) said.doing = Doing::stopped;
        if (agent.kind == AgentKind::ground || said.doing == Doing::lost) continue;
        if (*number(0, 3) == 0) said.doing = Doing::waiting;
        // Somewhere else.
        if (then < agent.path.back().t && *number(0, 7) == 0)
            said.at = Point(*number(0, mission.map.width() - 1), *number(0, mission.map.height() - 1));
    }
    if (mostly()) {
        const Cell cell{*number(0, mission.map.width() - 1), *number(0, mission.map.height() - 1)};
        state.found.push_back({{cell}, true, *rc::gen::arbitrary<bool>()});
    }
}

// What is wrong with a revision, a line each.
inline std::string revision_faults(const Underway& old, const Revision& next) {
    std::string faults = plan_faults(next.map, next.mission, next.plan);
    for (const Violation& violation : check_continuity(old.mission, old.plan, old.state, next.mission, next.plan))
        faults += line_of(violation) + "\n";
    return faults;
}

// Revises a mission again and again as news comes: whatever is planned must be valid.
inline void expect_valid_after_any_news(Underway old) {
    Planner planner;
    for (int round = 1; round <= 3; ++round) {
        old.state.sequence = std::uint64_t(round);
        report_any_news(old);
        const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, *rc::gen::element(0.0, 1.0));
        RC_CLASSIFY(next.status == RevisionStatus::revised);
        RC_CLASSIFY(next.status == RevisionStatus::kept);
        RC_CLASSIFY(next.status == RevisionStatus::broken);
        RC_CLASSIFY(next.status == RevisionStatus::no_plan);
        RC_ASSERT(revision_faults(old, next) == "");
        if (next.plan.status != PlanStatus::solved) return;
        const double since = old.state.now;
        old = {next.map, next.mission, next.plan, {}};
        old.state.now = since + *number(0, 6);
    }
}

}  // namespace waybreaker

// Why ground agents wait: judged by the checker, which knows nothing of reasons.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Agent flyer(const std::string& id, Cell start, double speed = 1) {
    Agent agent;
    agent.id = id;
    agent.kind = AgentKind::air;
    agent.start = agent.goal = start;
    agent.speed = speed;
    return agent;
}

// One of so many, that no two are likely to be the same: then no two reasons end at the same time.
double thousandths(int least, int most) {
    return *number(least, most) / 1000.0;
}

// Vehicles close to each other, of which many have to wait; and mostly aircraft.
Mission crowd(const PlainMap& plain, const Map& map) {
    Mission mission;
    mission.rules.objective = *rc::gen::element(Objective::flowtime, Objective::makespan);
    mission.rules.at_goal = *rc::gen::element(AtGoal::stay, AtGoal::leave);
    mission.rules.separation = *rc::gen::element(0.0, 0.0, 0.3);
    mission.rules.timing = *rc::gen::element(Timing::enforce, Timing::enforce, Timing::enforce, Timing::ignore);
    mission.rules.removals = *number(0, 3);
    mission.rules.breach_time.per_obstacle = thousandths(0, 4000);
    const int vehicles = *number(2, 6);
    for (int tries = 0; tries < 40 && int(mission.agents.size()) < vehicles; ++tries) {
        Agent agent = vehicle(std::to_string(tries), any_free_cell(plain), any_free_cell(plain),
                              *rc::gen::element(0.25, 0.5, 0.5, 1.1));
        agent.speed = thousandths(500, 3000);
        agent.ready_at = *number(0, 1) * thousandths(1, 3000);
        mission.agents.push_back(agent);
        try {
            validate(map, mission);
        } catch (const InputError&) {
            mission.agents.pop_back();
        }
    }
    const int aircraft = *number(0, 2);
    for (int i = 0; i < aircraft; ++i) {
        mission.agents.push_back(flyer("bird" + std::to_string(i), any_cell(plain), thousandths(500, 3000)));
    }
    RC_PRE(mission.is_team() && mission.agents.front().kind == AgentKind::ground);
    return mission;
}

// A time for which an agent stands, until it goes on.
struct Stand {
    std::size_t first = 0;  // of its path
    std::size_t last = 0;
};

std::vector<Stand> stands(const std::vector<Waypoint>& path) {
    const auto one_place = [&](std::size_t i) { return path[i].x == path[i + 1].x && path[i].y == path[i + 1].y; };
    std::vector<Stand> found;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!one_place(i)) continue;
        const std::size_t first = i;
        while (i + 1 < path.size() && one_place(i)) ++i;
        if (i + 1 < path.size()) found.push_back({first, i});
    }
    return found;
}

// The path of one that goes on at that time, and waits the longer where it waits next.
std::vector<Waypoint> hurried(const std::vector<Waypoint>& path, const Stand& stand, double departure) {
    std::vector<Waypoint> other(path.begin(), path.begin() + std::ptrdiff_t(stand.first) + 1);
    const Waypoint& at = path[stand.last];
    other.push_back({at.x, at.y, departure});
    std::size_t i = stand.last + 1;
    for (; i < path.size(); ++i) {
        if (path[i].x == other.back().x && path[i].y == other.back().y) break;
        other.push_back({path[i].x, path[i].y, path[i].t - at.t + departure});
    }
    other.insert(other.end(), path.begin() + std::ptrdiff_t(i), path.end());
    return other;
}

// What its agent must not do: the rules that a departure can break.
std::string illegal(const Map& map, const Mission& mission, const Plan& plan, const std::string& agent) {
    std::string faults;
    constexpr double tolerance = 2e-7;  // departures are rounded so that discs overlap by less
    for (const Violation& violation : check(map, mission, plan, tolerance)) {
        RC_ASSERT(violation.rule != Rule::agents);  // it would look at nothing else
        const bool moves = violation.rule == Rule::collision || violation.rule == Rule::separation ||
                           (violation.rule == Rule::start && violation.agent == agent);
        if (moves) faults += line_of(violation) + "\n";
    }
    return faults;
}

// Leaves out all that a wait is not for: other agents, other obstacles, and when the agent is ready.
void leave_out_others(const Wait& wait, const std::string& waiting, Mission& mission, Plan& plan) {
    for (Breach& breach : plan.breaches) {
        if (wait.reason != WaitReason::opening || breach.obstacle != wait.obstacle) breach.cleared_at = 0;
    }
    for (std::size_t i = plan.agents.size(); i-- > 0;) {
        const Itinerary& agent = plan.agents[i];
        if (agent.id == waiting) mission.agents[i].ready_at = 0;
        const bool stays = agent.kind == AgentKind::air || agent.id == waiting ||
                           (wait.reason == WaitReason::agent && agent.id == wait.agent);
        if (stays) continue;
        const auto at = std::ptrdiff_t(i);
        plan.agents.erase(plan.agents.begin() + at);
        plan.before.routes.erase(plan.before.routes.begin() + at);
        plan.after.routes.erase(plan.after.routes.begin() + at);
        mission.agents.erase(mission.agents.begin() + at);
    }
}

// Holds one wait of an agent against the checker.
void judge_wait(const Map& map, const Mission& mission, const Plan& plan, std::size_t agent, const Stand& stand) {
    constexpr double long_enough = 1e-2;
    const Itinerary& itinerary = plan.agents[agent];
    const double begin = itinerary.path[stand.first].t;
    const double end = itinerary.path[stand.last].t;
    double time = begin;
    for (const Wait& wait : itinerary.waits) {
        if (wait.until <= begin || wait.from >= end) continue;
        RC_ASSERT(wait.from == time);
        time = wait.until;
        if (wait.until - wait.from < long_enough) continue;
        Plan earlier = plan;
        earlier.agents[agent].path = hurried(itinerary.path, stand, (wait.from + wait.until) / 2);
        const std::string faults = illegal(map, mission, earlier, itinerary.id);
        RC_ASSERT(faults.empty() == (wait.reason == WaitReason::nothing));
        if (wait.reason == WaitReason::nothing) continue;
        if (wait.reason == WaitReason::readiness) {
            RC_ASSERT(wait.until <= mission.agents[agent].ready_at + 1e-6);  // what is less is rounding
            continue;
        }
        // Alone it is in the way as well, from the beginning of the wait to its end.
        for (const double share : {0.01, 0.5, 0.99}) {
            Plan alone = plan;
            alone.agents[agent].path = hurried(itinerary.path, stand, std::lerp(wait.from, wait.until, share));
            Mission of_both = mission;
            leave_out_others(wait, itinerary.id, of_both, alone);
            RC_ASSERT(illegal(map, of_both, alone, itinerary.id) != "");
        }
    }
    RC_ASSERT(time == end || end - begin < 1e-5);
}

// If somebody moves at any time after all may leave and all is open.
double latest_without_standstill(const Mission& mission, const Plan& plan) {
    double latest = 0;
    for (const Agent& agent : mission.agents) latest = std::max(latest, agent.ready_at);
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind == AgentKind::air) latest = std::max(latest, agent.path.back().t);
    }
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind == AgentKind::air) continue;
        for (std::size_t i = 1; i < agent.path.size(); ++i) {
            const Waypoint& a = agent.path[i - 1];
            const Waypoint& b = agent.path[i];
            if (a.x != b.x || a.y != b.y) latest += b.t - a.t;
        }
    }
    return latest;
}

RC_GTEST_PROP(Waits, HaveTheirReasons, ()) {
    const PlainMap plain = *random_map(12, 12);
    const Map map(plain.grid());
    const Mission mission = crowd(plain, map);
    const Plan plan = Planner().plan(map, mission, {.explain = true});
    RC_PRE(plan.status == PlanStatus::solved);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    RC_ASSERT(*plan.after.makespan <= latest_without_standstill(mission, plan) * (1 + 1e-9));
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::air) continue;
        for (const Stand& stand : stands(plan.agents[i].path)) judge_wait(map, mission, plan, i, stand);
    }
}

Map gate() {
    return map_from_ascii(R"(
        ...a...
        ####...
        ...b...)");
}

TEST(Waits, NameTheObstacleAndItsAircraft) {
    Mission mission;
    mission.agents = {vehicle("truck", {0, 0}, {6, 0}), vehicle("rover", {6, 2}, {5, 2}), flyer("heli", {4, 0})};
    mission.rules.breach_time.per_obstacle = 10;
    mission.rules.protect = {{2}, {3}};
    const Map map = gate();
    const Plan plan = Planner().plan(map, mission, {.explain = true});
    ASSERT_EQ(plan.status, PlanStatus::solved);
    ASSERT_EQ(plan.breaches.size(), 1U);
    ASSERT_EQ(plan.agents[0].waits.size(), 1U);
    const Wait& wait = plan.agents[0].waits[0];
    EXPECT_EQ(wait.reason, WaitReason::opening);
    EXPECT_EQ(wait.agent, "heli");
    EXPECT_EQ(wait.obstacle, plan.breaches[0].obstacle);
    EXPECT_EQ(wait.at, Point(0, 0));
    EXPECT_DOUBLE_EQ(wait.from, 0);
    EXPECT_DOUBLE_EQ(wait.until, 8);  // it drives two cells to where it touches the obstacle, which is open at 10
    // Without the obstacle's removal there is no way.
    EXPECT_EQ(plan.breaches[0].saves, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(plan.agents[0].gain.has_value());
    EXPECT_DOUBLE_EQ(plan.agents[1].gain.value(), 0);
    EXPECT_TRUE(plan.agents[1].waits.empty());
}

TEST(Waits, OfOneVehicleAndOneAircraftToo) {
    Mission mission = ground_and_air({0, 0}, {6, 0});
    mission.rules.breach_time.per_obstacle = 10;
    const Plan plan = Planner().plan(gate(), mission);
    ASSERT_EQ(plan.status, PlanStatus::solved);
    ASSERT_EQ(plan.agents[0].waits.size(), 1U);
    EXPECT_EQ(plan.agents[0].waits[0].agent, "air");
    EXPECT_EQ(Planner().front(gate(), mission).back().agents[0].waits.size(), 1U);
}

TEST(Explain, SaysWhatTheTeamIsWithoutEachRemoval) {
    // Each of two vehicles has a wall of its own in its way, and can drive around it.
    const Map map = map_from_ascii(R"(
        ...a.......
        ...a.......
        ...........
        ...........
        ...........
        .......b...
        .......b...)");
    Mission mission;
    mission.rules.objective = Objective::ground_makespan;
    mission.agents = {vehicle("a", {0, 0}, {10, 0}), vehicle("b", {0, 6}, {10, 6}), flyer("x", {3, 2}, 5)};
    mission.rules.removals = 2;
    const Plan plan = Planner().plan(map, mission, {.explain = true});
    ASSERT_EQ(plan.status, PlanStatus::solved);
    ASSERT_EQ(plan.breaches.size(), 2U);
    for (const Breach& breach : plan.breaches) {
        Mission without = mission;
        without.rules.protect = {breach.obstacle};
        const Plan other = Planner().plan(map, without);
        ASSERT_TRUE(breach.saves.has_value());
        EXPECT_DOUBLE_EQ(*breach.saves, *other.after.ground_makespan - *plan.after.ground_makespan);
        EXPECT_GT(*breach.saves, 0);
    }
    EXPECT_TRUE(plan.next.empty());
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_NEAR(plan.agents[i].gain.value(), *plan.before.routes[i].length - 10, 1e-9);
    }
    mission.rules.removals = 1;
    const Plan one = Planner().plan(map, mission, {.explain = true});
    ASSERT_EQ(one.next.size(), 1U);
    EXPECT_NEAR(one.next[0].saves, *one.after.ground_makespan - *plan.after.ground_makespan, 1e-9);
}

}  // namespace
}  // namespace waybreaker

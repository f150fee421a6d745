#include "waybreaker/check.hpp"

#include <array>
#include <limits>
#include <sstream>

#include "check/judge.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace checker {
namespace {

void validate(const Terms& terms) {
    if (!(terms.body.radius >= 0 && terms.body.radius <= 32))
        throw InputError("the radius must be between 0 and 32 cells");
    if (!(terms.rules.separation >= 0 && terms.rules.separation <= 32))
        throw InputError("the separation must be between 0 and 32 cells");
    if (!(terms.tolerance >= 0 && terms.tolerance < 1))
        throw InputError("the tolerance must be at least 0 and below 1");
    const auto is_time = [](double time) { return time >= 0 && std::isfinite(time); };
    const BreachTime& time = terms.rules.breach_time;
    if (!is_time(time.per_obstacle) || !is_time(time.per_cell)) {
        throw InputError("the breach time must be a number, at least 0");
    }
    if (!is_time(terms.rules.rubble)) throw InputError("the time that rubble takes must be a number, at least 0");
}

// Whom the itinerary is of: an agent of the mission as the mission has it.
Violations judge_agents(const Mission& mission, const Plan& plan) {
    Violations found;
    for (const Itinerary& planned : plan.agents) {
        const auto is_it = [&](const Agent& agent) {
            return planned.id == agent.id && planned.kind == agent.kind && planned.speed == agent.speed &&
                   planned.start == agent.start && planned.goal == agent.goal;
        };
        if (std::any_of(mission.agents.begin(), mission.agents.end(), is_it)) continue;
        found.push_back({Rule::agents, "the mission has no such agent as the plan's " + planned.id, planned.id});
    }
    return found;
}

// The only agent of that kind; null, and a violation, if there is none or more than one.
const Itinerary* only_agent(const Plan& plan, AgentKind kind, Violations& violations) {
    const auto is_kind = [kind](const Itinerary& agent) { return agent.kind == kind; };
    const auto count = std::count_if(plan.agents.begin(), plan.agents.end(), is_kind);
    if (count == 1) return &*std::find_if(plan.agents.begin(), plan.agents.end(), is_kind);
    const std::string word = kind == AgentKind::ground ? "ground" : "air";
    violations.push_back({Rule::agents, "there are " + std::to_string(count) + " " + word + " agents instead of one"});
    return nullptr;
}

void validate(const Mission& mission, const Terms& terms) {
    if (!(mission.rules.budget >= 0)) throw InputError("the budget cannot be " + text(mission.rules.budget));
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) continue;
        validate({terms.rules, agent.body, terms.tolerance});
        if (!(agent.ready_at >= 0 && agent.ready_at <= most_breach_time)) {
            throw InputError("the " + agent.id + " agent cannot be ready at " + text(agent.ready_at));
        }
    }
}

// Of one ground and one air agent.
Violations judge_capacity(const Mission& mission, const Plan& plan) {
    const auto breaches_too_much = [&](const Agent& agent) {
        return agent.kind == AgentKind::air && plan.breaches.size() > std::size_t(std::max(agent.breaches, 0));
    };
    const auto found = std::find_if(mission.agents.begin(), mission.agents.end(), breaches_too_much);
    if (found == mission.agents.end()) return {};
    return {{Rule::capacity, beyond_capacity(*found), found->id}};
}

// Of one ground and one air agent; one by default where the mission has none.
Agent asked(const Mission& mission, AgentKind kind) {
    const auto is_kind = [kind](const Agent& agent) { return agent.kind == kind; };
    const auto known = std::find_if(mission.agents.begin(), mission.agents.end(), is_kind);
    return known == mission.agents.end() ? Agent{} : *known;
}

Violations judge_explained(const Plan& plan, const Itinerary& agent, double ready_at, const Terms& terms) {
    Violations found = judge_waits(plan, agent, ready_at, terms);
    append(found, judge_gain(agent, ready_at, plan.before.ground().length, terms));
    return found;
}

Violations judge(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    Violations all = judge_numbers(plan);
    if (!all.empty()) return all;
    all = judge_zones(map, mission, plan, terms);
    append(all, judge_ranges(map, mission, plan, terms));
    if (mission.is_team()) {
        const Violations others = judge_agents(mission, plan);
        append(all, others.empty() ? judge_team(map, mission, plan, terms) : others);
        return all;
    }
    append(all, judge_removals(map, plan, terms));
    append(all, judge_capacity(mission, plan));
    append(all, judge_agents(mission, plan));
    for (const Outcome* outcome : {&plan.before, &plan.after}) {
        for (const AgentKind kind : {AgentKind::ground, AgentKind::air}) {
            const auto is_kind = [kind](const Route& route) { return route.kind == kind; };
            if (std::any_of(outcome->routes.begin(), outcome->routes.end(), is_kind)) continue;
            all.push_back({Rule::agents, "an agent's route before or after removal is missing"});
            return all;
        }
    }
    const Agent driver = asked(mission, AgentKind::ground);
    const Agent flyer = asked(mission, AgentKind::air);
    if (plan.agents.empty()) {
        append(all, judge_figures(plan, nullptr, nullptr, driver, flyer, terms));
        return all;
    }
    const Itinerary* ground = only_agent(plan, AgentKind::ground, all);
    const Itinerary* air = only_agent(plan, AgentKind::air, all);
    if (!ground || !air) return all;
    const Violations ground_times = judge_timetable(*ground, &driver, {}, terms);
    const Violations air_times = judge_timetable(*air, &flyer, {}, terms);
    append(all, ground_times);
    append(all, air_times);
    // Where somebody is at a time can be asked of a timetable that goes forward in time.
    const auto broken = [](const Violations& violations) {
        return std::any_of(violations.begin(), violations.end(),
                           [](const Violation& v) { return v.rule == Rule::agents || v.rule == Rule::time; });
    };
    if (!broken(ground_times)) {
        Drive drive = judge_ground(map, plan, *ground, driver, terms);
        append(all, std::move(drive.found));
        if (drive.followed) {
            append(all, judge_entries(map, plan, drive.entries, ground->id, terms));
            append(all, judge_rubble(map, plan, *ground, driver, drive.entries, terms));
        }
    }
    if (!broken(air_times)) append(all, judge_breaches(map, plan.breaches, *air, flyer, terms));
    if (!broken(ground_times) && !broken(air_times)) {
        append(all, judge_ready(*ground, driver, terms));
        if (flyer.ready_at > 0) append(all, judge_ready(*air, flyer, terms));
        append(all, judge_figures(plan, ground, air, driver, flyer, terms));
        append(all, judge_explained(plan, *ground, driver.ready_at, terms));
        append(all, judge_explained(plan, *air, flyer.ready_at, terms));
    }
    return all;
}

}  // namespace

std::string text(double value) {
    std::ostringstream out;
    out.precision(9);
    out << value;
    return out.str();
}
std::string text(Point p) {
    return text(p.x) + "," + text(p.y);
}
std::string text(ObstacleId obstacle) {
    return obstacle ? "obstacle " + std::to_string(obstacle.value) : "the edge of the map";
}

}  // namespace checker

std::vector<Violation> check(const Map& map, const Mission& mission, const Plan& plan, double tolerance) {
    const checker::Terms terms{mission.rules, mission.ground_body(), tolerance};
    checker::validate(terms);
    checker::validate(mission, terms);
    std::vector<Violation> violations = checker::judge(map, mission, plan, terms);
    if (violations.empty()) violations = checker::judge_orders(map, mission, plan, terms);
    const auto time = [](const Violation& v) { return v.time.value_or(std::numeric_limits<double>::infinity()); };
    std::stable_sort(violations.begin(), violations.end(),
                     [&](const Violation& a, const Violation& b) { return time(a) < time(b); });
    return violations;
}

}  // namespace waybreaker

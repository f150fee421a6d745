#include "waybreaker/check.hpp"

#include <array>
#include <sstream>

#include "check/judge.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace checker {
namespace {

void validate(const CheckRules& rules) {
    const double radius = rules.motion.radius;
    if (!(radius >= 0 && radius <= 32)) throw InputError("the radius must be between 0 and 32 cells");
    if (!(rules.tolerance >= 0 && rules.tolerance < 1))
        throw InputError("the tolerance must be at least 0 and below 1");
    const auto is_time = [](double time) { return time >= 0 && std::isfinite(time); };
    if (!is_time(rules.breach_time.per_obstacle) || !is_time(rules.breach_time.per_cell)) {
        throw InputError("the breach time must be a number, at least 0");
    }
}

// The only agent of that kind; null, and a violation, if there is none or more than one.
const AgentPlan* only_agent(const Plan& plan, AgentKind kind, Violations& violations) {
    const auto is_kind = [kind](const AgentPlan& agent) { return agent.kind == kind; };
    const auto count = std::count_if(plan.agents.begin(), plan.agents.end(), is_kind);
    if (count == 1) return &*std::find_if(plan.agents.begin(), plan.agents.end(), is_kind);
    const std::string word = kind == AgentKind::ground ? "ground" : "air";
    violations.push_back({Rule::agents, "there are " + std::to_string(count) + " " + word + " agents instead of one"});
    return nullptr;
}

Violations judge(const Map& map, const Plan& plan, const CheckRules& rules) {
    Violations all = judge_removals(map, plan, rules);
    if (plan.agents.empty()) {
        append(all, judge_figures(plan, nullptr, nullptr, rules));
        return all;
    }
    const AgentPlan* ground = only_agent(plan, AgentKind::ground, all);
    const AgentPlan* air = only_agent(plan, AgentKind::air, all);
    if (!ground || !air) return all;
    const Violations ground_times = judge_timetable(*ground, rules);
    const Violations air_times = judge_timetable(*air, rules);
    append(all, ground_times);
    append(all, air_times);
    // Where somebody is at a time can be asked of a timetable that goes forward in time.
    const auto broken = [](const Violations& violations) {
        return std::any_of(violations.begin(), violations.end(),
                           [](const Violation& v) { return v.rule == Rule::agents || v.rule == Rule::time; });
    };
    if (!broken(ground_times)) append(all, judge_ground(map, plan, *ground, rules));
    if (!broken(air_times)) append(all, judge_breaches(map, plan, *air, rules));
    if (!broken(ground_times) && !broken(air_times)) append(all, judge_figures(plan, ground, air, rules));
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

std::string_view name(Rule rule) {
    constexpr std::array<std::string_view, 26> names{
        "map",      "status",          "agents",   "start",      "goal",     "time",   "speed",
        "vertex",   "collision",       "obstacle", "repetition", "removals", "budget", "cells",
        "boundary", "breach",          "order",    "next",       "entered",  "length", "makespan",
        "flowtime", "ground_makespan", "before",   "bound",      "gap"};
    return names.at(std::size_t(rule));
}

std::vector<Violation> check(const Map& map, const Plan& plan, const CheckRules& rules) {
    checker::validate(rules);
    std::vector<Violation> violations = checker::judge(map, plan, rules);
    const auto time = [](const Violation& v) { return v.time.value_or(std::numeric_limits<double>::infinity()); };
    std::stable_sort(violations.begin(), violations.end(),
                     [&](const Violation& a, const Violation& b) { return time(a) < time(b); });
    return violations;
}

}  // namespace waybreaker

// What is removed, and how: which obstacles, from where, when.
#include <set>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

bool on_map(const Map& map, Cell c) {
    return c.x >= 0 && c.y >= 0 && c.x < map.width() && c.y < map.height();
}

// A cell of the map outside the obstacle, with one of its cells among its eight neighbours.
bool on_boundary(const Map& map, Cell at, ObstacleId obstacle) {
    if (!on_map(map, at) || map.obstacle_at(at) == obstacle) return false;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            // Neighbours of a cell of the map: no overflow.
            const Cell neighbour{at.x + dx, at.y + dy};
            if (on_map(map, neighbour) && map.obstacle_at(neighbour) == obstacle) return true;
        }
    }
    return false;
}

using Ids = std::set<ObstacleId>;

// Why an obstacle may not be removed, if it may not.
std::optional<std::string> objection(const Map& map, ObstacleId obstacle, const Ids& protect) {
    if (!names_obstacle(map, obstacle)) return "there is no obstacle " + std::to_string(obstacle.value);
    if (!map.obstacle(obstacle).destructible) return text(obstacle) + " cannot be destroyed";
    if (protect.contains(obstacle)) return text(obstacle) + " is protected";
    return std::nullopt;
}

Violation violation(Rule rule, const std::string& message, const Removal& removal) {
    return {rule, message, "", removal.obstacle, removal.at, removal.cleared_at};
}

// That it is what the plan says it is. Precondition: the map has such an obstacle.
Violations judge_description(const Map& map, const Removal& removal) {
    Violations found;
    const Obstacle& obstacle = map.obstacle(removal.obstacle);
    const std::string who = text(removal.obstacle);
    const auto differs = [&](const std::string& what, std::int64_t truth, std::int64_t stated) {
        if (truth == stated) return;
        const std::string message = who + what + std::to_string(truth) + ", not " + std::to_string(stated);
        found.push_back(violation(Rule::cells, message, removal));
    };
    differs("'s number of cells is ", obstacle.cells, removal.cells);
    differs("'s id in its source is ", obstacle.source_id, removal.source_id);
    if (!on_boundary(map, removal.at, removal.obstacle)) {
        const std::string message = who + " is breached from " + text(removal.at) + ", which is not on its boundary";
        found.push_back(violation(Rule::boundary, message, removal));
    }
    return found;
}

// That it is not too much: told of the first removal that is.
Violations judge_amount(const Plan& plan, const CheckRules& rules) {
    Violations found;
    const auto allowed = std::size_t(std::max(rules.removals, 0));
    if (plan.removed.size() > allowed) {
        const std::string message =
            std::to_string(plan.removed.size()) + " obstacles are removed, " + std::to_string(allowed) + " are allowed";
        found.push_back(violation(Rule::removals, message, plan.removed[allowed]));
    }
    double weight = 0;
    for (std::size_t i = 0; i < plan.removed.size(); ++i) {
        weight += i < rules.weights.size() ? rules.weights[i] : 1;
        if (weight <= rules.budget + slack(rules, rules.budget)) continue;
        const std::string message =
            "removals up to here weigh " + text(weight) + ", over the budget of " + text(rules.budget);
        found.push_back(violation(Rule::budget, message, plan.removed[i]));
        break;
    }
    return found;
}

// How far from where it should be an agent may be at a time.
double room(const AgentPlan& agent, const CheckRules& rules, double time) {
    return (1 + agent.speed) * slack(rules, time);
}

bool is_near(const Waypoint& point, Cell at, double room) {
    return std::hypot(point.x - at.x, point.y - at.y) <= room;
}

// The first point of the path at or after a time.
auto first_point_from(const AgentPlan& agent, double time) {
    return std::partition_point(agent.path.begin(), agent.path.end(),
                                [time](const Waypoint& point) { return point.t < time; });
}

// Whether the agent is at a cell at that time, give or take the tolerance.
bool is_there(const AgentPlan& agent, Cell at, double time, const CheckRules& rules) {
    const double hair = slack(rules, time);
    const double allowed = room(agent, rules, time);
    for (auto b = first_point_from(agent, time - hair); b != agent.path.end(); ++b) {
        const auto a = b == agent.path.begin() ? b : b - 1;
        if (a->t > time + hair) break;
        const double share = b->t > a->t ? std::clamp((time - a->t) / (b->t - a->t), 0.0, 1.0) : 1;
        if (is_near({a->x + share * (b->x - a->x), a->y + share * (b->y - a->y), time}, at, allowed)) return true;
    }
    return false;
}

bool stays_there(const AgentPlan& agent, Cell at, double from, double to, const CheckRules& rules) {
    if (!is_there(agent, at, from, rules) || !is_there(agent, at, to, rules)) return false;
    const double hair = slack(rules, to);
    for (auto point = first_point_from(agent, from + hair); point != agent.path.end(); ++point) {
        if (point->t > to - hair) break;
        if (!is_near(*point, at, room(agent, rules, to))) return false;
    }
    return true;
}

}  // namespace

Violations judge_removals(const Map& map, const Plan& plan, const CheckRules& rules) {
    Violations found;
    const Ids protect(rules.protect.begin(), rules.protect.end());
    Ids seen;
    for (const Removal& removal : plan.removed) {
        const ObstacleId obstacle = removal.obstacle;
        const bool is_new = seen.insert(obstacle).second;
        if (!is_new) found.push_back(violation(Rule::repetition, text(obstacle) + " is removed twice", removal));
        const auto reason = objection(map, obstacle, protect);
        if (reason) found.push_back(violation(Rule::obstacle, *reason, removal));
        if (names_obstacle(map, obstacle)) append(found, judge_description(map, removal));
    }
    append(found, judge_amount(plan, rules));
    for (const ObstacleId id : rules.force) {
        if (seen.contains(id) || plan.agents.empty()) continue;
        found.push_back({Rule::removals, text(id) + " is not removed, though it must be", "", id});
    }
    for (const NextRemoval& next : plan.next) {
        auto reason = objection(map, next.obstacle, protect);
        if (!reason && seen.contains(next.obstacle)) reason = text(next.obstacle) + " is removed already";
        if (reason) found.push_back({Rule::next, "as the next removal: " + *reason, "", next.obstacle});
    }
    return found;
}

Violations judge_breaches(const Map& map, const Plan& plan, const AgentPlan& air, const CheckRules& rules) {
    Violations found;
    double free_from = 0;  // the breach before is over
    for (const Removal& removal : plan.removed) {
        if (!names_obstacle(map, removal.obstacle)) continue;
        if (found.size() > enough_violations) break;
        const double until = removal.cleared_at;
        const double from = until - rules.breach_time.of(map.obstacle(removal.obstacle));
        const auto report = [&](Rule rule, const std::string& what) {
            found.push_back({rule, what, air.id, removal.obstacle, removal.at, until});
        };
        if (!stays_there(air, removal.at, from, until, rules)) {
            const std::string when = from < until ? "from " + text(from) + " to " + text(until) : "at " + text(until);
            report(Rule::breach, "the " + air.id + " agent is not at " + text(removal.at) + " " + when + " to breach " +
                                     text(removal.obstacle));
        }
        if (from < free_from - slack(rules, free_from)) {
            report(Rule::order, text(removal.obstacle) +
                                    " is breached before the one listed before it is cleared, at " + text(free_from));
        }
        free_from = until;
    }
    return found;
}

}  // namespace waybreaker::checker

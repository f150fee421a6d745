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

// What is wrong with one removal, whatever the others are.
Violations judge_removal(const Map& map, const Removal& removal, bool is_protected) {
    Violations found;
    const auto report = [&](Rule rule, const std::string& what) {
        found.push_back(
            {rule, text(removal.obstacle) + " " + what, "", removal.obstacle, removal.at, removal.cleared_at});
    };
    if (!names_obstacle(map, removal)) {
        found.push_back({Rule::obstacle, "there is no obstacle " + std::to_string(removal.obstacle.value), "",
                         removal.obstacle, removal.at, removal.cleared_at});
        return found;
    }
    const Obstacle& obstacle = map.obstacle(removal.obstacle);
    if (!obstacle.destructible) report(Rule::obstacle, "cannot be destroyed");
    if (is_protected) report(Rule::obstacle, "is protected");
    if (removal.cells != obstacle.cells) {
        report(Rule::cells, "has " + std::to_string(obstacle.cells) + " cells, not " + std::to_string(removal.cells));
    }
    if (removal.source_id != obstacle.source_id) {
        report(Rule::cells,
               "is " + std::to_string(obstacle.source_id) + " in its source, not " + std::to_string(removal.source_id));
    }
    if (!on_boundary(map, removal.at, removal.obstacle)) {
        report(Rule::boundary, "is breached from " + text(removal.at) + ", which is not on its boundary");
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
    const std::set<ObstacleId> protect(rules.protect.begin(), rules.protect.end());
    std::set<ObstacleId> seen;
    double weight = 0;
    for (std::size_t i = 0; i < plan.removed.size(); ++i) {
        const Removal& removal = plan.removed[i];
        append(found, judge_removal(map, removal, protect.contains(removal.obstacle)));
        const auto report = [&](Rule rule, const std::string& what) {
            found.push_back({rule, what, "", removal.obstacle, removal.at, removal.cleared_at});
        };
        if (!seen.insert(removal.obstacle).second) {
            report(Rule::repetition, text(removal.obstacle) + " is removed more than once");
        }
        if (i >= std::size_t(std::max(rules.removals, 0))) {
            report(Rule::removals, "removal " + std::to_string(i + 1) + " is one too many, " +
                                       std::to_string(rules.removals) + " are allowed");
        }
        const double before = weight;
        weight += i < rules.weights.size() ? rules.weights[i] : 1;
        const double limit = rules.budget + slack(rules, rules.budget);
        if (weight > limit && before <= limit) {
            report(Rule::budget,
                   "removals up to here weigh " + text(weight) + ", over the budget of " + text(rules.budget));
        }
    }
    return found;
}

Violations judge_breaches(const Map& map, const Plan& plan, const AgentPlan& air, const CheckRules& rules) {
    Violations found;
    double free_from = 0;  // the breach before is over
    for (const Removal& removal : plan.removed) {
        if (!names_obstacle(map, removal)) continue;
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

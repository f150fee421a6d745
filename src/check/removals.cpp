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
std::optional<std::string> objection(const Map& map, ObstacleId obstacle, const Ids& protect, const Rules& rules) {
    if (!names_obstacle(map, obstacle)) return "there is no obstacle " + std::to_string(obstacle.value);
    if (!map.obstacle(obstacle).destructible) return text(obstacle) + " cannot be destroyed";
    if (protect.contains(obstacle)) return text(obstacle) + " is protected";
    const auto is_it = [obstacle](const TimedOpening& opening) { return opening.obstacle == obstacle; };
    if (std::any_of(rules.opened.begin(), rules.opened.end(), is_it)) return text(obstacle) + " opens by itself";
    return std::nullopt;
}

Violation violation(Rule rule, const std::string& message, const Breach& breach) {
    return {rule, message, "", breach.obstacle, breach.at, breach.cleared_at};
}

// Whether a ground agent breaches it.
bool is_from_the_ground(const Plan& plan, const Breach& breach) {
    return std::any_of(plan.agents.begin(), plan.agents.end(), [&](const Itinerary& agent) {
        return agent.kind == AgentKind::ground && agent.id == breach.by;
    });
}

// That it is what the plan says it is. Precondition: the map has such an obstacle.
Violations judge_description(const Map& map, const Plan& plan, const Breach& breach) {
    Violations found;
    const Obstacle& obstacle = map.obstacle(breach.obstacle);
    const std::string who = text(breach.obstacle);
    const auto differs = [&](const std::string& what, std::int64_t truth, std::int64_t stated) {
        if (truth == stated) return;
        const std::string message = who + what + std::to_string(truth) + ", not " + std::to_string(stated);
        found.push_back(violation(Rule::cells, message, breach));
    };
    differs("'s number of cells is ", obstacle.cells, breach.cells);
    differs("'s id in its source is ", obstacle.source_id, breach.source_id);
    if (!is_from_the_ground(plan, breach) && !on_boundary(map, breach.at, breach.obstacle)) {
        const std::string message = who + " is breached from " + text(breach.at) + ", which is not on its boundary";
        found.push_back(violation(Rule::boundary, message, breach));
    }
    return found;
}

// That it is not too much: told of the first removal that is.
Violations judge_amount(const Map& map, const Plan& plan, const Terms& terms) {
    Violations found;
    const auto allowed = std::size_t(std::max(terms.rules.removals, 0));
    if (plan.breaches.size() > allowed) {
        const std::string message = std::to_string(plan.breaches.size()) + " obstacles are removed, " +
                                    std::to_string(allowed) + " are allowed";
        found.push_back(violation(Rule::removals, message, plan.breaches[allowed]));
    }
    double weight = 0;
    for (const Breach& breach : plan.breaches) {
        if (!names_obstacle(map, breach.obstacle)) continue;
        weight += map.obstacle(breach.obstacle).weight;
        if (weight <= terms.rules.budget + slack(terms, terms.rules.budget)) continue;
        const std::string message =
            "removals up to here weigh " + text(weight) + ", over the budget of " + text(terms.rules.budget);
        found.push_back(violation(Rule::budget, message, breach));
        break;
    }
    return found;
}

// Whether the way from one point to another leads past a cell's centre, give or take the tolerance.
bool leads_past(const Waypoint& a, const Waypoint& b, Cell at, const Terms& terms) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    const double share = squared > 0 ? std::clamp(((at.x - a.x) * dx + (at.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
    return std::hypot(a.x + share * dx - at.x, a.y + share * dy - at.y) <= terms.tolerance;
}

// The first point of the path at or after a time.
auto first_point_from(const Itinerary& agent, double time) {
    return std::partition_point(agent.path.begin(), agent.path.end(),
                                [time](const Waypoint& point) { return point.t < time; });
}

// Whether the agent is at a cell at that time, give or take the tolerance: of the time and, for itself, of the place,
// so that speed excuses nothing.
bool is_there(const Itinerary& agent, Cell at, double time, const Terms& terms) {
    const double hair = slack(terms, time);
    const auto place_at = [](const Waypoint& a, const Waypoint& b, double t) {
        const double share = b.t > a.t ? std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0) : 1;
        return Waypoint{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), t};
    };
    for (auto b = first_point_from(agent, time - hair); b != agent.path.end(); ++b) {
        const auto a = b == agent.path.begin() ? b : b - 1;
        if (a->t > time + hair) break;
        const bool moves_at_once = b->t <= a->t;
        const Waypoint first = moves_at_once ? *a : place_at(*a, *b, time - hair);
        if (leads_past(first, place_at(*a, *b, time + hair), at, terms)) return true;
    }
    return false;
}

bool stays_there(const Itinerary& agent, Cell at, double from, double to, const Terms& terms) {
    if (!is_there(agent, at, from, terms) || !is_there(agent, at, to, terms)) return false;
    const double hair = slack(terms, to);
    for (auto point = first_point_from(agent, from + hair); point != agent.path.end(); ++point) {
        if (point->t > to - hair) break;
        if (!leads_past(*point, *point, at, terms)) return false;
    }
    return true;
}

// Where the agent is at a time.
Point place_at(const Itinerary& agent, double time) {
    const auto b = first_point_from(agent, time);
    if (b == agent.path.begin()) return {b->x, b->y};
    if (b == agent.path.end()) return {agent.path.back().x, agent.path.back().y};
    const auto a = b - 1;
    const double share = b->t > a->t ? (time - a->t) / (b->t - a->t) : 1;
    return {a->x + share * (b->x - a->x), a->y + share * (b->y - a->y)};
}

// Whether a ground agent stands in the cell that a breach names, or at its border, as long as that takes.
bool stands_there(const Itinerary& agent, const Breach& breach, double from, const Terms& terms) {
    const double to = breach.cleared_at;
    const Point place = place_at(agent, from);
    const double hair = slack(terms, to);
    const double moved = terms.tolerance + 2 * hair * agent.speed;
    const auto is_there = [&](Point p) { return std::hypot(p.x - place.x, p.y - place.y) <= moved; };
    if (std::abs(place.x - breach.at.x) > 1 || std::abs(place.y - breach.at.y) > 1) return false;
    for (auto point = first_point_from(agent, from + hair); point != agent.path.end() && point->t < to - hair;
         ++point) {
        if (!is_there({point->x, point->y})) return false;
    }
    return is_there(place_at(agent, to));
}

// Whether a point is at most so far from a cell of an obstacle.
bool is_near(const Map& map, Point from, ObstacleId obstacle, double reach) {
    const auto first = [&](double at, int size) { return int(std::clamp(std::floor(at - reach), 0.0, size - 1.0)); };
    const auto last = [&](double at, int size) { return int(std::clamp(std::ceil(at + reach), 0.0, size - 1.0)); };
    for (int y = first(from.y, map.height()); y <= last(from.y, map.height()); ++y) {
        for (int x = first(from.x, map.width()); x <= last(from.x, map.width()); ++x) {
            if (map.obstacle_at({x, y}) != obstacle) continue;
            const double dx = std::max(std::abs(from.x - x) - 0.5, 0.0);
            const double dy = std::max(std::abs(from.y - y) - 0.5, 0.0);
            if (std::hypot(dx, dy) <= reach) return true;
        }
    }
    return false;
}

// Whether it is one of those that the agent can breach.
bool is_able(const Agent& agent, const Obstacle& obstacle) {
    if (!agent.can_breach) return true;
    if (obstacle.cells > agent.can_breach->most_cells) return false;
    if (!agent.can_breach->only) return true;
    const std::vector<ObstacleId>& named = *agent.can_breach->only;
    return std::count(named.begin(), named.end(), obstacle.id) > 0;
}

}  // namespace

int most_breaches(const Agent& agent) {
    return std::max(agent.kind == AgentKind::air ? agent.breaches : agent.own_breaches, 0);
}

std::string beyond_capacity(const Agent& agent) {
    return "the " + agent.id + " agent breaches more than " + std::to_string(most_breaches(agent)) + " obstacles";
}

Violations judge_removals(const Map& map, const Plan& plan, const Terms& terms) {
    Violations found;
    const Ids protect(terms.rules.protect.begin(), terms.rules.protect.end());
    Ids seen;
    for (const Breach& breach : plan.breaches) {
        const ObstacleId obstacle = breach.obstacle;
        const bool is_new = seen.insert(obstacle).second;
        if (!is_new) found.push_back(violation(Rule::repetition, text(obstacle) + " is removed twice", breach));
        const auto reason = objection(map, obstacle, protect, terms.rules);
        if (reason) found.push_back(violation(Rule::obstacle, *reason, breach));
        if (names_obstacle(map, obstacle)) append(found, judge_description(map, plan, breach));
    }
    append(found, judge_amount(map, plan, terms));
    for (const ObstacleId id : terms.rules.force) {
        if (seen.contains(id) || plan.agents.empty()) continue;
        found.push_back({Rule::removals, text(id) + " is not removed, though it must be", "", id});
    }
    for (const NextBreach& next : plan.next) {
        auto reason = objection(map, next.obstacle, protect, terms.rules);
        if (!reason && seen.contains(next.obstacle)) reason = text(next.obstacle) + " is removed already";
        if (reason) found.push_back({Rule::next, "as the next removal: " + *reason, "", next.obstacle});
    }
    return found;
}

double lasting(const Agent& agent, const Obstacle& obstacle, const Rules& rules) {
    const double of_each = agent.breach_time ? *agent.breach_time : rules.breach_time.per_obstacle;
    const double of_cells = agent.breach_time_per_cell ? *agent.breach_time_per_cell : rules.breach_time.per_cell;
    return obstacle.breach_time + of_each + of_cells * obstacle.cells;
}

Violations judge_breaches(const Map& map, std::span<const Breach> breaches, const Itinerary& agent, const Agent& asked,
                          const Terms& terms) {
    Violations found;
    double free_from = 0;  // the breach before is over
    for (const Breach& breach : breaches) {
        if (!names_obstacle(map, breach.obstacle)) continue;
        if (found.size() > enough_violations) break;
        const double until = breach.cleared_at;
        const double from = until - lasting(asked, map.obstacle(breach.obstacle), terms.rules);
        const auto report = [&](Rule rule, const std::string& what) {
            found.push_back({rule, what, agent.id, breach.obstacle, breach.at, until});
        };
        const bool flies = agent.kind == AgentKind::air;
        if (!is_able(asked, map.obstacle(breach.obstacle)))
            report(Rule::obstacle, "the " + agent.id + " agent cannot breach " + text(breach.obstacle));
        if (!(flies ? stays_there(agent, breach.at, from, until, terms) : stands_there(agent, breach, from, terms))) {
            const std::string when = from < until ? "from " + text(from) + " to " + text(until) : "at " + text(until);
            report(Rule::breach, "the " + agent.id + " agent is not at " + text(breach.at) + " " + when +
                                     " to breach " + text(breach.obstacle));
        } else if (!flies && !is_near(map, place_at(agent, from), breach.obstacle,
                                      terms.body.reach() + asked.reach + terms.tolerance)) {
            report(Rule::boundary, text(breach.obstacle) + " is breached from " + text(place_at(agent, from)) +
                                       ", where the " + agent.id + " agent is too far from it");
        }
        if (from < free_from - slack(terms, free_from)) {
            report(Rule::order, text(breach.obstacle) + " is breached before the one listed before it is cleared, at " +
                                    text(free_from));
        }
        free_from = until;
    }
    return found;
}

}  // namespace waybreaker::checker

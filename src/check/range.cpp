// Whether aircraft come home before their battery is empty: each flight added up from its path, whatever its planner
// says.
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// From when an aircraft takes off until it has landed, by the points of its path and what it breaches: who breaches
// from its start or above its goal flies. Of one under way, from when it is ready; before, it has flown what it says.
struct Flown {
    double off = infinity;  // in units of time
    double down = 0;
    double cells = 0;  // of all moves
    double moving = 0;
    double before = 0;

    double time() const { return before + std::max(down - off, 0.0); }
    double hovering() const { return std::max(time() - moving, 0.0); }
};

Flown flown(const Map& map, const Plan& plan, const Itinerary& agent, const Agent& asked, const Terms& terms) {
    Flown flight;
    flight.before = asked.flown;
    const double ready = asked.approach.empty() ? 0 : asked.ready_at - slack(terms, asked.ready_at);
    const auto flies = [&](double from, double until) {
        flight.off = std::min(flight.off, from);
        flight.down = std::max(flight.down, until);
    };
    for (std::size_t i = 1; i < agent.path.size(); ++i) {
        const Waypoint& a = agent.path[i - 1];
        const Waypoint& b = agent.path[i];
        if ((a.x == b.x && a.y == b.y) || a.t < ready) continue;
        flies(a.t, b.t);
        flight.cells += std::hypot(b.x - a.x, b.y - a.y);
        flight.moving += b.t - a.t;
    }
    for (const Breach& breach : plan.breaches) {
        const bool is_its = breach.by.empty() || breach.by == agent.id;  // by: where there are several
        if (!is_its || !names_obstacle(map, breach.obstacle)) continue;
        const double lasts = terms.rules.breach_time.of(map.obstacle(breach.obstacle));
        if (lasts > 0 && breach.cleared_at - lasts >= ready) flies(breach.cleared_at - lasts, breach.cleared_at);
    }
    if (!asked.approach.empty() && asked.flown > 0 && flight.down > 0)
        flight.off = std::min(flight.off, asked.ready_at);
    return flight;
}

void judge_flight(const Agent& asked, const Flown& flight, const Terms& terms, Violations& found) {
    const double kept = 1 - asked.reserve;
    const auto expect = [&](Rule rule, double most, double value, const std::string& unit) {
        const double limit = kept * most;
        if (value <= limit + slack(terms, limit)) return;
        const std::string reserve = asked.reserve > 0 ? ", " + text(100 * asked.reserve) + " % in reserve" : "";
        found.push_back(
            {rule,
             "the " + asked.id + " agent flies " + text(value) + unit + ", and may fly " + text(limit) + reserve,
             asked.id,
             {},
             {},
             flight.down});
    };
    if (std::isfinite(asked.range))
        expect(Rule::range, asked.range, flight.cells + asked.speed * flight.hovering(), " cells, hovering counted");
    if (std::isfinite(asked.endurance)) expect(Rule::endurance, asked.endurance, flight.time(), " units of time");
}

// That an obstacle which is said to be out of range is one: no straight flight there and to the goal is short enough.
void judge_far(const Map& map, const Mission& mission, const OutOfRange& far, const Terms& terms, Violations& found) {
    const auto fault = [&](const std::string& what) {
        found.push_back({Rule::range, "as out of range: " + what, far.agent, far.obstacle});
    };
    if (!names_obstacle(map, far.obstacle)) return fault("there is no obstacle " + std::to_string(far.obstacle.value));
    const auto is_it = [&](const Agent& agent) { return agent.id == far.agent && agent.kind == AgentKind::air; };
    const auto agent = std::find_if(mission.agents.begin(), mission.agents.end(), is_it);
    if (agent == mission.agents.end()) return fault("there is no air agent " + far.agent);
    const double battery = std::min(agent->range / agent->speed, agent->endurance);
    const double longest = std::max((1 - agent->reserve) * battery - agent->flown, 0.0);
    if (!agree(terms, far.longest, longest))
        return fault(far.agent + " may fly for " + text(longest) + ", not " + text(far.longest));
    const Point start = agent->from.value_or(Point(agent->start));
    double straight = infinity;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (map.obstacle_at({x, y}) != far.obstacle) continue;
            // Beside it, however: no more than a diagonal nearer.
            const double length =
                std::hypot(x - start.x, y - start.y) + std::hypot(x - agent->goal.x, y - agent->goal.y);
            straight = std::min(straight, length - 2 * std::sqrt(2.0));
        }
    }
    const double least =
        std::max(straight, 0.0) / agent->speed + terms.rules.breach_time.of(map.obstacle(far.obstacle));
    if (far.flight < least - slack(terms, least)) return fault("a flight of " + text(far.flight) + " is too short");
    if (!std::isfinite(far.flight) || far.flight <= longest)
        fault("a flight of " + text(far.flight) + " is none that " + far.agent + " may not make");
}

}  // namespace

Violations judge_ranges(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    Violations found;
    for (const Itinerary& agent : plan.agents) {
        const auto is_it = [&](const Agent& asked) { return asked.id == agent.id && asked.kind == AgentKind::air; };
        const auto asked = std::find_if(mission.agents.begin(), mission.agents.end(), is_it);
        if (asked == mission.agents.end() || agent.kind == AgentKind::ground) continue;
        judge_flight(*asked, flown(map, plan, agent, *asked, terms), terms, found);
    }
    for (const OutOfRange& far : plan.out_of_range) judge_far(map, mission, far, terms, found);
    return found;
}

}  // namespace waybreaker::checker

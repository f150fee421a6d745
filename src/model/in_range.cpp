#include "model/in_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/range.hpp"
#include "model/bases.hpp"
#include "model/in_zones.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A lower bound of the time of a flight to a cell beside an obstacle and to the goal.
double least_flight(const Agent& agent, const Box& box) {
    const auto outside = [](double low, double high, double value) {
        return std::max({low - 1 - value, value - high - 1, 0.0});
    };
    const auto to_box = [&](Point p) {
        return std::hypot(outside(box.min.x, box.max.x, p.x), outside(box.min.y, box.max.y, p.y));
    };
    return (to_box(agent.begin()) + to_box(agent.goal)) / agent.speed;
}

// Such a flight, in units of time: one that is short enough, or the shortest. Of an aircraft that recharges, from one
// landing to the next.
double flight_past(const Map& map, const Agent& agent, const Obstacle& obstacle, double enough) {
    double shortest = infinity;
    std::optional<Bases> bases;
    if (agent.recharge) bases.emplace(agent);
    for (const Cell at : map.boundary(obstacle.id)) {
        if (!agent.airspace.allows(at)) continue;
        const auto straight = [&] {
            const double length = agent.airspace.length(agent.begin(), at) + agent.airspace.length(at, agent.goal);
            return length / agent.speed;
        };
        shortest = std::min(shortest, bases ? bases->least_sortie(at) : straight());
        if (shortest <= enough) break;
    }
    return shortest;
}

// Between two landings, of one that recharges; else all that is left of its flight. In units of time.
double longest_sortie(const Agent& agent) {
    return agent.recharge ? (1 - agent.reserve) * agent.battery() : agent.longest_flight();
}

// How long the breach takes; infinity if it may not.
double stay_of(const Agent& agent, const Obstacle& obstacle, const Rules& rules) {
    const bool may = agent.kind == AgentKind::air && agent.breaches > 0;
    return may ? time_to_breach(agent, obstacle, rules) : infinity;
}

bool is_in_range(const Map& map, const Mission& mission, const Obstacle& obstacle) {
    return std::ranges::any_of(mission.agents, [&](const Agent& agent) {
        const double stay = stay_of(agent, obstacle, mission.rules);
        if (std::isinf(stay) || std::isinf(agent.longest_flight())) return std::isfinite(stay);
        if (agent.recharge) {
            const double longest = longest_sortie(agent) * (1 + 1e-9);
            return flight_past(map, agent, obstacle, longest - stay) + stay <= longest;
        }
        const auto fits = [&](double flight) { return agent.may_land_at(agent.ready_at + flight + stay); };
        return fits(least_flight(agent, obstacle.bounds)) &&
               fits(flight_past(map, agent, obstacle, agent.longest_flight() - stay));
    });
}

void validate_limits(const Agent& agent) {
    const bool is_limited = std::isfinite(agent.range) || std::isfinite(agent.endurance);
    const auto require_positive = [&](double value, const std::string& what) {
        if (value > 0) return;
        throw InputError(ErrorCode::out_of_range, agent.id,
                         "the " + agent.id + " agent's " + what + " must be above 0, not " + number_text(value));
    };
    const auto refuse = [&](const std::string& why) {
        throw InputError(ErrorCode::contradiction, agent.id, "the " + agent.id + " agent " + why);
    };
    const bool lands = agent.recharge || !agent.bases.empty();
    if (agent.kind == AgentKind::ground && (is_limited || agent.reserve > 0 || lands))
        refuse("drives: range, endurance, reserve, recharge and bases are for air agents");
    require_positive(agent.range, "range");
    require_positive(agent.endurance, "endurance");
    const std::string reserve = "the reserve of the " + agent.id + " agent";
    require_range(agent.reserve, 0, 1, reserve);
    require_range(agent.flown, 0, most_breach_time, "the time that the " + agent.id + " agent has flown");
    if (agent.recharge) {
        require_positive(*agent.recharge, "time to recharge");
        require_range(*agent.recharge, 0, most_breach_time, "the time to recharge of the " + agent.id + " agent");
    }
    if (agent.reserve == 1) refuse("keeps all of its range in reserve");
    if (agent.reserve > 0 && !is_limited) refuse("has a reserve, and neither a range nor an endurance");
    if (agent.flown > 0 && !is_limited) refuse("has flown, and has neither a range nor an endurance");
    if (agent.recharge && !is_limited) refuse("recharges, and has neither a range nor an endurance");
    if (!agent.bases.empty() && !agent.recharge) refuse("has bases, and no time to recharge there");
    if (agent.bases.size() > most_bases)
        refuse("has " + std::to_string(agent.bases.size()) + " bases: at most " + std::to_string(most_bases));
}

void validate_bases(const Map& map, const Agent& agent) {
    for (const Cell base : agent.bases) {
        const std::string name =
            "the base " + std::to_string(base.x) + "," + std::to_string(base.y) + " of the " + agent.id + " agent";
        if (!map.grid().contains(base)) throw InputError(ErrorCode::off_map, agent.id, name + " is off the map");
        if (!agent.airspace.allows(base))
            throw InputError(ErrorCode::contradiction, agent.id, name + " lies in a no-fly zone");
    }
}

}  // namespace

std::string flight_sentence(const Agent& agent, const std::string& what, double time) {
    const bool by_range = agent.range / agent.speed <= agent.endurance;
    const auto figure = [&](double value) { return number_text(by_range ? value * agent.speed : value); };
    const std::string reserve = agent.reserve > 0 ? ", with " + number_text(100 * agent.reserve) + " % in reserve" : "";
    return "the " + agent.id + " agent can " + (agent.flown > 0 ? "still " : "") + "fly " + (by_range ? "" : "for ") +
           figure(longest_sortie(agent)) + (by_range ? " cells" : " units of time") + reserve + "; " + what +
           (by_range ? " is " : " takes ") + figure(time);
}

void validate_flights(const Map& map, const Mission& mission) {
    for (const Agent& agent : mission.agents) validate_limits(agent);
    if (!mission.limits_flights()) return;
    Mission flown = mission;
    set_airspaces(map, flown);
    const auto refuse = [](const std::string& subject, const std::string& why) {
        throw InputError(ErrorCode::contradiction, subject, why);
    };
    for (const Agent& agent : flown.agents) {
        if (agent.kind == AgentKind::ground) continue;
        validate_bases(map, agent);
        const double time = agent.airspace.length(agent.begin(), agent.goal) / agent.speed;
        const bool gets_home = agent.recharge ? !Bases(agent).ways(agent.begin(), agent.flown, agent.goal).empty()
                                              : agent.may_land_at(agent.ready_at + time);
        const std::string bases = agent.recharge ? ", and no way over its bases has only shorter flights" : "";
        if (!gets_home) refuse(agent.id, flight_sentence(agent, "from its start to its goal it", time) + bases);
    }
    for (const ObstacleId id : mission.rules.force) {
        const auto why = out_of_range(map, flown, id);
        if (!why) continue;
        const std::string name = "obstacle " + std::to_string(id.value);
        const auto agent = std::ranges::find(flown.agents, why->agent, &Agent::id);
        refuse(std::to_string(id.value),
               name + " must be removed, but " + flight_sentence(*agent, name + " and back", why->flight));
    }
}

std::optional<OutOfRange> out_of_range(const Map& map, const Mission& mission, ObstacleId id) {
    const Obstacle& obstacle = map.obstacle(id);
    if (is_in_range(map, mission, obstacle)) return std::nullopt;
    std::optional<OutOfRange> nearest;
    for (const Agent& agent : mission.agents) {
        const double stay = stay_of(agent, obstacle, mission.rules);
        if (std::isinf(stay)) continue;
        const double longest = longest_sortie(agent);
        const double flight = flight_past(map, agent, obstacle, 0) + stay;
        if (nearest && flight / longest >= nearest->flight / nearest->longest) continue;
        nearest = {id, obstacle.source_id, agent.id, flight, longest};
    }
    return nearest;
}

Mission protecting_out_of_range(const Map& map, const Mission& mission) {
    Mission kept = mission;
    if (!mission.limits_flights()) return kept;
    std::vector<ObstacleId>& protect = kept.rules.protect;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.gone() || !obstacle.destructible) continue;
        if (std::ranges::count(mission.rules.opened, obstacle.id, &TimedOpening::obstacle) > 0) continue;
        if (!is_in_range(map, mission, obstacle)) protect.push_back(obstacle.id);
    }
    std::ranges::sort(protect);
    protect.erase(std::unique(protect.begin(), protect.end()), protect.end());
    return kept;
}

}  // namespace waybreaker

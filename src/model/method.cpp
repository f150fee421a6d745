// What can be planned how, and the paper's way to plan.
#include "waybreaker/method.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/range.hpp"
#include "model/abilities.hpp"
#include "model/idle.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

Algorithm planner_of(const Method& method, const Body& body) {
    const bool possible = method.select != Selection::hits && can_drive_optimally(body, method.diagonal);
    return method.planner == Algorithm::optimal && !possible ? Algorithm::theta : method.planner;
}

SearchOptions search_options(const Method& method, const Body& body) {
    return {.planner = planner_of(method, body),
            .heuristic = method.heuristic,
            .weight = method.weight,
            .tie_break = method.tie_break,
            .diagonal = method.diagonal,
            .body = body};
}

void follow_paper(Rules& rules, Method& method) {
    rules.timing = Timing::ignore;
    rules.minimise_demolition.reset();
    method.select = Selection::hits;
    method.planner = Algorithm::theta;
    // For one obstacle the paper flies the shortest way past it, which is what `optimal` does.
    method.flight = rules.removals == 1 ? FlightRule::optimal : FlightRule::nearest;
}

namespace {

// Whether what obstacles weigh is in proportion to their cells.
bool weighs_cells(const Map& map) {
    constexpr double tolerance = 1e-6;
    const auto of_a_cell = [](const Obstacle& o) { return o.weight / o.cells; };
    const auto obstacles = map.obstacles();
    const auto stands = std::ranges::find(obstacles, false, &Obstacle::gone);
    return std::ranges::all_of(stands, obstacles.end(), [&](const Obstacle& o) {
        return o.gone() || std::abs(of_a_cell(o) - of_a_cell(*stands)) <= tolerance * of_a_cell(o);
    });
}

void validate_demolition(const Map& map, const Mission& mission, const Method& method) {
    if (!mission.rules.minimise_demolition) return;
    if (method.select != Selection::exact)
        throw InputError(ErrorCode::contradiction, "", "demolition is minimised by exact selection only");
    if (std::isfinite(mission.rules.budget) && !weighs_cells(map)) {
        throw InputError(ErrorCode::contradiction, "",
                         "demolition is minimised within a budget of square metres or cells, not of other weights");
    }
}

// What cannot be planned of ground agents that breach.
void validate_own_breaches(const Mission& mission) {
    const auto breaches = std::ranges::find_if(mission.agents, [](const Agent& one) { return one.own_breaches > 0; });
    if (breaches == mission.agents.end()) return;
    const auto contradiction = [&](const std::string& what) {
        throw InputError(ErrorCode::contradiction, breaches->id,
                         "the " + breaches->id +
                             (mission.clears() ? " agent breaches from the ground: "
                                               : " agent breaches what is in its way itself: ") +
                             what);
    };
    if (mission.rules.timing == Timing::ignore) contradiction("that takes time, so timing must be enforced");
    if (mission.clears()) {
        if (mission.rules.minimise_demolition) contradiction("demolition is minimised where only aircraft breach");
        return;
    }
    if (!mission.rules.force.empty()) contradiction("no other obstacle can be forced");
    if (!mission.counts_alike()) contradiction("weight and unreached are for several agents");
}

// What agents may breach, and what must be removed.
void validate_capacity(const Mission& mission) {
    std::int64_t capacity = 0;
    for (const Agent& agent : mission.agents) {
        if (agent.own_breaches < 0 || (agent.own_breaches > 0 && agent.kind == AgentKind::air))
            throw InputError(ErrorCode::out_of_range, "own_breaches",
                             "the " + agent.id + " agent's own breaches are those of a ground agent, 0 or more");
        if (agent.kind == AgentKind::ground) {
            const bool is_limited = agent.breaches != any_number;
            if (is_limited)
                throw InputError(ErrorCode::contradiction, "",
                                 "breaches is for air agents: the " + agent.id + " agent drives");
            capacity += agent.own_breaches;
            continue;
        }
        if (agent.breaches < 0)
            throw InputError(ErrorCode::out_of_range, "breaches",
                             "the " + agent.id + " agent cannot breach less than no obstacle");
        capacity += agent.breaches;
    }
    const auto forced = std::int64_t(mission.rules.force.size());
    if (forced > capacity) {
        throw InputError(ErrorCode::contradiction, "",
                         capacity == 0 ? "there is no air agent to remove what must be removed"
                                       : "the agents may breach " + std::to_string(capacity) + " obstacles, but " +
                                             std::to_string(forced) + " must be removed");
    }
}

// What cannot be planned for a team. REQUIRES: no aircraft is idle, or there is but one.
void validate_team(const Mission& mission, const Method& method) {
    const auto aircraft = std::ranges::count(mission.agents, AgentKind::air, &Agent::kind);
    const auto vehicles = std::ssize(mission.agents) - aircraft;
    const bool removes = aircraft > 0 && mission.rules.removals > 0;
    const bool drives_alone = vehicles == 1 && aircraft > 0 && mission.counts_alike();
    if (removes && !(drives_alone && aircraft == 1) && method.flight != FlightRule::optimal) {
        throw InputError(
            ErrorCode::contradiction, "",
            "the aircraft of a team fly by optimal; nearest, the paper's rule, is for one vehicle and one aircraft");
    }
    if (drives_alone) return;
    if (!method.diagonal)
        throw InputError(ErrorCode::contradiction, "", "several ground agents move by eight neighbours, not by four");
}

// Explanations and the least demolition compare plans that are best.
void validate_gap(const Mission& mission, const Method& method, const Limits& limits) {
    if (!(limits.gap >= 0) || !std::isfinite(limits.gap))
        throw InputError(ErrorCode::out_of_range, "the gap", "the gap must be a share of 0 or more");
    if (limits.gap == 0) return;
    if (method.explain)
        throw InputError(ErrorCode::contradiction, "",
                         "explanations compare best plans: leave out the gap, or the explanation");
    if (mission.rules.minimise_demolition) {
        throw InputError(ErrorCode::contradiction, "", "demolition is minimised among best plans: leave out the gap");
    }
}

}  // namespace

void validate(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    require_enumerator(method.select, Selection::none, "what to select by");
    require_enumerator(method.flight, FlightRule::nearest, "what to fly by");
    if (!(limits.seconds > 0))
        throw InputError(ErrorCode::out_of_range, "the time limit", "the time limit must be above 0 seconds");
    validate_gap(mission, method, limits);
    for (const Agent& agent : mission.agents) {
        if (agent.kind != AgentKind::ground) continue;
        validate(search_options(method, agent.body));
        if (method.select == Selection::greedy && planner_of(method, agent.body) != Algorithm::optimal) {
            throw InputError(
                ErrorCode::contradiction, "",
                "greedy selection drives by the optimal planner, which moves an agent that passes no blocked corner");
        }
    }
    validate(map, mission);
    validate_own_breaches(mission);
    validate_capacity(mission);
    validate_abilities(map, mission);
    validate_team(ActivePart(mission).mission(), method);
    validate_demolition(map, mission, method);
}

}  // namespace waybreaker

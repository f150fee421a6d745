#include "waybreaker/revise.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/range.hpp"
#include "core/stopwatch.hpp"
#include "live/base.hpp"
#include "live/battery.hpp"
#include "live/left.hpp"
#include "live/remainder.hpp"
#include "live/state.hpp"
#include "live/zones_now.hpp"
#include "mission/waits.hpp"
#include "model/bases.hpp"
#include "model/in_zones.hpp"
#include "model/objective.hpp"
#include "model/timeline.hpp"
#include "orders/orders.hpp"

namespace waybreaker {
namespace {

using live::Base;
using live::Outlook;
using live::Position;
using live::Report;

constexpr double never = std::numeric_limits<double>::infinity();
// What planning gets even where the time is over.
constexpr double least_seconds = 1e-3;

// With the goals that agents are sent to now.
Mission sent_on(const State& state, Mission mission) {
    for (Agent& agent : mission.agents) {
        const auto said = std::ranges::find(state.agents, agent.id, &AgentState::id);
        if (said != state.agents.end()) agent.goal = said->goal.value_or(agent.goal);
    }
    return mission;
}

// Whether an agent takes no further part.
bool is_out(const Position& position) {
    return position.doing == Doing::lost || position.doing == Doing::stopped;
}

bool drives_alone(const Report& report, std::span<const Position> positions) {
    auto vehicles = std::ranges::count(report.state.joined, AgentKind::ground, &Agent::kind);
    for (std::size_t i = 0; i < positions.size(); ++i)
        vehicles += report.mission.agents[i].kind == AgentKind::ground && !is_out(positions[i]) ? 1 : 0;
    return vehicles == 1;
}

// It begins on its base, and is free at its end.
void begin_on(const Map& map, Base base, Agent& agent) {
    const Waypoint& last = base.back();
    agent.start = {std::clamp(int(std::lround(last.x)), 0, map.width() - 1),
                   std::clamp(int(std::lround(last.y)), 0, map.height() - 1)};
    agent.from.reset();
    if (agent.kind == AgentKind::air && Point(agent.start) != Point(last.x, last.y)) agent.from = Point(last.x, last.y);
    agent.ready_at = last.t;
    agent.approach = std::move(base);
}

// One that has arrived: there, since then.
Base arrived(const Itinerary& agent, const Position& position, double now) {
    Waypoint goal = agent.path.back();
    if (!position.on_time) goal.t = now;
    return {goal};
}

// Where ground agents meet what is in their way.
std::vector<Halt> halts_of(const live::Ground& ground, const Report& report, std::span<const Position> positions) {
    std::vector<Halt> halts;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Agent& agent = report.mission.agents[i];
        if (agent.kind == AgentKind::air || is_out(positions[i])) continue;
        const std::optional<double> hit = ground.first_hit(positions[i].ahead, agent.body);
        if (!hit) continue;
        const auto after = std::ranges::lower_bound(positions[i].ahead, *hit, {}, &Waypoint::t);
        const std::size_t ahead = std::max<std::size_t>(std::size_t(after - positions[i].ahead.begin()), 1);
        halts.push_back({agent.id, positions[i].next + ahead - 1, *hit});
    }
    return halts;
}

// How agents get to where they are free: trusting that all planned breaches are made in time, or only those that have
// begun; as if all went on at once, or as if each waited for all the others.
enum class Placing { as_planned, going_on, waiting };

// Puts the agents that are left where they are free; whether there is a way to do so.
bool place_agents(const Report& report, std::span<const Position> positions, std::span<const Outlook> outlooks,
                  const live::Closed& closed, Placing placing, Mission& left) {
    const Map& known = closed.map();
    std::vector<TimedOpening> openings = left.rules.opened;
    openings.insert(openings.end(), closed.openings.begin(), closed.openings.end());
    for (std::size_t i = 0; i < outlooks.size() && placing == Placing::as_planned; ++i) {
        const Breach& breach = report.plan.breaches[i];
        if (!outlooks[i].opens && !outlooks[i].failed) openings.push_back({breach.obstacle, breach.cleared_at});
    }
    const live::Ground ground{known, openings};
    std::vector<Agent> agents;
    std::vector<std::size_t> vehicles;
    std::vector<std::vector<Base>> choices;
    // Nobody gets in the way of one alone.
    const bool may_meet = left.rules.collisions && !drives_alone(report, positions);
    const auto most = may_meet ? std::numeric_limits<std::size_t>::max() : 1;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (is_out(positions[i])) continue;
        Agent agent = left.agents[i];
        if (const AgentState* said = report.of(agent.id); said != nullptr && said->goal) agent.goal = *said->goal;
        const bool stays =
            positions[i].finished() && agent.goal == left.agents[i].goal && positions[i].at == Point(agent.goal);
        const Itinerary& planned = report.plan.agents[i];
        const bool flies = agent.kind == AgentKind::air;
        const bool may_open = (flies ? agent.breaches : agent.own_breaches) > 0 && left.rules.removals > 0;
        // A vehicle that has arrived may have to make way, from now on.
        const bool may_go = !flies && left.rules.collisions;
        if (stays && !may_open && !may_go) {
            begin_on(known, arrived(planned, positions[i], report.state.now), agent);
        } else if (!flies) {
            vehicles.push_back(agents.size());
            const double bound = live::bound_until(report, i, positions[i]);
            choices.push_back(bases_of(ground, agent, positions[i], bound, most));
        } else {
            const double bound =
                std::max({live::bound_until(report, i, positions[i]), agent.ready_at, positions[i].leaves_zone});
            Base flight = live::until(positions[i].flight(), bound);
            begin_on(known, std::move(flight), agent);
        }
        if (flies)
            live::use_battery(left.agents[i], planned, positions[i], report.of(agent.id), report.state.now, agent);
        agents.push_back(std::move(agent));
    }
    std::vector<Agent> driving;
    for (const std::size_t i : vehicles) driving.push_back(agents[i]);
    std::vector<Base> bases =
        left.rules.collisions
            ? live::without_meetings(known, left.rules.separation, placing == Placing::waiting, driving, choices)
            : live::first_of(choices);
    if (bases.size() != vehicles.size()) return false;
    for (std::size_t v = 0; v < vehicles.size(); ++v) begin_on(known, std::move(bases[v]), agents[vehicles[v]]);
    for (Agent joined : report.state.joined) {
        joined.ready_at = std::max(joined.ready_at, report.decided);
        agents.push_back(std::move(joined));
    }
    left.agents = std::move(agents);
    left.rules.zones = live::zones_for(std::move(left.rules.zones), left.agents);
    // From here on zones that hold now are not closed for good.
    const bool others_hold = std::ranges::any_of(left.rules.zones, &Zone::has_window);
    if (!report.state.joined.empty() || others_hold) set_airspaces(known, left);
    return true;
}

// Of an air agent without breaches.
std::optional<double> flown(const Agent& agent) {
    const double length = path_length(route_home(agent));
    return std::isfinite(length) ? std::optional(length) : std::nullopt;
}

// Without a way for anybody.
Plan no_plan_of(const Mission& mission) {
    Plan none;
    none.status = PlanStatus::no_plan;
    none.before.routes.clear();
    for (const Agent& agent : mission.agents) {
        Route& route = none.before.routes.emplace_back(Route{agent.kind});
        if (agent.kind == AgentKind::air) route.length = flown(agent);
    }
    none.after = none.before;
    return none;
}

// The plan of what is left. None where what was found lies at a start or a goal, which is the `reason`; a state is at
// fault that has an agent join, or go, where there is no room.
Plan plan_of(Planner& planner, const Map& map, const Mission& mission, const State& state, const Method& method,
             const Limits& limits, std::string& reason) {
    Expected<Plan> planned = planner.try_plan(map, mission, method, limits);
    if (planned) return *std::move(planned);
    const Error& error = planned.error();
    const bool of_place = error.code == ErrorCode::no_room;
    const bool joins = std::ranges::find(state.joined, error.subject, &Agent::id) != state.joined.end();
    const bool is_sent = std::ranges::any_of(
        state.agents, [&](const AgentState& agent) { return agent.id == error.subject && agent.goal; });
    if (!of_place || joins || is_sent) throw InputError(error.code, error.subject, error.detail);
    reason = error.detail;
    return no_plan_of(mission);
}

double reached(const Plan& plan, Objective objective) {
    if (plan.status != PlanStatus::solved) return std::numeric_limits<double>::infinity();
    return value(plan.after, objective).value_or(std::numeric_limits<double>::infinity());
}

// The vehicles as if each were alone.
Outcome alone(const Mission& placed, const std::function<Plan(const Mission&)>& plan) {
    Outcome before;
    before.routes.clear();
    Finish finish;
    bool all = true;
    for (const Agent& agent : placed.agents) {
        Route& route = before.routes.emplace_back(Route{agent.kind});
        if (agent.kind == AgentKind::air) {
            route.length = flown(agent);
        } else {
            Mission own{{agent}, placed.rules};
            own.rules.zones = live::zones_for(std::move(own.rules.zones), own.agents);
            own.agents.front().approach.clear();
            own.agents.front().own_breaches = 0;
            own.rules.force.clear();
            own.rules.unreached.reset();
            const Plan its = plan(own);
            if (its.status == PlanStatus::solved) route = its.after.ground();
        }
        const bool flies = agent.kind == AgentKind::air;
        const double latest = flies ? never : unreached_at(placed.rules, agent);
        all = all && (route.length || std::isfinite(latest));
        if (!route.length && std::isinf(latest)) continue;
        const double lasts = flies ? way_home(agent).lasts : route.length.value_or(never) / agent.speed;
        finish.add(agent, std::min(agent.ready_at + lasts, latest));
    }
    if (!all) return before;
    before.makespan = finish.makespan();
    before.flowtime = finish.flowtime;
    before.ground_makespan = finish.ground;
    return before;
}

bool same_bases(const Mission& a, const Mission& b) {
    return std::ranges::equal(a.agents, b.agents, {}, &Agent::approach, &Agent::approach);
}

// What a ground agent breaches itself on its base is done when it decides.
std::vector<Outlook> with_breaches_on_bases(const Report& report, std::span<const Outlook> outlooks,
                                            const Mission& placed) {
    std::vector<Outlook> all(outlooks.begin(), outlooks.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Breach& breach = report.plan.breaches[i];
        const auto agent = std::ranges::find(placed.agents, breach.by, &Agent::id);
        if (agent == placed.agents.end() || agent->kind == AgentKind::air || all[i].opens || all[i].failed) continue;
        if (breach.cleared_at <= agent->ready_at) all[i].opens = breach.cleared_at;
    }
    return all;
}

// The rest of the old plan in place of the new one, where that is no better.
void keep_if_no_worse(const Report& report, std::span<const Position> positions, std::span<const Outlook> outlooks,
                      const Mission& left, const live::Closed& known, const std::function<Plan(const Mission&)>& plan,
                      Revision& next) {
    Mission placed = left;
    if (!place_agents(report, positions, outlooks, known, Placing::as_planned, placed)) return;
    std::optional<Plan> rest = live::remainder_of(report, positions, outlooks, next.map, placed);
    const Objective objective = left.rules.objective;
    if (!rest || reached(*rest, objective) > reached(next.plan, objective) * (1 + 1e-9)) return;
    // What is proven is of agents that are free at the same places.
    bool opens_on_bases = false;
    if (!same_bases(placed, next.mission)) {
        const std::vector<Outlook> all = with_breaches_on_bases(report, outlooks, placed);
        Mission decided = live::left_of(report, all);
        if (!place_agents(report, positions, all, known, Placing::as_planned, decided)) return;
        next.plan = plan(decided);
        opens_on_bases = decided.rules.opened.size() > placed.rules.opened.size();
    }
    live::compare(*rest, next.plan, objective);
    if (next.plan.status != PlanStatus::solved || opens_on_bases) rest->before = alone(placed, plan);
    add_waits(next.map, placed, *rest);
    add_orders(next.map, placed, *rest);
    next.status = RevisionStatus::kept;
    next.mission = std::move(placed);
    next.plan = *std::move(rest);
}

// A vehicle of the plan, or one that joins.
bool any_drives(const Report& report, std::span<const Position> positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (report.mission.agents[i].kind == AgentKind::ground && !is_out(positions[i])) return true;
    }
    return std::ranges::find(report.state.joined, AgentKind::ground, &Agent::kind) != report.state.joined.end();
}

// What the plan after this one says of itself; not yet where agents decide.
Revised after(const Plan& plan, const State& state, std::span<const Found> found) {
    Revised revised = plan.revised.value_or(Revised{.number = 0});
    ++revised.number;
    revised.sequence = state.sequence;
    revised.now = state.now;
    revised.decisions.clear();
    revised.halts.clear();
    revised.reason.clear();
    revised.found.insert(revised.found.end(), found.begin(), found.end());
    return revised;
}

}  // namespace

Revision revise(Planner& planner, const Map& map, const Mission& mission, const Plan& plan, const State& state,
                double reaction, const Method& method, const Limits& limits) {
    if (state.sequence <= (plan.revised ? plan.revised->sequence : 0))
        return {RevisionStatus::unchanged, map, mission, plan};
    const Deadline deadline(limits.seconds);
    live::validate(map, mission, plan, state);
    require_range(reaction, 0, most_breach_time, "the time of reaction");
    require_range(state.now + reaction, 0, most_breach_time, "now, and the time of reaction after it,");
    validate_polygons(mission.rules.zones);
    const Mission in_airspace = live::in_airspace_at(map, mission, state.now);
    const Report report{map, in_airspace, plan, state, state.now + reaction};
    const std::vector<Position> positions = live::positions_of(report);
    const std::vector<Outlook> outlooks = live::outlooks_of(report, positions);
    const Mission left = live::left_of(report, outlooks);
    std::vector<live::Stopped> stopped;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const bool blocks = mission.agents[i].kind == AgentKind::ground && mission.rules.collisions;
        if (positions[i].doing == Doing::stopped && blocks)
            stopped.push_back({positions[i].at, mission.agents[i].body});
    }
    const std::vector<Found> found = live::found_by(map, state, stopped);
    Revision next{RevisionStatus::no_plan, laid_over(map, found), sent_on(state, left)};
    next.plan = no_plan_of(left);
    const live::Closed known = live::closed_at(next.map, left, state.now);
    Revised revised = after(plan, state, found);
    if (!any_drives(report, positions)) {
        revised.reason = "no vehicle is left to drive";
    } else {
        next.status = RevisionStatus::broken;
        const auto plan_left = [&](const Mission& placed) {
            Limits left_over = limits;
            left_over.seconds = std::max(deadline.left(), least_seconds);
            return plan_of(planner, next.map, placed, state, method, left_over, revised.reason);
        };
        for (const Placing placing : {Placing::going_on, Placing::waiting}) {
            Mission placed = left;
            if (!place_agents(report, positions, outlooks, known, placing, placed)) continue;
            if (next.status == RevisionStatus::no_plan && same_bases(placed, next.mission)) break;  // known already
            next.mission = std::move(placed);
            next.plan = plan_left(next.mission);
            next.status = next.plan.status == PlanStatus::solved ? RevisionStatus::revised : RevisionStatus::no_plan;
            keep_if_no_worse(report, positions, outlooks, left, known, plan_left, next);
            if (next.status != RevisionStatus::no_plan) break;
        }
        if (next.status != RevisionStatus::no_plan) revised.reason.clear();
        if (next.status == RevisionStatus::broken) {
            std::vector<TimedOpening> openings = left.rules.opened;
            openings.insert(openings.end(), known.openings.begin(), known.openings.end());
            revised.halts = halts_of({known.map(), openings}, report, positions);
        } else {
            for (const Agent& agent : next.mission.agents) {
                const std::size_t point = agent.approach.empty() ? 0 : agent.approach.size() - 1;
                revised.decisions.push_back({agent.id, point, agent.ready_at});
            }
        }
    }
    revised.status = next.status;
    next.plan.revised = std::move(revised);
    return next;
}

}  // namespace waybreaker

// From mission to plan. plan() reads as the paper's section 3, with time.
#include "waybreaker/planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "clearing/clearing.hpp"
#include "core/range.hpp"
#include "core/stopwatch.hpp"
#include "crossing/access.hpp"
#include "mission/agent_order.hpp"
#include "mission/alternatives.hpp"
#include "mission/candidate_plan.hpp"
#include "mission/entries.hpp"
#include "mission/explain.hpp"
#include "mission/in_windows.hpp"
#include "mission/instead.hpp"
#include "mission/late_openings.hpp"
#include "mission/path_through.hpp"
#include "mission/team_demolition.hpp"
#include "mission/team_plan.hpp"
#include "mission/waits.hpp"
#include "mission/within_range.hpp"
#include "model/abilities.hpp"
#include "model/bases.hpp"
#include "model/idle.hpp"
#include "model/in_zones.hpp"
#include "model/opened.hpp"
#include "model/timeline.hpp"
#include "orders/orders.hpp"
#include "select/bound.hpp"
#include "select/least_demolition.hpp"
#include "select/selector.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {
namespace {

constexpr double share_before_sparing = 0.5;  // of the time: for the best plan, before one that demolishes less
// By which other sets may be worse than the best where vehicles clear for none, to be tried where they do.
constexpr double share_of_starts = 0.1;
constexpr std::size_t most_grown_cells_kept = std::size_t{1} << 22U;  // for the next plan

// Whether nobody gets in anybody's way: there is one ground agent, and aircraft count like it.
bool drives_alone(const Mission& mission) {
    return mission.counts_alike() && std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) == 1;
}

// What is best, or demolishes the least of what is about as good.
Plan planned_team(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                  coalition::Fewer fewer, Searcher& searcher, CrossingSearcher& crossing,
                  Evaluated* evaluated = nullptr) {
    if (!mission.rules.minimise_demolition)
        return plan_team(map, mission, method, limits, fewer, searcher, crossing, evaluated);
    const Stopwatch total;
    const Deadline deadline(limits.seconds);
    Limits first = limits;
    first.seconds *= share_before_sparing;
    const Plan best = plan_team(map, mission, method, first, fewer, searcher, crossing, evaluated);
    const TeamPlanner planned = [&](const Map& weighed, const Mission& frugal, double seconds) {
        Limits left = limits;
        left.seconds = std::max(seconds, 1e-3);
        left.progress = nullptr;
        return plan_team(weighed, frugal, method, left, fewer, searcher, crossing);
    };
    Plan plan = demolish_least_as_team(map, mission, deadline, planned, best);
    plan.seconds.total = total.seconds();
    return plan;
}

// The plan first, as if nothing were to be explained; that takes what time is left.
Plan explained_team(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                    Searcher& searcher, CrossingSearcher& crossing, Evaluated* evaluated) {
    using coalition::Fewer;
    const Stopwatch total;
    const Deadline deadline(limits.seconds);
    Plan plan = planned_team(map, mission, method, limits, Fewer::tried, searcher, crossing, evaluated);
    if (!method.explain || plan.status != PlanStatus::solved) return plan;
    const auto again = [&](const Mission& other, const Limits& left) {
        return plan_team(map, other, method, left, Fewer::tried, searcher, crossing);
    };
    explain_team(map, mission, limits, deadline, again, plan);
    plan.seconds.total = total.seconds();
    return plan;
}

// The plans for ever more removals, up to the last that gains, by whoever plans one of them.
std::vector<Plan> front_by(const Mission& mission, const Method& method, const Limits& limits,
                           const MissionPlanner& planned) {
    const Rules& rules = mission.rules;
    const Deadline deadline(limits.seconds);
    const auto plan_with = [&](int removals, bool explained) {
        Mission step = mission;
        step.rules.removals = removals;
        Method how = method;
        how.explain = explained;
        Limits left = limits;
        left.seconds = std::max(deadline.left(), 1e-3);
        return planned(step, how, left);
    };
    const auto reached = [&rules](const Plan& plan) {
        return value(plan.after, rules.objective).value_or(std::numeric_limits<double>::infinity());
    };
    std::vector<Plan> plans;
    std::size_t worth = 0;  // plans that gained on what came before, and those between them
    const auto beats_best = [&](const Plan& plan) {
        return worth == 0 || reached(plan) < reached(plans[worth - 1]) * (1 - 1e-9);
    };
    // Removals that gain nothing alone may gain together: whether any do, the plan with all of them knows.
    std::optional<Plan> all;
    for (int removals = int(rules.force.size()); removals <= rules.removals; ++removals) {
        plans.push_back(all && removals == rules.removals ? *all : plan_with(removals, false));
        if (beats_best(plans.back())) {
            worth = plans.size();
        } else {
            if (!all) all = plan_with(rules.removals, false);
            // Nothing has to be removed because it may.
            const bool worse = reached(plans.back()) > reached(plans[worth - 1]);
            if (worse && !rules.minimise_demolition) {
                plans.back() = instead(plans.back(), plans[worth - 1], rules.objective);
            }
        }
        if (deadline.passed() || (all && !beats_best(*all))) break;
    }
    plans.resize(worth);
    const bool cut = deadline.passed();
    if (method.explain && !cut) {
        Plan explained = plan_with(int(rules.force.size() + plans.size()) - 1, true);
        if (reached(explained) <= reached(plans.back())) plans.back() = std::move(explained);
    }
    plans.back().limit_reached = plans.back().limit_reached || cut;
    return plans;
}

// Agents that are on their way already begin there.
void begin_on_approach(const Mission& mission, Plan& plan) {
    if (plan.status != PlanStatus::solved) return;
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        const Agent& agent = mission.agents[i];
        if (agent.approach.empty()) continue;
        std::vector<Waypoint> path = agent.approach;
        std::ranges::copy_if(plan.agents[i].path, std::back_inserter(path),
                             [&](const Waypoint& p) { return p.t > agent.ready_at; });
        Route& route = plan.after.routes[i];
        route.path = places(path);
        if (plan.agents[i].reached) route.length = path_length(route.path);
        plan.agents[i].path = std::move(path);
    }
}

Plan finished(const Map& map, const Mission& mission, Plan plan) {
    if (plan.status != PlanStatus::solved) return plan;
    const bool is_under_way =
        std::ranges::any_of(mission.agents, [](const Agent& agent) { return !agent.approach.empty(); });
    begin_on_approach(mission, plan);
    if (mission.clears() || is_under_way) add_entries(map, mission, plan);
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        Itinerary& itinerary = plan.agents[i];
        itinerary.recharges = recharges_on(mission.agents[i], itinerary.path, plan.breaches);
    }
    add_waits(map, mission, plan);
    add_orders(map, mission, plan);
    return plan;
}

}  // namespace

// What is kept from mission to mission.
struct Planner::Memory {
    Searcher searcher;
    CrossingSearcher crossing;
};

Planner::Planner() : memory_(std::make_unique<Memory>()) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

Plan Planner::plan(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    return std::move(plans(map, mission, method, limits, std::nullopt).front());
}

std::vector<Plan> Planner::alternatives(const Map& map, const Mission& mission, double share, const Method& method,
                                        const Limits& limits) {
    require_range(share, 0, 1, "the share by which alternatives may be worse");
    return plans(map, mission, method, limits, share);
}

PathThrough Planner::path_through(const Map& map, Cell start, Cell goal, const BreakingCost& cost,
                                  const PathThroughOptions& options) {
    return waybreaker::path_through(memory_->crossing, map, start, goal, cost, options);
}

std::vector<Plan> Planner::plans(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                                 std::optional<double> share) {
    validate(map, mission, method, limits);
    const auto plan_zoned = [&](const Mission& asked, const Method& how, const Limits& within) {
        const OpenedByThemselves opened(map, asked);
        const InZones zoned(opened.map(), opened.mission());
        return planned(zoned.map(), zoned.mission(), how, within, share);
    };
    std::vector<Plan> plans = has_windows(mission) ? in_windows(map, mission, method, limits, plan_zoned)
                                                   : plan_zoned(mission, method, limits);
    for (Plan& plan : plans) plan = finished(map, mission, std::move(plan));
    return plans;
}

std::vector<Plan> Planner::planned(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                                   std::optional<double> share, bool goes_around_late) {
    const OpenedByThemselves opened(map, mission);
    const Mission able = protecting_unbreachable(opened.map(), opened.mission());
    const ActivePart active(able);
    const AgentOrder order(active.mission());
    std::optional<Evaluated> evaluated;
    if (share) evaluated = Evaluated{*share, {}};
    Evaluated* others = evaluated ? &*evaluated : nullptr;
    const auto plan_within = [&](const Mission& asked, double seconds) {
        Limits left = limits;
        left.seconds = seconds;
        const bool is_again = asked.rules.opened.size() < opened.mission().rules.opened.size();
        if (is_again) left.progress = nullptr;
        const auto plan_step = [&](const Mission& step, const Method& how, const Limits& within) {
            return plan_active(opened.map(), step, how, within, others);
        };
        return within_range(opened.map(), asked, method, left, plan_step, others);
    };
    Plan best;
    if (order.mission().clears()) {
        best = planned_clearing(opened.map(), order.mission(), method, limits);
    } else if (goes_around_late) {
        best = around_late(opened.map(), order.mission(), limits, plan_within);
    } else {
        best = plan_within(order.mission(), limits.seconds);
    }
    std::vector<Plan> plans;
    plans.push_back(std::move(best));
    if (evaluated) append_alternatives(*evaluated, mission.rules.objective, plans);
    for (Plan& plan : plans) plan = active.whole(map, order.restored(std::move(plan)));
    return plans;
}

Plan Planner::planned_clearing(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    const Deadline deadline(limits.seconds);
    crossing::Memory nothing;
    crossing::Access::exchange(memory_->crossing, nothing);
    const Searchers searchers{memory_->searcher, memory_->crossing};
    const auto plan_others = [&](const Mission& others, const Method& how, const Limits& within, clearing::Care care) {
        const bool tells_others = care == clearing::Care::with_others;
        return planned(map, others, how, within, tells_others ? std::optional(share_of_starts) : std::nullopt,
                       care != clearing::Care::once);
    };
    const auto plan_all = [&](const Mission& asked, const Limits& within) {
        clearing::ClearingPlan made = clearing::plan_clearing(map, asked, method, within, searchers, plan_others);
        begin_on_approach(made.mission, made.plan);
        return std::move(made.plan);
    };
    Plan plan = plan_all(mission, limits);
    if (!method.explain || plan.status != PlanStatus::solved) return plan;
    explain_team(map, mission, limits, deadline, plan_all, plan);
    return plan;
}

Plan Planner::plan_active(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                          Evaluated* evaluated) {
    // What earlier missions have taught would change how much work this one is.
    crossing::Memory nothing;
    crossing::Access::exchange(memory_->crossing, nothing);
    if (!drives_alone(mission))
        return explained_team(map, mission, method, limits, memory_->searcher, memory_->crossing, evaluated);
    const Task task = task_of(map, mission, method, limits);
    const Stopwatch total;
    const Searchers searchers{memory_->searcher, memory_->crossing};
    const std::unique_ptr<Selector> selector = selector_of(method, searchers);

    // The ground path without removal; the paper counts on the way how often each obstacle is in it.
    const Candidate baseline = selector->baseline(task);
    // Select the obstacles to remove (beyond those that must be), open the ground path, fly past them, and put both in
    // time.
    const Stopwatch selecting;
    const Candidate start = start_of(task, searchers, baseline);
    const bool spares = mission.rules.minimise_demolition.has_value();
    const Selected selected = selector->select(spares ? task.within(share_before_sparing) : task, start);
    const Candidate* chosen = &best_of(task, start, selected.candidates);
    std::optional<LeastDemolition> least;
    if (spares && chosen->opening.ground.length) {
        least = demolish_least(task, searchers, *selector, baseline, start, selected, *chosen);
        chosen = &least->candidate;
    }
    const Candidate& best = *chosen;
    // The path of a choice that removes nothing was there before.
    const Candidate& before =
        best.schedule.breaches.empty() && cost(task, best) < cost(task, baseline) ? best : baseline;
    const double selecting_seconds = selecting.seconds();

    // Report both, without removal and with the best.
    Plan plan = plan_of(task, mission, best, selector->hits());
    plan.before = outcome_of(mission, before);
    if (plan.status == PlanStatus::solved) {
        const double reached = cost(task, best);
        if (selected.bound || method.bound) {
            const double bound = selected.bound
                                     ? *selected.bound
                                     : prove_bound(task, memory_->crossing, reached, task.deadline).objective;
            plan.bound = std::min(bound, reached);
            plan.gap = *plan.bound > 0 ? reached / *plan.bound - 1 : 0;
        }
        if (least) plan.least_demolition = least->least;
        if (method.explain) {
            explain(task, searchers, *selector, baseline, best, plan);
            explain_agents(mission, plan);
        }
    }
    const auto limited = [](const Candidate& candidate) { return candidate.opening.limited; };
    const bool stopped = limits.stop.stop_requested();
    plan.limit_reached = stopped || selected.limited || (least && least->limited) || limited(baseline) ||
                         limited(start) || std::ranges::any_of(selected.candidates, limited) || task.deadline.passed();
    // Whether there is no way was not found out.
    if (plan.status == PlanStatus::no_plan && selected.may_miss) plan.status = PlanStatus::not_found;
    if (plan.status == PlanStatus::no_plan && plan.limit_reached) {
        plan.status = stopped ? PlanStatus::stopped : PlanStatus::limit_reached;
    }
    plan.seconds.search = baseline.opening.ground.seconds;
    for (const Candidate& candidate : selected.candidates) {
        plan.seconds.search += candidate.opening.ground.seconds;
        plan.seconds.flight += candidate.flight_seconds;
    }
    // The map grown for a wide body takes as much memory as the map itself.
    const bool grown = mission.ground_body().reach() > 0.5;
    if (grown && map.grid().cell_count() > most_grown_cells_kept) memory_->crossing = CrossingSearcher();
    plan.seconds.select = selecting_seconds;
    plan.seconds.total = total.seconds();
    if (evaluated == nullptr) return plan;
    for (const Candidate& candidate : selected.candidates)
        evaluated->plans.push_back(plan_of(task, mission, candidate, selector->hits()));
    evaluated->plans.push_back(plan_of(task, mission, start, selector->hits()));
    return plan;
}

std::vector<Plan> Planner::front(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    validate(map, mission, method, limits);
    if (has_windows(mission)) {
        const auto plan_all = [&](const Mission& asked, const Method& how, const Limits& within) {
            return plan(map, asked, how, within);
        };
        return front_by(mission, method, limits, plan_all);
    }
    const OpenedByThemselves opened(map, mission);
    const InZones zoned(opened.map(), opened.mission());
    const Mission able = protecting_unbreachable(zoned.map(), zoned.mission());
    const ActivePart active(able);
    const AgentOrder order(active.mission());
    std::vector<Plan> plans = front_of_active(zoned.map(), order.mission(), method, limits);
    for (Plan& plan : plans) plan = finished(map, mission, active.whole(map, order.restored(std::move(plan))));
    return plans;
}

std::vector<Plan> Planner::front_of_active(const Map& map, const Mission& mission, const Method& method,
                                           const Limits& limits) {
    const auto breaches = [](const Agent& agent) { return agent.kind == AgentKind::air || agent.own_breaches > 0; };
    if (std::ranges::none_of(mission.agents, breaches)) return {plan_active(map, mission, method, limits)};
    const auto plan_with = [&](const Mission& step, const Method& how, const Limits& left) {
        if (step.clears()) return planned_clearing(map, step, how, left);
        const auto plan_step = [&](const Mission& asked, const Method& by, const Limits& within) {
            if (drives_alone(asked) || how.explain) return plan_active(map, asked, by, within);
            // Those with fewer removals are here anyway.
            return planned_team(map, asked, by, within, coalition::Fewer::not_tried, memory_->searcher,
                                memory_->crossing);
        };
        return within_range(map, step, how, left, plan_step, nullptr);
    };
    return front_by(mission, method, limits, plan_with);
}

}  // namespace waybreaker

// The figures of a plan: that they follow from the agents' paths, or at least fit together.
#include <algorithm>
#include <cmath>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

class FiguresJudge {
  public:
    FiguresJudge(const Plan& plan, const Agent& driver, const Agent& flyer, const Terms& terms)
        : plan_(plan), driver_(driver), flyer_(flyer), terms_(terms) {}

    Violations judge(const Itinerary* ground, const Itinerary* air) {
        judge_status(ground != nullptr);
        judge_before(ground, air);
        if (ground && air) judge_after(*ground, *air);
        judge_bound(plan_, terms_, found_);
        return std::move(found_);
    }

  private:
    void report(Rule rule, const std::string& message, std::optional<double> time = {}) {
        found_.push_back({rule, message, "", {}, {}, time});
    }

    // A figure must be there and be that.
    void expect(Rule rule, const std::string& what, std::optional<double> stated, double truth,
                std::optional<double> time = {}) {
        if (stated && agree(terms_, *stated, truth)) return;
        report(rule, what + " is " + (stated ? text(*stated) : "missing") + " instead of " + text(truth), time);
    }

    void judge_status(bool has_agents) {
        if (has_agents) {
            if (plan_.status == PlanStatus::no_plan) report(Rule::status, "there is no plan, but agents have paths");
            return;
        }
        if (plan_.status == PlanStatus::solved) report(Rule::status, "the plan is solved, but there are no agents");
        if (plan_.after.ground().length || plan_.after.makespan || plan_.after.flowtime) {
            report(Rule::status, "figures after removal without agents that reach them");
        }
        const bool flies_any_distance = std::isinf(flyer_.range) && std::isinf(flyer_.endurance);
        const bool may_be_out_of_range = !terms_.rules.force.empty() && !flies_any_distance;
        if (plan_.status == PlanStatus::no_plan && plan_.before.ground().length && !may_be_out_of_range) {
            report(Rule::status, "there is no plan, but a ground path without removals");
        }
    }

    void judge_before(const Itinerary* ground, const Itinerary* air) {
        const Outcome& before = plan_.before;
        if (before.ground().length.has_value() != before.makespan.has_value() ||
            before.ground().length.has_value() != before.flowtime.has_value()) {
            report(Rule::before, "before removal some figures are there and some missing");
            return;
        }
        if (!ground || !air) return;
        const auto straight = [this](const Itinerary& agent) {
            Point start(agent.start);
            if (agent.kind == AgentKind::air && flyer_.from) start = *flyer_.from;
            return std::hypot(agent.goal.x - start.x, agent.goal.y - start.y);
        };
        // How far it is round zones, only a planner knows.
        const auto is_closed_to_air = [](const Zone& zone) { return zone.kind == ZoneKind::no_fly; };
        // So it is by way of bases.
        const bool bends = std::ranges::any_of(terms_.rules.zones, is_closed_to_air) || flyer_.recharge;
        const double flown = bends ? before.air().length.value_or(straight(*air)) : straight(*air);
        expect(Rule::before, "before removal the air agent's length", before.air().length,
               std::max(flown, straight(*air)));
        const std::optional<double> length = before.ground().length;
        if (!length) return;
        if (*length < straight(*ground) - slack(terms_, *length)) {
            report(Rule::before, "before removal the ground path, " + text(*length) +
                                     " long, is shorter than the straight line, " + text(straight(*ground)));
        }
        const double drive = driver_.ready_at + *length / ground->speed;
        const double flight = flyer_.ready_at + flown / air->speed;
        // It may have to wait for what opens by itself, or to recharge.
        if (!terms_.rules.opened.empty() || flyer_.recharge) return;
        expect(Rule::before, "before removal the makespan", before.makespan, std::max(drive, flight));
        expect(Rule::before, "before removal the flowtime", before.flowtime, drive + flight);
        if (before.ground_makespan || terms_.rules.objective == Objective::ground_makespan) {
            expect(Rule::before, "before removal the ground agent's arrival", before.ground_makespan, drive);
        }
    }

    void judge_after(const Itinerary& ground, const Itinerary& air) {
        const auto length = [](const Itinerary& agent) {
            double sum = 0;
            for (std::size_t i = 1; i < agent.path.size(); ++i) {
                sum += std::hypot(agent.path[i].x - agent.path[i - 1].x, agent.path[i].y - agent.path[i - 1].y);
            }
            return sum;
        };
        const Outcome& after = plan_.after;
        const double ground_end = ground.path.back().t;
        const double air_end = air.path.back().t;
        const double end = std::max(ground_end, air_end);
        expect(Rule::length, "the ground agent's length", after.ground().length, length(ground), ground_end);
        expect(Rule::length, "the air agent's length", after.air().length, length(air), air_end);
        expect(Rule::makespan, "the makespan", after.makespan, end, end);
        expect(Rule::flowtime, "the flowtime", after.flowtime, ground_end + air_end, end);
        // Older plan files do not state it.
        if (after.ground_makespan || terms_.rules.objective == Objective::ground_makespan) {
            expect(Rule::ground_makespan, "the ground agent's arrival", after.ground_makespan, ground_end, ground_end);
        }
    }

    const Plan& plan_;
    const Agent& driver_;
    const Agent& flyer_;
    const Terms& terms_;
    Violations found_;
};

void judge_bound_below(const Plan& plan, std::optional<double> reached, const std::string& what, const Terms& terms,
                       Violations& found) {
    if (!plan.bound || !reached || *plan.bound <= *reached + slack(terms, *reached)) return;
    found.push_back({Rule::bound, "the bound, " + text(*plan.bound) + ", is above " + what + ", " + text(*reached)});
}

// That it is no more than what the plan demolishes.
void judge_least_demolition(const Plan& plan, Violations& found) {
    std::uint64_t cells = 0;
    for (const Breach& breach : plan.breaches) cells += breach.cells;
    const std::uint64_t least = plan.least_demolition.value_or(0);
    if (least <= cells) return;
    found.push_back({Rule::bound, "no plan is said to demolish less than " + std::to_string(least) +
                                      " cells, but this one demolishes " + std::to_string(cells)});
}

// The best plan without a removal is not below the bound either; unless that one had to be removed.
void judge_saves(const Plan& plan, std::optional<double> reached, const Terms& terms, Violations& found) {
    if (!plan.bound || !reached || !terms.rules.force.empty()) return;
    for (const Breach& breach : plan.breaches) {
        if (!breach.saves || *breach.saves >= *plan.bound - *reached - slack(terms, *reached)) continue;
        found.push_back({Rule::saves,
                         "to remove " + text(breach.obstacle) + " saves " + text(*breach.saves) +
                             ": without it a plan would be below the bound, " + text(*plan.bound),
                         "", breach.obstacle});
    }
}

// A failed breach makes of the mission another one under the same rules, unless something must go.
void judge_if_failed(const Plan& plan, const Terms& terms, Violations& found) {
    for (const Breach& breach : plan.breaches) {
        if (!breach.if_failed) continue;
        const auto& [reached, removed] = *breach.if_failed;
        const auto report = [&](const std::string& what) {
            found.push_back({Rule::if_failed, "if " + text(breach.obstacle) + " fails, " + what, "", breach.obstacle});
        };
        if (plan.bound && terms.rules.force.empty() && reached < *plan.bound - slack(terms, *plan.bound))
            report("the objective, " + text(reached) + ", is below the bound, " + text(*plan.bound));
        if (removed.size() > std::size_t(std::max(terms.rules.removals, 0)))
            report("more is removed than may be: " + std::to_string(removed.size()));
    }
}

}  // namespace

void judge_bound(const Plan& plan, const Terms& terms, Violations& found) {
    const auto objective = [&](const Outcome& outcome) { return value(outcome, terms.rules.objective); };
    const std::optional<double> reached = objective(plan.after);
    judge_bound_below(plan, reached, "what the plan reaches", terms, found);
    if (plan.bound && *plan.bound < -slack(terms, 0)) {
        found.push_back({Rule::bound, "the bound, " + text(*plan.bound) + ", is below 0, as no plan is"});
    }
    judge_least_demolition(plan, found);
    judge_saves(plan, reached, terms, found);
    judge_if_failed(plan, terms, found);
    // To remove nothing is one of the plans that the bound speaks of, unless something must go, or a zone with a
    // window, of which that knows nothing, stands in its way.
    if (terms.rules.force.empty() && std::ranges::none_of(terms.rules.zones, &Zone::has_window)) {
        judge_bound_below(plan, objective(plan.before), "what is reached without removals", terms, found);
    }
    if (!plan.gap) return;
    if (!plan.bound || !reached) {
        found.push_back({Rule::gap, "a gap is stated without a bound or a plan"});
        return;
    }
    // Above a bound of 0, only what ends at once has a gap.
    if (*plan.bound <= 0 && *reached > slack(terms, 0)) {
        found.push_back({Rule::gap, "a gap is stated to a bound of " + text(*plan.bound) + ", where there is none"});
        return;
    }
    const double gap = *plan.bound > 0 ? *reached / *plan.bound - 1 : 0;
    if (!agree(terms, *plan.gap, gap)) {
        found.push_back({Rule::gap, "the gap is " + text(*plan.gap) + " instead of " + text(gap)});
    }
}

Violations judge_figures(const Plan& plan, const Itinerary* ground, const Itinerary* air, const Agent& driver,
                         const Agent& flyer, const Terms& terms) {
    return FiguresJudge(plan, driver, flyer, terms).judge(ground, air);
}

}  // namespace waybreaker::checker

#include "mission/explain.hpp"

#include <algorithm>
#include <limits>

namespace waybreaker {
namespace {

constexpr double least_seconds_again = 1e-3;  // of one planning, however little is left

// The best that the selection finds under other rules.
class OtherRules {
  public:
    OtherRules(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline)
        : task_(task), searchers_(searchers), selector_(selector), baseline_(baseline) {}

    double best_cost(const Rules& rules, std::vector<ObstacleId>* removed = nullptr) const {
        const Task other = task_.under(rules);
        const Candidate start = start_of(other, searchers_, baseline_);
        const Selected selected = selector_.select(other, start);
        const Candidate& best = best_of(other, start, selected.candidates);
        if (removed != nullptr) *removed = best.opening.removed;
        return cost(other, best);
    }

  private:
    const Task& task_;
    Searchers searchers_;
    Selector& selector_;
    const Candidate& baseline_;
};

// What the objective would lose without each removal, and the next one.
void explain_removals(const Map& map, const Mission& mission, const Deadline& deadline,
                      const std::function<Plan(const Mission&)>& planned, Plan& plan) {
    const Objective objective = mission.rules.objective;
    const auto reached_by = [objective](const Plan& made) {
        return value(made.after, objective).value_or(std::numeric_limits<double>::infinity());
    };
    const double reached = reached_by(plan);
    for (Breach& breach : plan.breaches) {
        Mission without = mission;
        without.rules.protect.push_back(breach.obstacle);
        std::erase(without.rules.force, breach.obstacle);
        const Plan other = planned(without);
        if (deadline.passed() || (other.status != PlanStatus::solved && other.status != PlanStatus::no_plan)) return;
        breach.saves = reached_by(other) - reached;
    }
    Mission more = mission;
    ++more.rules.removals;
    const Plan other = planned(more);
    if (deadline.passed() || other.status != PlanStatus::solved) return;
    const double gain = reached - reached_by(other);
    if (gain <= 0 || other.breaches.size() <= std::size_t(mission.rules.removals)) return;
    for (const Breach& breach : other.breaches) {
        if (std::ranges::find(plan.breaches, breach.obstacle, &Breach::obstacle) != plan.breaches.end()) continue;
        plan.next.push_back({breach.obstacle, map.obstacle(breach.obstacle).source_id, gain});
        return;
    }
}

}  // namespace

void explain(const Task& task, const Searchers& searchers, Selector& selector, const Candidate& baseline,
             const Candidate& best, Plan& plan) {
    const OtherRules under(task, searchers, selector, baseline);
    const double reached = cost(task, best);
    for (Breach& breach : plan.breaches) {
        Rules without = task.rules;
        without.protect.push_back(breach.obstacle);
        std::erase(without.force, breach.obstacle);
        const double saves = under.best_cost(without) - reached;
        if (task.deadline.passed()) return;
        breach.saves = saves;
    }
    if (task.capacity() <= task.rules.removals) return;
    Rules more = task.rules;
    ++more.removals;
    std::vector<ObstacleId> removed;
    const double gain = reached - under.best_cost(more, &removed);
    if (gain <= 0 || task.deadline.passed()) return;
    for (const ObstacleId id : removed) {
        if (std::ranges::find(best.opening.removed, id) != best.opening.removed.end()) continue;
        plan.next.push_back({id, task.map.obstacle(id).source_id, gain});
        return;
    }
}

void explain_team(const Map& map, const Mission& mission, const Limits& limits, const Deadline& deadline,
                  const std::function<Plan(const Mission&, const Limits&)>& planned, Plan& plan) {
    const auto planned_in_time = [&](const Mission& other) {
        Limits left = limits;
        left.seconds = std::max(deadline.left(), least_seconds_again);
        left.progress = nullptr;
        return planned(other, left);
    };
    explain_removals(map, mission, deadline, planned_in_time, plan);
    explain_agents(mission, plan);
}

void explain_agents(const Mission& mission, Plan& plan) {
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Agent& agent = mission.agents[i];
        if (agent.kind == AgentKind::air) continue;
        const Route& alone = mission.is_team() ? plan.before.routes[i] : plan.before.ground();
        plan.agents[i].gain.reset();
        if (!alone.length || !plan.agents[i].reached) continue;
        plan.agents[i].gain = agent.ready_at + *alone.length / agent.speed - plan.agents[i].path.back().t;
    }
}

}  // namespace waybreaker

#include "clearing/clearing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "clearing/least_arrivals.hpp"
#include "clearing/relaxed_mission.hpp"
#include "clearing/tours.hpp"
#include "clearing/tuning.hpp"
#include "core/stopwatch.hpp"
#include "model/abilities.hpp"
#include "model/objective.hpp"
#include "waybreaker/advanced/safe_interval.hpp"

namespace waybreaker::clearing {
namespace {

constexpr double rounding = 1e-9;

double reached_by(const Mission& mission, const Plan& plan) {
    if (plan.status != PlanStatus::solved) return infinity;
    return value(plan.after, mission.rules.objective).value_or(infinity);
}

class ClearingPlanner {
  public:
    ClearingPlanner(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                    const Searchers& searchers, const Planned& planned)
        : map_(map),
          mission_(mission),
          plain_(method),
          limits_(limits),
          searchers_(searchers),
          planned_(planned),
          deadline_(limits.seconds),
          drives_(map, mission.rules, method, deadline_, searchers),
          least_(map, mission, limits_, deadline_, searchers) {
        states_bound_ = method.select == Selection::exact || method.bound;
        plain_.explain = plain_.bound = false;
        for (std::size_t i = 0; i < mission.agents.size(); ++i) {
            const Agent& agent = mission.agents[i];
            if (agent.own_breaches > 0) clearing_.push_back(i);
            flies_ = flies_ || (agent.kind == AgentKind::air && agent.breaches > 0);
        }
        for (const std::size_t i : clearing_) capacities_.push_back(mission.agents[i].own_breaches);
    }

    ClearingPlan planned() {
        const Stopwatch total;
        best_tours_.resize(clearing_.size());
        if (std::optional<Trial> without = trial_of(best_tours_)) evaluate(std::move(*without));
        if (plans_ == 0) best_ = without_what_is_forced();
        before_ = best_.plan.before;
        std::vector<Tours> starts = relaxed_tours();
        if (relaxed_status_ != PlanStatus::no_plan) {
            for (Tours& tours : own_ways()) starts.push_back(std::move(tours));
            for (Tours& tours : starts) consider(std::move(tours));
            fill_pool();
            improve();
            finish();
        }
        return result(total);
    }

  private:
    std::size_t most_plans() const { return flies_ ? tuning::most_plans_with_aircraft : tuning::most_plans; }

    bool is_over() const {
        return deadline_.passed() || limits_.stop.stop_requested() || plans_ >= most_plans() ||
               best_value_ * (1 - rounding) <= bound_ * (1 + limits_.gap);
    }

    Limits within(double share) const {
        Limits limits = limits_;
        limits.seconds = std::max(deadline_.left() * share, 1e-3);
        limits.progress = nullptr;
        return limits;
    }

    bool may_clear(ObstacleId id) const {
        const Rules& rules = mission_.rules;
        return map_.obstacle(id).destructible && !map_.obstacle(id).gone() &&
               std::ranges::count(rules.protect, id) == 0 &&
               std::ranges::count(rules.opened, id, &TimedOpening::obstacle) == 0;
    }

    // What is breached by the plan, by whom in which order; only what vehicles that clear do.
    Tours tours_of(const Plan& plan) const {
        Tours tours(clearing_.size());
        for (const Breach& breach : plan.breaches) {
            for (std::size_t i = 0; i < clearing_.size(); ++i) {
                if (breach.by == breacher_for(mission_.agents[clearing_[i]])) tours[i].push_back({breach.obstacle});
            }
        }
        return tours;
    }

    void add_to_pool(ObstacleId id) {
        if (pool_.size() < tuning::most_in_pool && may_clear(id) && std::ranges::count(pool_, id) == 0)
            pool_.push_back(id);
    }
    void add_to_pool(const Plan& plan) {
        for (const Breach& breach : plan.breaches) add_to_pool(breach.obstacle);
    }

    // What is in the way of each vehicle; all there is where that is little.
    void fill_pool() {
        for (int crossings = 1; crossings <= std::min(mission_.removals_allowed(), tuning::most_crossings);
             ++crossings) {
            for (const Agent& agent : mission_.agents) {
                if (agent.kind == AgentKind::air || is_over()) continue;
                CrossingOptions options;
                options.body = agent.body.is_point() ? point_body : agent.body;
                options.crossings = crossings;
                options.protect = mission_.rules.protect;
                options.limits = within(tuning::share_of_plan);
                const CrossingResult way = searchers_.crossing.find(map_, agent.start, agent.goal, options);
                for (const ObstacleId id : way.best.crossed) add_to_pool(id);
            }
        }
        if (map_.obstacles().size() > tuning::most_in_pool) return;
        for (const Obstacle& obstacle : map_.obstacles()) add_to_pool(obstacle.id);
    }

    // Bounds the objective, and says which tours to begin with.
    std::vector<Tours> relaxed_tours() {
        const RelaxedMission easier = relaxed(mission_);
        Method method = plain_;
        method.flight = FlightRule::optimal;
        method.bound = true;
        Limits limits = within(tuning::share_of_relaxation);
        limits.gap = std::max(limits.gap, tuning::gap_of_relaxation);
        const std::vector<Plan> plans = planned_(easier.mission, method, limits, Care::with_others);
        relaxed_status_ = plans.front().status;
        limited_ = limited_ || plans.front().limit_reached;
        if (const std::optional<double> bound = plans.front().bound)
            bound_ = std::max(*bound - easier.allowance, least_.of_any());
        std::vector<Tours> tours;
        for (const Plan& plan : plans) {
            if (plan.status != PlanStatus::solved) continue;
            add_to_pool(plan);
            tours.push_back(tours_of(plan));
        }
        return tours;
    }

    // What each would breach that had the map for itself, alone and all together.
    std::vector<Tours> own_ways() {
        std::vector<Tours> found;
        Tours all(clearing_.size());
        for (std::size_t i = 0; i < clearing_.size(); ++i) {
            Mission alone{{mission_.agents[clearing_[i]]}, mission_.rules};
            alone.rules.force.clear();
            alone.rules.unreached.reset();
            alone.agents.front().weight = 1;
            // Nobody else opens anything for it, and the last arrival counts.
            const bool bounds = clearing_.size() == 1 && !flies_ && !mission_.rules.unreached &&
                                mission_.rules.objective != Objective::flowtime;
            Method method = plain_;
            method.bound = bounds;
            const Plan plan = planned_(alone, method, within(tuning::share_of_plan), Care::once).front();
            if (plan.status != PlanStatus::solved) continue;
            if (bounds && plan.bound) bound_ = std::max(bound_, *plan.bound);
            add_to_pool(plan);
            Tours tours(clearing_.size());
            for (const Breach& breach : plan.breaches) {
                tours[i].push_back({breach.obstacle});
                const bool is_new = std::ranges::count(obstacles_of(all), breach.obstacle) == 0;
                if (is_new) all[i].push_back({breach.obstacle});
            }
            found.push_back(std::move(tours));
        }
        if (clearing_.size() > 1) found.push_back(std::move(all));
        return found;
    }

    const Tour& tours_at(const Tours& tours, std::size_t agent) const {
        return tours[std::size_t(std::ranges::find(clearing_, agent) - clearing_.begin())];
    }

    // Its drive, which begins late where it would meet others on theirs.
    std::optional<ClearingDrive> past(const Traffic& driving, const Agent& vehicle, const Tour& tour,
                                      std::span<const TimedOpening> opened) {
        Agent late = vehicle;
        const double step = (2 * vehicle.body.reach() + mission_.rules.separation + 1) / vehicle.speed;
        for (int tries = 0; tries <= tuning::most_delays; ++tries) {
            std::optional<ClearingDrive> clearing = drives_.drive(late, tour, opened);
            const bool is_free = !clearing || tour.empty() || !mission_.rules.collisions ||
                                 driving.met(clearing->path, vehicle.body.reach(), false).empty();
            if (is_free) return clearing;
            late.ready_at = vehicle.ready_at + step * double(1 << tries);
        }
        return std::nullopt;
    }

    // The others' mission past what is cleared; empty if that cannot be.
    std::optional<Mission> beside(const Tours& tours, std::vector<ClearingDrive>& clearings) {
        std::optional<Rules> left = rules_beside(map_, mission_, tours);
        if (!left) return std::nullopt;
        Mission others{mission_.agents, std::move(*left)};
        Rules& rules = others.rules;
        Traffic driving(map_.width(), map_.height(), rules.separation);
        for (std::size_t i = 0; i < mission_.agents.size(); ++i) {
            const Agent& agent = mission_.agents[i];
            const bool waits = std::ranges::count(clearing_, i) > 0 && !tours_at(tours, i).empty();
            if (agent.kind == AgentKind::ground && !agent.approach.empty() && !waits)
                driving.add(std::uint32_t(i), agent.approach, agent.body.reach(), false);
        }
        for (std::size_t i = 0; i < clearing_.size(); ++i) {
            const Agent& vehicle = mission_.agents[clearing_[i]];
            std::optional<ClearingDrive> clearing = past(driving, vehicle, tours[i], rules.opened);
            if (!clearing) return std::nullopt;
            others.agents[clearing_[i]] = under_way(vehicle, *clearing);
            if (!tours[i].empty()) {
                if (rules.unreached && others.agents[clearing_[i]].ready_at >= *rules.unreached) return std::nullopt;
                driving.add(std::uint32_t(clearing_[i]), clearing->path, vehicle.body.reach(), false);
            }
            for (const Cleared& one : clearing->breaches) rules.opened.push_back({one.obstacle, one.cleared_at});
            clearings.push_back(std::move(*clearing));
        }
        if (forced_but_unbreachable(map_, others)) return std::nullopt;
        return others;
    }

    // Tours, what vehicles do by them, and what others still can.
    struct Trial {
        Tours tours;
        Mission others;
        std::vector<ClearingDrive> clearings;
        double least = 0;  // no plan with these tours is below that; 0 where aircraft may open more
    };

    // Empty where the tours cannot be driven, were tried, or are not to be selected.
    std::optional<Trial> trial_of(Tours tours) {
        if (tried_.contains(tours) || (plain_.select == Selection::none && !are_all_in(mission_.rules.force, tours)))
            return std::nullopt;
        Trial trial{std::move(tours), {}, {}};
        std::optional<Mission> others = beside(trial.tours, trial.clearings);
        if (!others) {
            tried_.insert(std::move(trial.tours));
            return std::nullopt;
        }
        trial.others = std::move(*others);
        if (flies_) return trial;
        std::vector<TimedOpening> removed;
        for (const ClearingDrive& clearing : trial.clearings) {
            for (const Cleared& one : clearing.breaches) removed.push_back({one.obstacle, one.cleared_at});
        }
        trial.least = least_.of(removed, trial.others.agents);
        return trial;
    }

    bool may_gain(const Trial& trial) const { return trial.least < best_value_ * (1 - rounding); }

    void evaluate(Trial trial) {
        if (!tried_.insert(trial.tours).second) return;
        const bool is_first = plans_++ == 0 && best_.mission.agents.empty();
        Plan plan = planned_(trial.others, plain_, within(tuning::share_of_plan), Care::once).front();
        limited_ = limited_ || plan.limit_reached;
        const double reached = reached_by(mission_, plan);
        if (!is_first && !(reached < best_value_ * (1 - rounding))) return;
        best_value_ = reached;
        best_tours_ = std::move(trial.tours);
        clearings_ = std::move(trial.clearings);
        best_ = {std::move(plan), std::move(trial.others)};
        if (limits_.progress && std::isfinite(reached)) limits_.progress({reached, bound_});
    }

    void consider(Tours tours) {
        if (is_over()) return;
        std::optional<Trial> trial = trial_of(std::move(tours));
        if (trial && may_gain(*trial)) evaluate(std::move(*trial));
    }

    // One change at a time, the most promising first, until none is better.
    void improve() {
        for (bool improved = true; improved && !is_over();) {
            improved = false;
            std::vector<Trial> next;
            for (Tours& tours : neighbours(best_tours_, pool_, capacities_, mission_.rules.removals)) {
                if (is_over()) return;
                std::optional<Trial> trial = trial_of(std::move(tours));
                if (trial && may_gain(*trial)) next.push_back(std::move(*trial));
            }
            std::ranges::stable_sort(next, {}, &Trial::least);
            const double before = best_value_;
            for (Trial& trial : next) {
                if (is_over()) return;
                evaluate(std::move(trial));
                improved = best_value_ < before;
                if (improved) break;
            }
        }
    }

    // No plan, but what it would be without removals.
    ClearingPlan without_what_is_forced() {
        Mission none = mission_;
        for (Agent& agent : none.agents) agent.own_breaches = 0;
        none.rules.force.clear();
        none.rules.removals = 0;
        Plan plan = planned_(none, plain_, within(tuning::share_of_plan), Care::once).front();
        plan.status = PlanStatus::no_plan;
        plan.agents.clear();
        plan.after.makespan = plan.after.flowtime = plan.after.ground_makespan = std::nullopt;
        return {std::move(plan), std::move(none)};
    }

    // The others once more, each around what opens late for it.
    void finish() {
        if (best_.mission.rules.opened.empty() || is_over()) return;
        Plan plan = planned_(best_.mission, plain_, within(1), Care::around_late).front();
        limited_ = limited_ || plan.limit_reached;
        const double reached = reached_by(mission_, plan);
        if (!(reached < best_value_ * (1 - rounding))) return;
        best_value_ = reached;
        best_.plan = std::move(plan);
    }

    ClearingPlan result(const Stopwatch& total) {
        Plan& plan = best_.plan;
        name_breacher(map_, mission_, plan.breaches);
        for (std::size_t i = 0; i < clearings_.size(); ++i) {
            for (const Cleared& one : clearings_[i].breaches) {
                const Obstacle& obstacle = map_.obstacle(one.obstacle);
                Breach& breach = plan.breaches.emplace_back();
                breach.obstacle = one.obstacle;
                breach.source_id = obstacle.source_id;
                breach.cells = obstacle.cells;
                breach.at = one.at;
                breach.begun_at = one.begun_at;
                breach.cleared_at = one.cleared_at;
                breach.by = mission_.agents[clearing_[i]].id;
            }
        }
        std::ranges::stable_sort(plan.breaches, {}, &Breach::cleared_at);
        for (std::size_t i = 0; i < plan.agents.size(); ++i) plan.agents[i].start = mission_.agents[i].start;
        plan.before = before_;
        plan.bound.reset();
        plan.gap.reset();
        if (plan.status == PlanStatus::solved) {
            if (states_bound_ && bound_ > 0) {
                plan.bound = std::min(bound_, best_value_);
                plan.gap = best_value_ / *plan.bound - 1;
            }
        } else if (relaxed_status_ == PlanStatus::no_plan) {
            plan.status = PlanStatus::no_plan;
        } else if (plan.status == PlanStatus::no_plan) {
            plan.status = limited_ || deadline_.passed() ? PlanStatus::limit_reached : PlanStatus::not_found;
        }
        const bool stopped = limits_.stop.stop_requested();
        if (plan.status == PlanStatus::limit_reached && stopped) plan.status = PlanStatus::stopped;
        plan.limit_reached = limited_ || deadline_.passed() || stopped;
        plan.seconds.total = total.seconds();
        return std::move(best_);
    }

    const Map& map_;
    const Mission& mission_;
    Method plain_;
    const Limits& limits_;
    Searchers searchers_;
    const Planned& planned_;
    Deadline deadline_;
    ClearingDrives drives_;
    LeastArrivals least_;

    std::vector<std::size_t> clearing_;  // the vehicles that clear, as places in the mission
    std::vector<int> capacities_;
    bool flies_ = false;  // an aircraft that may breach

    std::vector<ObstacleId> pool_;
    std::set<Tours> tried_;
    std::size_t plans_ = 0;
    double bound_ = 0;
    bool states_bound_ = false;
    bool limited_ = false;
    PlanStatus relaxed_status_ = PlanStatus::not_found;

    Outcome before_;
    double best_value_ = infinity;
    Tours best_tours_;
    std::vector<ClearingDrive> clearings_;
    ClearingPlan best_;
};

}  // namespace

ClearingPlan plan_clearing(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                           const Searchers& searchers, const Planned& planned) {
    return ClearingPlanner(map, mission, method, limits, searchers, planned).planned();
}

}  // namespace waybreaker::clearing

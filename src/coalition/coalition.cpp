#include "coalition/coalition.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "coalition/collision_free.hpp"
#include "coalition/exact_choice.hpp"
#include "coalition/greedy.hpp"
#include "coalition/tuning.hpp"

namespace waybreaker::coalition {
namespace {

// One planning, in the order of its steps.
class Planning {
  public:
    Planning(const Map& map, const Mission& mission, const team::Interrupts& interrupts, CrossingSearcher& crossing,
             Searcher& theta)
        : interrupts_(interrupts),
          choice_{interrupts.deadline.share(mission.rules.collisions ? tuning::share_of_choice
                                                                     : tuning::share_of_choice_without_collisions),
                  interrupts.stop, interrupts.expansions, interrupts.gap, interrupts.threads},
          problem_(map, mission, choice_),
          crossing_(crossing),
          theta_(theta),
          workers_(problem_, crossing, theta) {}

    CoalitionPlan run(const Choice& choice, const std::function<void(double, double)>& improved) {
        if (!drive_alone()) return std::move(plan_);
        Evaluation evaluation(problem_, plan_.closed, workers_);
        const bool exact = choice.selecting == Selecting::exact;
        if (exact || choice.selecting == Selecting::none) {
            if (!choose_with_bound(exact, evaluation)) return std::move(plan_);
        } else {
            choose(choice, evaluation);
        }
        plan_.limited = plan_.limited || choice_.due() || std::ranges::any_of(plan_.closed, &team::Vehicle::limited);
        plan_.status = interrupts_.end_without_plan(plan_.limited);
        if (!evaluation.drafts().empty()) reached_alone_ = evaluation.reached();
        // Who chooses without a bound evaluates few sets, and more removals must not be worse.
        std::optional<std::size_t> most;
        if (exact) most = tuning::most_collision_free;
        plan_collision_free(problem_, interrupts_, evaluation.drafts(), most, improved, plan_);
        // Last, so that the plan does not depend on whether it is asked for.
        if (choice.proves_bound && !plan_.proven && plan_.status == SearchStatus::found) prove_bound();
        if (choice.share) drafts_ = std::move(evaluation).take_drafts();
        return std::move(plan_);
    }

    // What was evaluated, where a share is given.
    std::vector<Draft> take_drafts() { return std::move(drafts_); }
    // Of any planning of this mission.
    std::vector<CoalitionPlan> alternatives(std::vector<Draft> drafts, double share, const CoalitionPlan& plan) const {
        return plan_alternatives(problem_, interrupts_, std::move(drafts), share, plan);
    }
    int spare_removals() const { return problem_.spare_removals(); }
    // No plan that may remove only so many beside what it must, fewer than this one may, has a smaller objective.
    double bound_with(std::size_t removals) const { return removals < bounds_.size() ? bounds_[removals] : 0; }
    // Whether what vehicles lose on each other, which the choice of sets does not see, may make another set better.
    bool lost_on_others() const {
        if (!reached_alone_) return false;
        const double alone = *reached_alone_;
        return plan_.objective > alone + tolerable_loss(alone, alone - plan_.bound);
    }

  private:
    // Each vehicle past all obstacles. False if a limit ends it.
    bool drive_alone() {
        const std::span<const TimedOpening> openings = problem_.late_openings();
        const team::Ground ground{
            OpenedMap(problem_.map(), problem_.opened()), {openings.begin(), openings.end()}, problem_.rules().rubble};
        std::vector<team::Vehicle> vehicles(problem_.vehicles().size());
        std::vector<SearchStatus> ends(vehicles.size());
        const auto drive = [&](std::size_t i, CrossingSearcher& crossing, Searcher& theta) {
            vehicles[i].agent = *problem_.vehicles()[i];
            ends[i] = team::go_alone(ground, interrupts_, crossing, theta, vehicles[i]);
            team::count_unreached(problem_.rules(), vehicles[i]);
        };
        drive(0, crossing_, theta_);  // first, so that all workers share the maps that it grows
        workers_.for_each(vehicles.size() - 1,
                          [&](std::size_t i, Worker& worker) { drive(i + 1, worker.crossing, worker.theta); });
        for (std::size_t i = 0; i < vehicles.size(); ++i) {
            plan_.closed.push_back(std::move(vehicles[i]));
            if (ends[i] == SearchStatus::found || ends[i] == SearchStatus::no_path) continue;
            plan_.status = ends[i];
            return false;
        }
        return true;
    }

    // Bounds all plans; if `exact`, evaluates the sets that lead to a plan near the bound, else none. False if some
    // vehicle has no way, whatever is removed.
    bool choose_with_bound(bool exact, Evaluation& evaluation) {
        Columns columns(problem_, workers_, Shape::relaxed, plan_.closed);
        Relaxation relaxation(problem_, columns, workers_);
        plan_.bound = relaxation.bound();
        plan_.proven = true;
        if (std::isinf(plan_.bound)) return false;
        evaluation.evaluate({});
        if (exact) {
            ExactChoice choice(problem_, workers_, columns, relaxation, evaluation);
            choice.run();
            plan_.bound = choice.bound();
            for (int removals = 0; removals < problem_.spare_removals(); ++removals) {
                bounds_.push_back(std::max(relaxation.bound_with(std::size_t(removals)), plan_.bound));
            }
        }
        plan_.limited = columns.limited();
        return true;
    }

    // As long as prices raise it.
    void prove_bound() {
        Columns columns(problem_, workers_, Shape::relaxed, plan_.closed);
        Relaxation relaxation(problem_, columns, workers_);
        for (int round = 0; round < tuning::most_price_rounds && !choice_.due() && relaxation.tighten(plan_.objective);
             ++round) {
        }
        plan_.bound = relaxation.bound();
        plan_.proven = true;
        plan_.limited = plan_.limited || columns.limited();
    }

    void choose(const Choice& choice, Evaluation& evaluation) {
        const std::vector<ObstacleId> list = allowed(choice.list);
        if (choice.selecting == Selecting::as_list) {
            Set all = list;
            std::ranges::sort(all);
            return evaluation.evaluate_whole(all);
        }
        evaluation.evaluate({});
        if (choice.selecting == Selecting::greedy) return choose_greedily(evaluation);
        Set set;
        for (const ObstacleId id : list) {
            if (choice_.due()) return;
            set = united(set, {id});
            evaluation.evaluate_growing(set);
        }
    }

    // The first of a list, as many as may be removed, without those that the budget has no room for.
    std::vector<ObstacleId> allowed(std::span<const ObstacleId> list) const {
        std::vector<ObstacleId> allowed;
        double budget = problem_.spare_budget();
        for (const ObstacleId id : list.first(std::min(list.size(), std::size_t(problem_.spare_removals())))) {
            const double weight = problem_.map().obstacle(id).weight;
            if (weight > budget) continue;
            budget -= weight;
            allowed.push_back(id);
        }
        return allowed;
    }

    void choose_greedily(Evaluation& evaluation) {
        Greedy greedy(problem_, workers_);
        while (!choice_.due() && greedy.take_next()) evaluation.evaluate_growing(greedy.taken());
        plan_.limited = plan_.limited || greedy.limited();
    }

    const team::Interrupts& interrupts_;
    team::Interrupts choice_;
    Problem problem_;
    CrossingSearcher& crossing_;
    Searcher& theta_;
    Workers workers_;
    std::optional<double> reached_alone_;  // by the best set, collisions aside
    std::vector<Draft> drafts_;
    std::vector<double> bounds_;  // of plans that may remove less, by how much
    CoalitionPlan plan_;
};

// Planning a mission again under other rules, and the best plan of all.
class Again {
  public:
    using Plan = std::function<CoalitionPlan(int removals, const Set& forced)>;
    Again(const team::Interrupts& interrupts, Plan plan) : interrupts_(interrupts), plan_(std::move(plan)) {}

    void plan(int removals, const Set& forced) { take(plan_(removals, forced)); }
    // The set of a new best plan gets the care of a set that has to be removed.
    void take(CoalitionPlan made) {
        if (!(made.objective < best_.objective)) return;
        best_ = std::move(made);
        Set set;
        for (const Breach& breach : best_.breaches) set.push_back(breach.obstacle);
        std::ranges::sort(set);
        if (set == own_ || interrupts_.due()) return;
        own_ = set;
        CoalitionPlan forced = plan_(int(set.size()), set);
        if (forced.objective < best_.objective) best_ = std::move(forced);
    }
    CoalitionPlan best() { return std::move(best_); }

  private:
    const team::Interrupts& interrupts_;
    Plan plan_;
    CoalitionPlan best_;
    Set own_;  // what the best removes
};

}  // namespace

CoalitionPlan plan_coalition(const Map& map, const Mission& mission, const Choice& choice, Fewer fewer,
                             const team::Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                             const std::function<void(double objective, double bound)>& improved) {
    Planning planning(map, mission, interrupts, crossing, theta);
    CoalitionPlan first = planning.run(choice, improved);
    std::vector<Draft> drafts = planning.take_drafts();
    const auto with_alternatives = [&](CoalitionPlan plan) {
        if (choice.share && plan.status == SearchStatus::found)
            plan.alternatives = planning.alternatives(std::move(drafts), *choice.share, plan);
        return plan;
    };
    const bool tries = fewer == Fewer::tried && choice.selecting == Selecting::exact &&
                       !interrupts.good_enough(first.objective, first.bound) &&
                       (std::isinf(interrupts.deadline.left()) || planning.lost_on_others());
    if (!tries || first.status == SearchStatus::no_path) return with_alternatives(std::move(first));
    const double bound = first.bound;
    double reported = first.objective;
    const auto tell = [&](double objective, double) {
        if (objective < reported) improved(reported = objective, std::min(bound, objective));
    };
    Again again(interrupts, [&](int removals, const Set& forced) {
        Mission other = mission;
        other.rules.removals = removals;
        other.rules.force = forced;
        const Choice same{.selecting = removals > 0 ? Selecting::exact : Selecting::none, .share = choice.share};
        Planning under_others(map, other, interrupts, crossing, theta);
        CoalitionPlan made = under_others.run(same, tell);
        std::ranges::move(under_others.take_drafts(), std::back_inserter(drafts));
        return made;
    });
    // From the fewest on: who may remove less takes the same steps, and leaves out the last.
    const int least = int(mission.rules.force.size());
    for (int spare = 0; spare < planning.spare_removals() && !interrupts.due(); ++spare) {
        if (first.objective <= planning.bound_with(std::size_t(spare))) continue;
        again.plan(least + spare, mission.rules.force);
    }
    again.take(first);
    CoalitionPlan best = again.best();
    if (std::isinf(best.objective)) return with_alternatives(std::move(first));
    best.bound = std::min(bound, best.objective);
    best.limited = best.limited || first.limited;
    best.missed = best.missed || first.missed;
    return with_alternatives(std::move(best));
}

}  // namespace waybreaker::coalition

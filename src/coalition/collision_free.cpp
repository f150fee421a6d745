#include "coalition/collision_free.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "coalition/tuning.hpp"
#include "model/objective.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker::coalition {
namespace {

class DraftPlanner {
  public:
    DraftPlanner(const Problem& problem, const team::Interrupts& interrupts, const CoalitionPlan& plan,
                 const Draft& draft)
        : problem_(problem),
          interrupts_(interrupts),
          closed_(plan.closed),
          bound_(plan.bound),
          unproven_(plan.proven ? draft.cost.first - plan.bound : 0),
          draft_(draft) {}

    // How long an aircraft stays at a target of the draft.
    auto stay(std::size_t aircraft) const {
        return [this, aircraft](std::size_t target) { return problem_.breach_time(aircraft, draft_.set[target]); };
    }

    // With nothing removed, just as a team without aircraft.
    team::TeamPlan plan_paths() const {
        const bool removes = !draft_.set.empty();
        team::Ground ground{OpenedMap(problem_.map(), draft_.set), {}, problem_.rules().rubble};
        for (const auto& [obstacle, time] : draft_.openings) ground.openings.push_back({obstacle, time});
        std::vector<team::Vehicle> vehicles(closed_.begin(), closed_.end());
        for (std::size_t v = 0; removes && v < vehicles.size(); ++v) vehicles[v] = vehicle(v);
        const auto enough = [&](std::span<team::Vehicle> all) {
            const double alone = team::objective_alone(all, problem_.rules().objective);
            return std::max(removes ? alone + tolerable_loss(draft_.cost.first, unproven_) : 0, good_enough());
        };
        return team::plan_paths(ground, std::move(vehicles), problem_.rules(), interrupts_, enough,
                                [](const team::Cost&) {});
    }

    std::vector<team::Path> flights() const {
        std::vector<team::Path> flights;
        for (std::size_t a = 0; a < draft_.sorties.size(); ++a) {
            flights.push_back(flown(*problem_.aircraft()[a], draft_.sorties[a], stay(a)));
        }
        return flights;
    }

    double objective(const std::vector<team::Path>& paths, const std::vector<team::Path>& flights) const {
        Finish finish;
        for (std::size_t v = 0; v < paths.size(); ++v) finish.add(closed_[v].agent, paths[v].back().t);
        for (std::size_t a = 0; a < flights.size(); ++a) finish.add(*problem_.aircraft()[a], flights[a].back().t);
        return rank(problem_.rules().objective, finish).first;
    }

    std::vector<Breach> breaches() const {
        std::vector<Breach> breaches;
        for (std::size_t a = 0; a < draft_.sorties.size(); ++a) {
            const Agent& aircraft = *problem_.aircraft()[a];
            fly(aircraft, draft_.sorties[a], stay(a), [&](const Stop& stop, double begun, double cleared) {
                const Obstacle& obstacle = problem_.map().obstacle(draft_.set[stop.target]);
                Breach& breach = breaches.emplace_back();
                breach.obstacle = obstacle.id;
                breach.source_id = obstacle.source_id;
                breach.cells = obstacle.cells;
                breach.at = stop.at;
                breach.by = aircraft.id;
                breach.begun_at = begun;
                breach.cleared_at = cleared;
            });
        }
        std::ranges::stable_sort(breaches, {}, &Breach::cleared_at);
        return breaches;
    }

  private:
    // Of the vehicles' objective, with the flights of the draft; 0 if none is.
    double good_enough() const {
        if (interrupts_.gap == 0) return 0;
        double flown = 0;
        if (problem_.sums()) {
            const std::vector<team::Path> paths = flights();
            for (std::size_t a = 0; a < paths.size(); ++a)
                flown += weighted(problem_.aircraft()[a]->weight, paths[a].back().t);
        }
        return bound_ * (1 + interrupts_.gap) - flown;
    }

    team::Vehicle vehicle(std::size_t v) const {
        const Way& way = draft_.taken[v];
        team::Vehicle vehicle;
        vehicle.agent = closed_[v].agent;
        vehicle.way = way.path;
        vehicle.alone = arrival(vehicle.agent, way, draft_.openings);
        vehicle.expanded = way.expanded;
        vehicle.generated = way.generated;
        return vehicle;
    }

    const Problem& problem_;
    const team::Interrupts& interrupts_;
    std::span<const team::Vehicle> closed_;
    double bound_;
    double unproven_;  // what the draft may be above the best; 0 where nobody knows
    const Draft& draft_;
};

Set breached(const CoalitionPlan& plan) {
    Set set;
    for (const Breach& breach : plan.breaches) set.push_back(breach.obstacle);
    std::ranges::sort(set);
    return set;
}

}  // namespace

double tolerable_loss(double objective, double unproven) {
    return std::max(tuning::tolerable_loss * objective, tuning::tolerable_part_of_gap * unproven);
}

void plan_collision_free(const Problem& problem, const team::Interrupts& interrupts, std::span<const Draft> drafts,
                         std::optional<std::size_t> most, const std::function<void(double, double)>& improved,
                         CoalitionPlan& plan) {
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        const Draft& draft = drafts[i];
        if ((most && draft.cost.first >= plan.objective) || (plan.objective < infinity && interrupts.due())) break;
        if (interrupts.good_enough(plan.objective, plan.bound)) break;
        if (most && i >= *most && !draft.set.empty() && plan.objective < infinity) continue;
        const DraftPlanner planner(problem, interrupts, plan, draft);
        team::TeamPlan planned = planner.plan_paths();
        if (planned.status != SearchStatus::found) {
            plan.missed = plan.missed || !draft.set.empty();
            continue;
        }
        std::vector<team::Path> flights = planner.flights();
        const double reached = planner.objective(planned.paths, flights);
        if (reached >= plan.objective) continue;
        plan.objective = reached;
        plan.status = SearchStatus::found;
        plan.limited = plan.limited || planned.limited;
        plan.team = std::move(planned);
        plan.flights = std::move(flights);
        plan.breaches = planner.breaches();
        improved(reached, std::min(plan.bound, reached));
    }
}

std::vector<CoalitionPlan> plan_alternatives(const Problem& problem, const team::Interrupts& interrupts,
                                             std::vector<Draft> drafts, double share, const CoalitionPlan& plan) {
    const double most = plan.objective * (1 + share);
    std::ranges::stable_sort(drafts, {}, [](const Draft& draft) { return draft.cost.first; });
    std::vector<CoalitionPlan> alternatives;
    std::vector<Set> known{united(breached(plan), problem.opened())};
    for (const Draft& draft : drafts) {
        if (draft.cost.first > most || interrupts.due()) break;
        Set set = united(draft.set, problem.opened());
        if (std::ranges::find(known, set) != known.end()) continue;
        known.push_back(std::move(set));
        CoalitionPlan other;
        other.closed = plan.closed;
        other.bound = plan.bound;
        other.proven = plan.proven;
        plan_collision_free(
            problem, interrupts, std::span(&draft, 1), std::nullopt, [](double, double) {}, other);
        if (other.objective <= most) alternatives.push_back(std::move(other));
    }
    return alternatives;
}

}  // namespace waybreaker::coalition

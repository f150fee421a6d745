#include "coalition/coalition.hpp"

#include <algorithm>
#include <cmath>

#include "coalition/all_sets.hpp"
#include "coalition/joint.hpp"
#include "coalition/picks.hpp"
#include "coalition/relaxation.hpp"
#include "model/objective.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker::coalition {
namespace {

// Of the time that is left when choosing begins; the rest is for paths past each other.
constexpr double share_of_choice = 0.6;
constexpr int most_rounds = 12;
// Relative: a set so near to the bound is good enough; so near to it that sets are compared one by one, not by prices;
// and so near that what only a wider body needs is not looked for.
constexpr double close = 1e-3;
constexpr double near = 6e-3;
constexpr double near_enough = 5e-3;
// Relative: how much more than the best columns may cost that are compared with all others.
constexpr double listed = 4e-3;
// Prices aim at what the best set reaches; no farther, while there is none or a bad one.
constexpr double farthest_aim = 1.1;
// Of what is missing: when a round of prices gains less, no other follows.
constexpr double least_gain = 0.1;
// Sets put in time, one after the other, that are no better than the best.
constexpr int most_vain_tries = 4;
// All sets are tried if they are no more.
constexpr std::size_t most_sets = 128;
constexpr std::uint64_t most_effort = 100'000;  // as Ways::effort() counts
// What vehicles may lose on each other: of the objective, and of what is not proven anyway.
constexpr double close_on_others = 2e-4;
constexpr double small_share = 0.05;
// Sets planned past collisions, while another one may still be better.
constexpr std::size_t most_tries = 4;

// One planning, in the order of its steps.
class Planning {
  public:
    Planning(const Map& map, const Mission& mission, const team::Interrupts& interrupts, CrossingSearcher& crossing,
             Searcher& theta)
        : interrupts_(interrupts),
          choice_{interrupts.deadline.share(share_of_choice), interrupts.stop, interrupts.expansions, interrupts.gap,
                  interrupts.threads},
          problem_(map, mission, choice_),
          crossing_(crossing),
          theta_(theta),
          crew_(problem_, crossing, theta) {}

    CoalitionPlan run(bool selects, const std::function<void(double, double)>& improved) {
        if (!drive_alone()) return std::move(plan_);
        Columns columns(problem_, crew_, Shape::relaxed, plan_.closed);
        Relaxation relaxation(problem_, columns, crew_);
        plan_.bound = relaxation.bound();
        if (std::isinf(plan_.bound)) return std::move(plan_);
        Ways ways(problem_, plan_.closed);
        SortiePlanner sorties(problem_, ways, crew_);
        sorties_ = &sorties;
        ways_ = &ways;
        draft({});
        if (selects) choose(columns, relaxation);
        for (int removals = 0; removals < problem_.spare_removals(); ++removals) {
            bounds_.push_back(std::max(relaxation.bound_with(std::size_t(removals)), plan_.bound));
        }
        plan_.limited =
            columns.limited() || choice_.due() || std::ranges::any_of(plan_.closed, &team::Vehicle::limited);
        plan_.status = interrupts_.end_without_plan(plan_.limited);
        plan_drafts(improved);
        return std::move(plan_);
    }

    int spare_removals() const { return problem_.spare_removals(); }
    // No plan that may remove only so many beside what it must, fewer than this one may, has a smaller objective.
    double bound_with(std::size_t removals) const { return removals < bounds_.size() ? bounds_[removals] : 0; }
    // Whether what vehicles lose on each other, which the choice of sets does not see, may make another set better.
    bool lost_on_others() const {
        if (drafts_.empty()) return false;
        const double alone = drafts_.front().cost.first;
        return plan_.objective > alone + tolerable_loss(alone);
    }

  private:
    // Each vehicle past all obstacles. False if a limit ends it.
    bool drive_alone() {
        const OpenedMap map(problem_.map());
        std::vector<team::Vehicle> vehicles(problem_.vehicles().size());
        std::vector<SearchStatus> ends(vehicles.size());
        const auto drive = [&](std::size_t i, CrossingSearcher& crossing, Searcher& theta) {
            vehicles[i].agent = *problem_.vehicles()[i];
            ends[i] = team::go_alone(map, interrupts_, crossing, theta, vehicles[i]);
        };
        drive(0, crossing_, theta_);  // first, so that all hands share the maps that it grows
        crew_.for_each(vehicles.size() - 1,
                       [&](std::size_t i, Hand& hand) { drive(i + 1, hand.crossing, hand.theta); });
        for (std::size_t i = 0; i < vehicles.size(); ++i) {
            plan_.closed.push_back(std::move(vehicles[i]));
            if (ends[i] == SearchStatus::found || ends[i] == SearchStatus::no_path) continue;
            plan_.status = ends[i];
            return false;
        }
        return true;
    }

    // Puts a set in time, beside what must be removed; once.
    void draft(const Set& set) {
        const Set all = united(problem_.forced(), set);
        if (std::ranges::find(drafted_, all) != drafted_.end()) return;
        drafted_.push_back(all);
        put(sorties_->plan(all, reached()));
    }

    void put(Draft draft) {
        if (draft.cost.missing > 0) return;
        const auto worse = [&](const Draft& other) { return team::better(draft.cost, other.cost); };
        drafts_.insert(std::ranges::find_if(drafts_, worse), std::move(draft));
    }

    void choose(Columns& columns, Relaxation& relaxation) {
        improve_prices(columns, relaxation);
        const bool none = drafts_.empty();
        if (none) draft_for_own_bodies(relaxation);
        try_jointly(columns, relaxation);
        if (!none && !is_within(near_enough)) draft_for_own_bodies(relaxation);
        if (!is_within(close)) try_all(columns);
    }

    // With more care than before, as long as that takes little.
    void try_all(const Columns& columns) {
        const std::uint64_t enough = ways_->effort() + most_effort;
        for (const Set& set : all_sets(problem_, columns, most_sets)) {
            if (choice_.due() || ways_->effort() >= enough) return;
            put(sorties_->plan(united(problem_.forced(), set), reached(), enough));
        }
    }

    double reached() const { return drafts_.empty() ? infinity : drafts_.front().cost.first; }
    // A plan that is so near to the bound, or as near as the caller needs it.
    bool is_within(double gap) const { return reached() <= plan_.bound * (1 + std::max(gap, interrupts_.gap)); }

    // Prices learn from the best set, and find more wishes; wishes find better sets.
    void improve_prices(const Columns& columns, Relaxation& relaxation) {
        draft(Picks(problem_, columns).best_from({}));
        for (int round = 0; round < most_rounds && !choice_.due() && !is_within(near); ++round) {
            const double aim = std::min(reached(), farthest_aim * plan_.bound);
            const bool found = relaxation.tighten(aim);
            const double gain = relaxation.bound() - plan_.bound;
            const double missing = reached() - plan_.bound;
            plan_.bound = relaxation.bound();
            if (!found) return;
            draft(Picks(problem_, columns).best_from({}));
            if (round > 1 && gain <= least_gain * missing) return;
        }
    }

    // Sets in the order of their limits, until none can be better or patience is over.
    void try_jointly(Columns& columns, Relaxation& relaxation) {
        if (drafts_.empty() || is_within(close) || choice_.due()) return;
        // All that could be part of a better plan, or what is likely to be. Where vehicles are many, lists as long as
        // that say too little.
        const double useless = reached() / (1 + interrupts_.gap);
        const double longest = Columns::most_margin * reached() / double(columns.size());
        if (problem_.sums() && longest < least_gain * (useless - plan_.bound)) return;
        relaxation.list(std::min(useless - plan_.bound, listed * reached()));
        plan_.bound = std::max(plan_.bound, relaxation.bound());
        if (!relaxation.proof().complete) return;
        Joint joint(problem_, columns, relaxation.proof(), crew_.own().openings, useless);
        const double enough = 1 + std::max(close, interrupts_.gap);
        for (int vain = 0; vain < most_vain_tries && reached() > joint.rest() * enough;) {
            const std::optional<Set> set = joint.next();
            if (!set) break;
            const double before = reached();
            draft(*set);
            vain = reached() < before ? 0 : vain + 1;
        }
        plan_.bound = std::max(plan_.bound, std::min(joint.bound(), reached()));
    }

    // A vehicle may need more open than a point, which slips through.
    void draft_for_own_bodies(const Relaxation& relaxation) {
        if (choice_.due()) return;
        const Columns own(problem_, crew_, Shape::own);
        Picks picks(problem_, own);
        draft(picks.best_from({}));
        draft(picks.best_from(most_wanted(relaxation)));
    }

    // As many as may be removed together.
    Set most_wanted(const Relaxation& relaxation) const {
        Set set;
        double weight = 0;
        for (const ObstacleId id : relaxation.wanted()) {
            if (set.size() == std::size_t(problem_.spare_removals())) break;
            const double more = weight + problem_.map().obstacle(id).weight;
            if (more > problem_.spare_budget()) continue;
            weight = more;
            set.push_back(id);
        }
        std::ranges::sort(set);
        return set;
    }

    void plan_drafts(const std::function<void(double, double)>& improved) {
        for (std::size_t i = 0; i < drafts_.size(); ++i) {
            const Draft& draft = drafts_[i];
            if (draft.cost.first >= plan_.objective || (plan_.objective < infinity && interrupts_.due())) break;
            if (interrupts_.good_enough(plan_.objective, plan_.bound)) break;
            if (i >= most_tries && !draft.set.empty()) continue;
            team::TeamPlan planned = plan_paths(draft);
            if (planned.status != SearchStatus::found) continue;
            std::vector<team::Path> flights = this->flights(draft);
            const double reached = objective(planned.paths, flights);
            if (reached >= plan_.objective) continue;
            plan_.objective = reached;
            plan_.status = SearchStatus::found;
            plan_.limited = plan_.limited || planned.limited;
            plan_.team = std::move(planned);
            plan_.flights = std::move(flights);
            plan_.breaches = breaches(draft);
            improved(reached, std::min(plan_.bound, reached));
        }
    }

    // With nothing removed, just as a team without aircraft.
    team::TeamPlan plan_paths(const Draft& draft) const {
        const bool removes = !draft.set.empty();
        team::Ground ground{OpenedMap(problem_.map(), draft.set)};
        for (const auto& [obstacle, time] : draft.openings) ground.openings.push_back({obstacle, time});
        std::vector<team::Vehicle> vehicles = plan_.closed;
        for (std::size_t v = 0; removes && v < vehicles.size(); ++v) vehicles[v] = vehicle(draft, v);
        const auto enough = [&](std::span<team::Vehicle> all) {
            const double alone = team::objective_alone(all, problem_.rules().objective);
            return std::max(removes ? alone + tolerable_loss(draft.cost.first) : 0, good_enough(draft));
        };
        return team::plan_paths(ground, std::move(vehicles), problem_.rules(), interrupts_, enough,
                                [](const team::Cost&) {});
    }

    // On other vehicles, where nobody would do otherwise.
    double tolerable_loss(double alone) const {
        return std::max(close_on_others * alone, small_share * (alone - plan_.bound));
    }

    // Of the vehicles' objective, with the flights of a draft; 0 if none is.
    double good_enough(const Draft& draft) const {
        if (interrupts_.gap == 0) return 0;
        double flown = 0;
        if (problem_.sums()) {
            for (const team::Path& path : flights(draft)) flown += path.back().t;
        }
        return plan_.bound * (1 + interrupts_.gap) - flown;
    }

    team::Vehicle vehicle(const Draft& draft, std::size_t v) const {
        const Way& way = draft.taken[v];
        team::Vehicle vehicle;
        vehicle.agent = plan_.closed[v].agent;
        vehicle.way = way.path;
        vehicle.alone = arrival(vehicle.agent, way, draft.openings);
        vehicle.expanded = way.expanded;
        vehicle.generated = way.generated;
        return vehicle;
    }

    double objective(const std::vector<team::Path>& paths, const std::vector<team::Path>& flights) const {
        Finish finish;
        for (const team::Path& path : paths) finish.add(AgentKind::ground, path.back().t);
        for (const team::Path& path : flights) finish.add(AgentKind::air, path.back().t);
        return rank(problem_.rules().objective, finish).first;
    }

    // How long an aircraft stays at the targets of a draft.
    auto stay(const Draft& draft) const {
        return [this, &draft](std::size_t target) { return problem_.breach_time(draft.set[target]); };
    }

    std::vector<team::Path> flights(const Draft& draft) const {
        std::vector<team::Path> flights;
        for (std::size_t a = 0; a < draft.sorties.size(); ++a) {
            flights.push_back(flown(*problem_.aircraft()[a], draft.sorties[a], stay(draft)));
        }
        return flights;
    }

    std::vector<Breach> breaches(const Draft& draft) const {
        std::vector<Breach> breaches;
        for (std::size_t a = 0; a < draft.sorties.size(); ++a) {
            const Agent& aircraft = *problem_.aircraft()[a];
            fly(aircraft, draft.sorties[a], stay(draft), [&](const Stop& stop, double begun, double cleared) {
                const Obstacle& obstacle = problem_.map().obstacle(draft.set[stop.target]);
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

    const team::Interrupts& interrupts_;
    team::Interrupts choice_;
    Problem problem_;
    CrossingSearcher& crossing_;
    Searcher& theta_;
    Crew crew_;
    Ways* ways_ = nullptr;
    SortiePlanner* sorties_ = nullptr;
    std::vector<Set> drafted_;
    std::vector<Draft> drafts_;   // the best first
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

CoalitionPlan plan_coalition(const Map& map, const Mission& mission, bool selects, Fewer fewer,
                             const team::Interrupts& interrupts, CrossingSearcher& crossing, Searcher& theta,
                             const std::function<void(double objective, double bound)>& improved) {
    Planning planning(map, mission, interrupts, crossing, theta);
    CoalitionPlan first = planning.run(selects, improved);
    const bool tries = fewer == Fewer::tried && selects && !interrupts.good_enough(first.objective, first.bound) &&
                       (std::isinf(interrupts.deadline.left()) || planning.lost_on_others());
    if (!tries || first.status == SearchStatus::no_path) return first;
    const double bound = first.bound;
    double told = first.objective;
    const auto tell = [&](double objective, double) {
        if (objective < told) improved(told = objective, std::min(bound, objective));
    };
    Again again(interrupts, [&](int removals, const Set& forced) {
        Mission other = mission;
        other.rules.removals = removals;
        other.rules.force = forced;
        return Planning(map, other, interrupts, crossing, theta).run(removals > 0, tell);
    });
    // From the fewest on: who may remove less takes the same steps, and leaves out the last.
    const int least = int(mission.rules.force.size());
    for (int spare = 0; spare < planning.spare_removals() && !interrupts.due(); ++spare) {
        if (first.objective <= planning.bound_with(std::size_t(spare))) continue;
        again.plan(least + spare, mission.rules.force);
    }
    again.take(first);
    CoalitionPlan best = again.best();
    if (std::isinf(best.objective)) return first;
    best.bound = std::min(bound, best.objective);
    best.limited = best.limited || first.limited;
    return best;
}

}  // namespace waybreaker::coalition

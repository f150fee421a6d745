#include "coalition/coalition.hpp"

#include <algorithm>
#include <cmath>

#include "coalition/picks.hpp"
#include "coalition/relaxation.hpp"
#include "plan/timeline.hpp"

namespace waybreaker::coalition {
namespace {

// Of the time that is left when choosing begins; the rest is for paths past each other.
constexpr double share_of_choice = 0.6;
constexpr int most_rounds = 12;
// Relative: a set so near to the bound is good enough; and so near to it that no obstacles are exchanged.
constexpr double close = 1e-3;
constexpr double near = 5e-3;
// Relative: when rounds of prices raise the bound by less, they end.
constexpr double least_gain = 2e-4;
// Sets put in time to exchange one obstacle, for one vehicle; for more, so many times fewer.
constexpr std::size_t most_exchanges = 1000;
// Sets planned past collisions, while another one may still be better.
constexpr std::size_t most_tries = 4;

// One planning, in the order of its steps.
class Planning {
  public:
    Planning(const Map& map, const Mission& mission, const team::Interrupts& interrupts, CrossingSearcher& crossing,
             Searcher& theta)
        : interrupts_(interrupts),
          choice_{interrupts.deadline.share(share_of_choice), interrupts.stop, interrupts.expansions},
          problem_(map, mission, choice_),
          crossing_(crossing),
          theta_(theta) {}

    CoalitionPlan run(bool selects, const std::function<void(double, double)>& improved) {
        if (!drive_alone()) return std::move(plan_);
        Columns columns(problem_, crossing_, Shape::relaxed);
        Relaxation relaxation(problem_, columns);
        plan_.bound = relaxation.bound();
        if (std::isinf(plan_.bound)) return std::move(plan_);
        Ways ways(problem_, plan_.closed, crossing_, theta_);
        SortiePlanner sorties(problem_, ways);
        sorties_ = &sorties;
        draft({});
        if (selects) {
            const Columns own(problem_, crossing_, Shape::own);
            choose(columns, own, relaxation);
            exchange(own, columns, relaxation, ways);
        }
        plan_.bound = relaxation.bound();
        plan_.limited = columns.limited() || choice_.due();
        plan_.status = interrupts_.stop.stop_requested() ? SearchStatus::stopped : SearchStatus::limit_reached;
        plan_drafts(improved);
        return std::move(plan_);
    }

  private:
    // Each vehicle past all obstacles. False if a limit ends it.
    bool drive_alone() {
        for (const Agent* agent : problem_.vehicles()) {
            team::Vehicle& vehicle = plan_.closed.emplace_back();
            vehicle.agent = *agent;
            const SearchStatus status =
                team::go_alone(OpenedMap(problem_.map()), interrupts_, crossing_, theta_, vehicle);
            if (status == SearchStatus::found || status == SearchStatus::no_path) continue;
            plan_.status = status;
            return false;
        }
        return true;
    }

    // Puts a set in time, beside what must be removed; once.
    void draft(const Set& set) {
        const Set all = united(problem_.forced(), set);
        if (std::ranges::find(drafted_, all) != drafted_.end()) return;
        drafted_.push_back(all);
        Draft draft = sorties_->plan(all);
        if (draft.cost.missing > 0) return;
        const auto worse = [&](const Draft& other) { return team::better(draft.cost, other.cost); };
        drafts_.insert(std::ranges::find_if(drafts_, worse), std::move(draft));
    }

    // Sets by what is known of the vehicles' wishes and by what they pay for; prices learn from each set, and find more
    // wishes.
    void choose(Columns& columns, const Columns& own, Relaxation& relaxation) {
        Picks by_own(problem_, own);
        draft(by_own.best_from({}));
        for (int round = 0; round < most_rounds && !choice_.due(); ++round) {
            Picks picks(problem_, columns);
            draft(picks.best_from({}));
            draft(picks.best_from(most_wanted(relaxation)));
            draft(by_own.best_from(most_wanted(relaxation)));
            if (is_within(close, relaxation)) return;
            const double reached = drafts_.empty() ? relaxation.bound() * 2 : drafts_.front().cost.first;
            const double before = relaxation.bound();
            relaxation.tighten(reached, close, 1);
            if (relaxation.bound() <= before * (1 + least_gain) && round > 0) return;
        }
    }

    bool is_within(double gap, const Relaxation& relaxation) const {
        return !drafts_.empty() && drafts_.front().cost.first <= relaxation.bound() * (1 + gap);
    }

    // One more, one less, or one for another, in the best set, while that gains: by what ways are in stock.
    void exchange(const Columns& own, const Columns& columns, const Relaxation& relaxation, Ways& ways) {
        if (is_within(near, relaxation) || drafts_.empty()) return;
        Set others;
        for (const Columns* all : {&own, &columns}) {
            for (std::size_t i = 0; i < all->size(); ++i) {
                Set wished(all->of(i).obstacles);
                std::ranges::sort(wished);
                others = united(others, wished);
            }
        }
        for (std::size_t i = 0; i < own.size() && !choice_.due(); ++i) {
            const bool matters = own.of(i).columns.size() > 1 || columns.of(i).columns.size() > 1;
            ways.stock(i, matters ? united(others, problem_.forced()) : problem_.forced());
        }
        Set best = drafts_.front().set;
        team::Cost least = sorties_->estimate(best);
        std::size_t tries = most_exchanges / plan_.closed.size();
        for (bool gained = true; gained;) {
            gained = false;
            const Set from = best;
            const auto try_out = [&](const Set& set) {
                if (tries == 0 || choice_.due() || !allowed(set)) return;
                --tries;
                const team::Cost cost = sorties_->estimate(set);
                if (!team::better(cost, least)) return;
                least = cost;
                best = set;
                gained = true;
            };
            for (const ObstacleId id : others) {
                if (!contains(from, id)) try_out(united(from, {id}));
            }
            for (const ObstacleId out : from) {
                if (contains(problem_.forced(), out)) continue;
                Set fewer = from;
                std::erase(fewer, out);
                try_out(fewer);
                for (const ObstacleId id : others) {
                    if (!contains(from, id)) try_out(united(fewer, {id}));
                }
            }
            if (gained) draft(best);
        }
    }

    // Of a set with what must be removed.
    bool allowed(const Set& set) const {
        std::size_t count = 0;
        double weight = 0;
        for (const ObstacleId id : set) {
            if (contains(problem_.forced(), id)) continue;
            ++count;
            weight += problem_.map().obstacle(id).weight;
        }
        return count <= std::size_t(problem_.spare_removals()) && weight <= problem_.spare_budget();
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
        double best = infinity;
        for (std::size_t i = 0; i < std::min(drafts_.size(), most_tries); ++i) {
            const Draft& draft = drafts_[i];
            if (draft.cost.first >= best || (best < infinity && interrupts_.due())) break;
            team::Ground ground{OpenedMap(problem_.map(), draft.set)};
            for (const auto& [obstacle, time] : draft.openings) ground.openings.push_back({obstacle, time});
            std::vector<team::Vehicle> vehicles;
            for (std::size_t v = 0; v < plan_.closed.size(); ++v) vehicles.push_back(vehicle(draft, v));
            team::TeamPlan planned =
                team::plan_paths(ground, std::move(vehicles), problem_.rules(), interrupts_, [](const team::Cost&) {});
            if (planned.status != SearchStatus::found) continue;
            Openings begun;
            std::vector<team::Path> flights = sorties_->flights(draft, begun);
            const double reached = objective(planned.paths, flights);
            if (reached >= best) continue;
            best = reached;
            plan_.status = SearchStatus::found;
            plan_.limited = plan_.limited || planned.limited;
            plan_.team = std::move(planned);
            plan_.flights = std::move(flights);
            plan_.breaches = breaches(draft, begun);
            improved(best, std::min(plan_.bound, best));
        }
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
        double sum = 0;
        double last = 0;
        double last_on_ground = 0;
        for (const team::Path& path : paths) {
            sum += path.back().t;
            last_on_ground = std::max(last_on_ground, path.back().t);
        }
        last = last_on_ground;
        for (const team::Path& path : flights) {
            sum += path.back().t;
            last = std::max(last, path.back().t);
        }
        return problem_.objective(sum, last, last_on_ground);
    }

    std::vector<Breach> breaches(const Draft& draft, const Openings& begun) const {
        std::vector<Breach> breaches;
        for (std::size_t a = 0; a < draft.sorties.size(); ++a) {
            for (const Stop& stop : draft.sorties[a]) {
                const Obstacle& obstacle = problem_.map().obstacle(draft.set[stop.target]);
                Breach& breach = breaches.emplace_back();
                breach.obstacle = obstacle.id;
                breach.source_id = obstacle.source_id;
                breach.cells = obstacle.cells;
                breach.at = stop.at;
                breach.by = problem_.aircraft()[a]->id;
                breach.begun_at = begun.at(obstacle.id);
                breach.cleared_at = *breach.begun_at + problem_.breach_time(obstacle.id);
            }
        }
        std::ranges::stable_sort(breaches, {}, &Breach::cleared_at);
        return breaches;
    }

    const team::Interrupts& interrupts_;
    team::Interrupts choice_;
    Problem problem_;
    CrossingSearcher& crossing_;
    Searcher& theta_;
    SortiePlanner* sorties_ = nullptr;
    std::vector<Set> drafted_;
    std::vector<Draft> drafts_;  // the best first
    CoalitionPlan plan_;
};

}  // namespace

CoalitionPlan plan_coalition(const Map& map, const Mission& mission, bool selects, const team::Interrupts& interrupts,
                             CrossingSearcher& crossing, Searcher& theta,
                             const std::function<void(double objective, double bound)>& improved) {
    return Planning(map, mission, interrupts, crossing, theta).run(selects, improved);
}

}  // namespace waybreaker::coalition

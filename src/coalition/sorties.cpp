#include "coalition/sorties.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "coalition/tuning.hpp"
#include "flight/target.hpp"
#include "model/objective.hpp"
#include "schedule/sorties.hpp"

namespace waybreaker::coalition {
Draft SortiePlanner::plan(Set set, const Set& kept, double worth, std::uint64_t enough) {
    const bool thorough = ways_.effort() < enough;
    for (;;) {
        Draft draft = best_for(set);
        if (draft.cost.missing > 0) return draft;
        for (int round = 0;
             round < tuning::most_evaluation_rounds && could_cost(draft) < worth && find_timed_ways(draft, thorough);
             ++round) {
            Draft again = best_for(set);
            if (!team::better(again.cost, draft.cost)) break;
            draft = std::move(again);
        }
        if (thorough) try_all_orders(draft, worth, enough);
        // What nobody drives through costs flights for nothing.
        Set used = kept;
        for (const Way& way : draft.taken) {
            for (const Gate& gate : way.gates) used.push_back(gate.obstacle);
        }
        std::ranges::sort(used);
        used.erase(std::unique(used.begin(), used.end()), used.end());
        if (used.size() == set.size()) return draft;
        set = std::move(used);
    }
}

Draft SortiePlanner::plan_as_own(const Set& set, std::size_t vehicle, const Candidate& own) {
    Draft draft = best_for(set);
    if (!ways_.add(vehicle, set, own.opening.ground.path, workers_.own())) return draft;
    draft = best_for(set);
    Draft as_own = draft;
    as_own.sorties = sorties_of(own, set);
    if (rank(as_own) && team::better(as_own.cost, draft.cost)) {
        fill(as_own);
        draft = std::move(as_own);
    }
    return draft;
}

// In the positions of the set. Empty tours where they do not breach all of it.
Sorties SortiePlanner::sorties_of(const Candidate& candidate, const Set& set) const {
    Sorties sorties(problem_.aircraft().size());
    if (candidate.schedule.breaches.size() != flown_) return sorties;
    std::vector<TimedBreach> breaches = candidate.schedule.breaches;
    std::ranges::stable_sort(breaches, {}, &TimedBreach::cleared_at);
    for (const TimedBreach& breach : breaches) {
        const auto target = std::ranges::lower_bound(set, breach.obstacle) - set.begin();
        sorties[breach.aircraft].push_back({std::size_t(target), breach.at});
    }
    return search().with_landings(std::move(sorties));
}

// Each aircraft flies to the nearest cell each time. The ways for these times are among the others from then on.
void SortiePlanner::try_all_orders(Draft& draft, double worth, std::uint64_t enough) {
    const Set set = draft.set;
    if (set.size() > tuning::most_targets_in_all_orders || could_cost(draft) >= worth) return;
    Draft best = draft;
    Sorties sorties(problem_.aircraft().size());
    const auto give = [&](auto& self, std::size_t first, std::size_t given) -> void {
        if (ways_.effort() >= enough || problem_.interrupts().due()) return;
        if (given == flown_) {
            Draft eager = draft;
            eager.sorties = search().with_landings(sorties);
            fill(eager);
            while (find_timed_ways(eager, true)) {
                prepare(set);
                fill(eager);
            }
            if (rank(eager) && team::better(eager.cost, best.cost)) best = std::move(eager);
            return;
        }
        for (std::size_t a = first; a < sorties.size(); ++a) {
            const Agent& aircraft = *problem_.aircraft()[a];
            if (sorties[a].size() == std::size_t(aircraft.breaches)) continue;
            const Point from = sorties[a].empty() ? aircraft.begin() : Point(sorties[a].back().at);
            for (std::size_t target = 0; target < targets_.size(); ++target) {
                const auto is_target = [&](const Stop& stop) { return stop.target == target; };
                if (problem_.given_opening(targets_[target].obstacle)) continue;
                if (std::ranges::any_of(sorties, [&](const Tour& s) { return std::ranges::any_of(s, is_target); }))
                    continue;
                const auto away = [&](Cell c) { return aircraft.airspace.length(from, c); };
                sorties[a].push_back({target, *std::ranges::min_element(targets_[target].cells, {}, away)});
                self(self, a, given + 1);
                sorties[a].pop_back();
            }
        }
    };
    give(give, 0, 0);
    draft = best_for(set);
    if (team::better(best.cost, draft.cost)) draft = std::move(best);
}

// With no vehicle waiting for any of the set, at least.
double SortiePlanner::could_cost(const Draft& draft) const {
    if (!problem_.sums()) return 0;
    double sum = draft.cost.first;
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        const Agent& agent = *problem_.vehicles()[i];
        double least = infinity;
        for (const Way* way : menus_[i]) least = std::min(least, arrival(agent, *way, {}));
        sum -= agent.weight * (arrival(agent, draft.taken[i], draft.openings) - least);
    }
    return sum;
}

// For those that have to wait, by the times of a draft. Whether there are any.
bool SortiePlanner::find_timed_ways(const Draft& draft, bool thorough) {
    const auto time_of = [&](std::size_t i) {
        return arrival(*problem_.vehicles()[i], draft.taken[i], draft.openings);
    };
    std::vector<std::size_t> late;
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        const auto is_earlier = [&](const Way& other) {
            return arrival(*problem_.vehicles()[i], other, {}) < time_of(i) * (1 - rounding);
        };
        if (std::ranges::any_of(ways_.of(i, draft.set, workers_.own()), is_earlier)) late.push_back(i);
    }
    std::vector<char> found(late.size(), false);
    workers_.for_each(late.size(), [&](std::size_t at, Worker& worker) {
        if (problem_.interrupts().due()) return;
        found[at] = ways_.find_timed(late[at], draft.set, draft.openings, time_of(late[at]), thorough, worker);
    });
    return std::ranges::find(found, true) != found.end();
}

void SortiePlanner::search_ways(const Set& set) {
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < problem_.vehicles().size(); ++i) {
        if (!ways_.knows(i, set)) unknown.push_back(i);
    }
    workers_.for_each(unknown.size(), [&](std::size_t at, Worker& worker) { ways_.of(unknown[at], set, worker); });
}

void SortiePlanner::prepare(const Set& set) {
    search_ways(set);
    const Agent& scout = *problem_.aircraft().front();  // all may fly in the same airspace
    targets_.clear();
    for (const ObstacleId& id : set) {
        // What opens by itself may be out of reach.
        const Airspace air = problem_.given_opening(id) ? Airspace() : scout.airspace;
        targets_.push_back(targets_of(problem_.map(), std::span(&id, 1), air, scout.begin()).front());
    }
    std::vector<std::vector<double>> stays(problem_.aircraft().size());
    for (std::size_t a = 0; a < stays.size(); ++a) {
        for (const ObstacleId id : set) stays[a].push_back(problem_.breach_time(a, id));
    }
    precedence_ = Precedence({problem_.aircraft().begin(), problem_.aircraft().end()}, set.size(), std::move(stays));
    flown_ = 0;
    for (std::size_t target = 0; target < set.size(); ++target) {
        if (const auto at = problem_.given_opening(set[target])) {
            precedence_.open_by_itself(target, *at);
        } else {
            ++flown_;
        }
    }
    const bool waits = problem_.rules().timing != Timing::ignore;
    menus_.clear();
    for (std::size_t i = 0; i < problem_.vehicles().size(); ++i) {
        const Agent& agent = *problem_.vehicles()[i];
        std::vector<const Way*>& menu = menus_.emplace_back();
        std::vector<Drive> drives;
        for (const Way& way : ways_.of(i, set, workers_.own())) {
            menu.push_back(&way);
            Drive& drive = drives.emplace_back(Drive{arrival(agent, way, {})});
            if (!waits) continue;
            for (const Gate& gate : way.gates) {
                const auto target = std::ranges::lower_bound(set, gate.obstacle) - set.begin();
                drive.passages.push_back({std::size_t(target), agent.ready_at + gate.after});
            }
        }
        precedence_.add_vehicle(std::move(drives), agent.weight);
    }
}

Draft SortiePlanner::best_for(const Set& set) {
    prepare(set);
    Draft best;
    best.set = set;
    std::optional<Sorties> sorties = search().find(by_need());
    if (!sorties) return best;
    best.sorties = search().with_landings(std::move(*sorties));
    if (rank(best)) fill(best);
    return best;
}

SortieSearch SortiePlanner::search() const {
    return {problem_.aircraft(), targets_, precedence_, problem_.rules().objective, due_};
}

// What the flights of a draft cost. Whether they end.
bool SortiePlanner::rank(Draft& draft) const {
    const Rank reached = search().rank_of(draft.sorties);
    if (std::isinf(reached.first)) return false;
    draft.cost = {0, reached.first, reached.second};
    return true;
}

// Of a set in time: when its obstacles are gone, and which ways vehicles take.
void SortiePlanner::fill(Draft& draft) const {
    const std::vector<double> cleared = precedence_.cleared(draft.sorties);
    const bool waits = problem_.rules().timing != Timing::ignore;
    draft.openings.clear();
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        draft.openings[targets_[target].obstacle] = waits ? cleared[target] : 0;
    }
    draft.taken.clear();
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        const auto time = [&](const Way* way) { return arrival(*problem_.vehicles()[i], *way, draft.openings); };
        draft.taken.push_back(**std::ranges::min_element(menus_[i], {}, time));
    }
}

// Those first that some vehicle would come to first.
std::vector<std::size_t> SortiePlanner::by_need() const {
    std::map<ObstacleId, double> needed;
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        for (const Way* way : menus_[i]) {
            for (const Gate& gate : way->gates) {
                const double time = problem_.vehicles()[i]->ready_at + gate.after;
                const auto [known, is_new] = needed.emplace(gate.obstacle, time);
                if (!is_new) known->second = std::min(known->second, time);
            }
        }
    }
    const auto need = [&](std::size_t target) {
        const auto found = needed.find(targets_[target].obstacle);
        return found == needed.end() ? infinity : found->second;
    };
    std::vector<std::size_t> order(targets_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t t) { return problem_.given_opening(targets_[t].obstacle).has_value(); });
    std::ranges::stable_sort(order, {}, need);
    return order;
}

}  // namespace waybreaker::coalition

#include "coalition/sorties.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flight/target.hpp"

namespace waybreaker::coalition {
namespace {

constexpr std::size_t few_targets = 4;  // all orders of inserting them are tried
constexpr int most_rounds = 4;          // of ways for the times of sorties, and sorties for these ways

double flying(const Agent& aircraft, Cell from, Cell to) {
    return distance(from, to) / aircraft.speed;
}

}  // namespace

Draft SortiePlanner::plan(Set set, double worth) {
    for (;;) {
        Draft draft = best_for(set);
        if (draft.cost.missing > 0) return draft;
        for (int round = 0; round < most_rounds && could_cost(draft) < worth && find_timed_ways(draft); ++round) {
            Draft again = best_for(set);
            if (!team::better(again.cost, draft.cost)) break;
            draft = std::move(again);
        }
        // What nobody drives through costs flights for nothing.
        Set used = problem_.forced();
        for (const Way& way : draft.taken) {
            for (const Gate& gate : way.gates) used.push_back(gate.obstacle);
        }
        std::ranges::sort(used);
        const auto repeated = std::ranges::unique(used);
        used.erase(repeated.begin(), repeated.end());
        if (used.size() == set.size()) return draft;
        set = std::move(used);
    }
}

// With no vehicle waiting for any of the set, at least.
double SortiePlanner::could_cost(const Draft& draft) const {
    if (!problem_.sums()) return 0;
    double sum = draft.cost.first;
    for (std::size_t i = 0; i < menus_.size(); ++i) {
        const Agent& agent = *problem_.vehicles()[i];
        double least = infinity;
        for (const Way* way : menus_[i]) least = std::min(least, arrival(agent, *way, {}));
        sum -= arrival(agent, draft.taken[i], draft.openings) - least;
    }
    return sum;
}

// For those that have to wait, by the times of a draft. Whether there are any.
bool SortiePlanner::find_timed_ways(const Draft& draft) {
    bool any = false;
    for (std::size_t i = 0; i < menus_.size() && !problem_.interrupts().due(); ++i) {
        const Agent& agent = *problem_.vehicles()[i];
        const double time = arrival(agent, draft.taken[i], draft.openings);
        const bool could_gain = std::ranges::any_of(
            ways_.of(i, draft.set), [&](const Way& other) { return arrival(agent, other, {}) < time * (1 - 1e-9); });
        any = (could_gain && ways_.find_timed(i, draft.set, draft.openings, time)) || any;
    }
    return any;
}

void SortiePlanner::prepare(const Set& set) {
    targets_.clear();
    for (waybreaker::Target& target : targets_of(problem_.map(), set)) {
        targets_.push_back({target.obstacle, std::move(target.cells), problem_.breach_time(target.obstacle)});
    }
    menus_.clear();
    options_.clear();
    others_sum_ = 0;
    others_last_ = 0;
    for (std::size_t i = 0; i < problem_.vehicles().size(); ++i) {
        std::vector<const Way*>& menu = menus_.emplace_back();
        for (const Way& way : ways_.of(i, set)) menu.push_back(&way);
        std::vector<Option> options;
        for (const Way* way : menu) {
            Option& option = options.emplace_back();
            option.arrival = arrival(*problem_.vehicles()[i], *way, {});
            for (const Gate& gate : way->gates) {
                const auto target = std::ranges::lower_bound(set, gate.obstacle);
                option.gates.emplace_back(target - set.begin(), problem_.vehicles()[i]->ready_at + gate.after);
            }
        }
        if (options.size() == 1 && options.front().gates.empty()) {
            others_sum_ += options.front().arrival;
            others_last_ = std::max(others_last_, options.front().arrival);
        } else {
            options_.push_back(std::move(options));
        }
    }
}

Draft SortiePlanner::best_for(const Set& set) {
    prepare(set);
    Draft best;
    best.set = set;
    const auto consider = [&](const std::vector<std::size_t>& order) {
        std::vector<Sortie> sorties(problem_.aircraft().size());
        for (const std::size_t target : order) {
            if (!insert(sorties, target)) return;
        }
        const team::Cost cost = cost_of(sorties);
        if (!best.sorties.empty() && !team::better(cost, best.cost)) return;
        best.cost = cost;
        best.sorties = std::move(sorties);
    };
    std::vector<std::size_t> order = by_need();
    consider(order);
    if (targets_.size() <= few_targets) {
        std::ranges::sort(order);
        do {
            consider(order);
        } while (!problem_.interrupts().due() && std::ranges::next_permutation(order).found);
    }
    if (best.sorties.empty() || best.cost.missing > 0) return best;
    improve(best.sorties);
    best.cost = cost_of(best.sorties);
    fill(best);
    return best;
}

// When each target is gone; those without a stop at the end of time.
std::vector<double> SortiePlanner::openings_of(const std::vector<Sortie>& sorties) const {
    constexpr double never = 1e15;
    std::vector<double> openings(targets_.size(), never);
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        const Agent& aircraft = *problem_.aircraft()[a];
        double time = 0;
        Cell at = aircraft.start;
        for (const Stop& stop : sorties[a]) {
            time += flying(aircraft, at, stop.at) + targets_[stop.target].stay;
            openings[stop.target] = time;
            at = stop.at;
        }
    }
    if (problem_.rules().timing == Timing::ignore) openings.assign(targets_.size(), 0);
    return openings;
}

// Of a set in time: when its obstacles are gone, and which ways vehicles take.
void SortiePlanner::fill(Draft& draft) const {
    const std::vector<double> openings = openings_of(draft.sorties);
    draft.openings.clear();
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        draft.openings[targets_[target].obstacle] = openings[target];
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
    std::ranges::stable_sort(order, {}, need);
    return order;
}

team::Cost SortiePlanner::cost_of(const std::vector<Sortie>& sorties) const {
    const std::vector<double> openings = openings_of(sorties);
    double sum = others_sum_;
    double last_on_ground = others_last_;
    for (const std::vector<Option>& options : options_) {
        double least = infinity;
        for (const Option& option : options) {
            double delay = 0;
            for (const auto& [target, needed] : option.gates) delay = std::max(delay, openings[target] - needed);
            least = std::min(least, option.arrival + delay);
        }
        if (std::isinf(least)) return {1, infinity, infinity};
        sum += least;
        last_on_ground = std::max(last_on_ground, least);
    }
    double last = last_on_ground;
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        const Agent& aircraft = *problem_.aircraft()[a];
        double time = 0;
        Cell at = aircraft.start;
        for (const Stop& stop : sorties[a]) {
            time += flying(aircraft, at, stop.at) + targets_[stop.target].stay;
            at = stop.at;
        }
        time += flying(aircraft, at, aircraft.goal);
        sum += time;
        last = std::max(last, time);
    }
    switch (problem_.rules().objective) {
        case Objective::makespan:
            return {0, last, sum};
        case Objective::flowtime:
            return {0, sum, last};
        case Objective::ground_makespan:
            break;
    }
    return {0, last_on_ground, sum};
}

// Where a stop may be: nearest to where the aircraft comes from, and with the least detour.
std::vector<Cell> SortiePlanner::likely_cells(const Target& target, const Agent& aircraft, const Sortie& sortie,
                                              std::size_t at) {
    const Cell before = at > 0 ? sortie[at - 1].at : aircraft.start;
    const Cell after = at < sortie.size() ? sortie[at].at : aircraft.goal;
    const auto nearest = std::ranges::min_element(target.cells, {}, [&](Cell c) { return distance(before, c); });
    const auto on_way =
        std::ranges::min_element(target.cells, {}, [&](Cell c) { return distance(before, c) + distance(c, after); });
    if (*nearest == *on_way) return {*nearest};
    return {*nearest, *on_way};
}

// Gives a target to the aircraft, and puts it in the place, where it costs least. False if no aircraft may breach more.
bool SortiePlanner::insert(std::vector<Sortie>& sorties, std::size_t target) const {
    team::Cost least{.missing = 2, .first = infinity, .second = infinity};
    std::vector<Sortie> best;
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        const Agent& aircraft = *problem_.aircraft()[a];
        if (sorties[a].size() >= std::size_t(aircraft.breaches)) continue;
        for (std::size_t at = 0; at <= sorties[a].size(); ++at) {
            for (const Cell cell : likely_cells(targets_[target], aircraft, sorties[a], at)) {
                std::vector<Sortie> changed = sorties;
                changed[a].insert(changed[a].begin() + std::ptrdiff_t(at), {target, cell});
                const team::Cost cost = cost_of(changed);
                if (!best.empty() && !team::better(cost, least)) continue;
                least = cost;
                best = std::move(changed);
            }
        }
    }
    if (best.empty()) return false;
    sorties = std::move(best);
    return true;
}

void SortiePlanner::improve(std::vector<Sortie>& sorties) const {
    team::Cost least = cost_of(sorties);
    while (!problem_.interrupts().due() && (exchange_cells(sorties, least) || move_one(sorties, least))) {
    }
}

bool SortiePlanner::move_one(std::vector<Sortie>& sorties, team::Cost& least) const {
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        std::vector<Sortie> changed = sorties;
        for (Sortie& sortie : changed) {
            std::erase_if(sortie, [&](const Stop& stop) { return stop.target == target; });
        }
        if (!insert(changed, target)) continue;
        const team::Cost cost = cost_of(changed);
        if (!team::better(cost, least)) continue;
        least = cost;
        sorties = std::move(changed);
        return true;
    }
    return false;
}

bool SortiePlanner::exchange_cells(std::vector<Sortie>& sorties, team::Cost& least) const {
    bool any = false;
    for (Sortie& sortie : sorties) {
        for (Stop& stop : sortie) {
            Cell best = stop.at;
            for (const Cell cell : targets_[stop.target].cells) {
                stop.at = cell;
                const team::Cost cost = cost_of(sorties);
                if (!team::better(cost, least)) continue;
                least = cost;
                best = cell;
                any = true;
            }
            stop.at = best;
        }
    }
    return any;
}

std::vector<team::Path> SortiePlanner::flights(const Draft& draft, Openings& begun) const {
    std::vector<team::Path> flights;
    for (std::size_t a = 0; a < draft.sorties.size(); ++a) {
        const Agent& aircraft = *problem_.aircraft()[a];
        team::Path& path = flights.emplace_back();
        path.push_back({double(aircraft.start.x), double(aircraft.start.y), 0});
        const auto fly_to = [&](Cell to) {
            const Waypoint from = path.back();
            path.push_back({double(to.x), double(to.y), from.t + distance(Point(from.x, from.y), to) / aircraft.speed});
        };
        for (const Stop& stop : draft.sorties[a]) {
            fly_to(stop.at);
            const ObstacleId obstacle = draft.set[stop.target];
            begun[obstacle] = path.back().t;
            const double stay = problem_.breach_time(obstacle);
            if (stay > 0) path.push_back({path.back().x, path.back().y, path.back().t + stay});
        }
        fly_to(aircraft.goal);
    }
    return flights;
}

}  // namespace waybreaker::coalition

#include "schedule/sorties.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "flight/exact.hpp"
#include "schedule/landings.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t few_targets = 4;      // all orders of inserting them are tried
constexpr double most_ways_to_share = 256;  // of targets among aircraft that may not fly far

// Where a stop may be: nearest to where the aircraft comes from, and with the least detour.
std::vector<Cell> likely_cells(const Target& target, const Agent& aircraft, const Tour& tour, std::size_t at) {
    const Point before = at > 0 ? Point(tour[at - 1].at) : aircraft.begin();
    const Point after = at < tour.size() ? tour[at].at : aircraft.goal;
    Cell nearest;
    Cell on_way;
    double least = infinity;
    double least_by = infinity;
    for (const Cell c : target.cells) {
        const double there = aircraft.airspace.length(before, c);
        const double by = there + aircraft.airspace.length(c, after);
        if (there < least) {
            least = there;
            nearest = c;
        }
        if (by < least_by) {
            least_by = by;
            on_way = c;
        }
    }
    if (nearest == on_way) return {nearest};
    return {nearest, on_way};
}

}  // namespace

bool is_better(const Rank& a, const Rank& b) {
    const auto less = [](double x, double y) { return x < (y < infinity ? y - 1e-9 * std::max(y, 1.0) : y); };
    if (less(a.first, b.first)) return true;
    return !less(b.first, a.first) && less(a.second, b.second);
}

Rank SortieSearch::rank_as_given(const Sorties& sorties) const {
    return rank(objective_, precedence_.finish(sorties));
}

Rank SortieSearch::rank_of(const Sorties& sorties) const {
    return recharge_ ? rank_as_given(with_landings(sorties)) : rank_as_given(sorties);
}

Sorties SortieSearch::with_landings(Sorties sorties) const {
    if (!recharge_) return sorties;
    std::vector<std::vector<Tour>> tours(sorties.size());
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        if (!aircraft_[a]->recharge || std::ranges::any_of(sorties[a], &Stop::lands)) continue;
        tours[a] = waybreaker::with_landings(*aircraft_[a], sorties[a],
                                             [&](std::size_t target) { return precedence_.stay(a, target); });
        if (!tours[a].empty()) sorties[a] = tours[a].front();
    }
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        if (tours[a].size() < 2) continue;
        Rank least = rank_as_given(sorties);
        for (Tour& tour : tours[a]) {
            std::swap(sorties[a], tour);
            const Rank reached = rank_as_given(sorties);
            if (is_better(reached, least)) {
                least = reached;
            } else {
                std::swap(sorties[a], tour);
            }
        }
    }
    return sorties;
}

std::optional<Sorties> SortieSearch::find(std::vector<std::size_t> order) const {
    std::optional<Sorties> best;
    Rank least;
    const auto consider = [&] {
        Sorties sorties(aircraft_.size());
        for (const std::size_t target : order) {
            if (!insert(sorties, target)) return;
        }
        const Rank reached = rank_of(sorties);
        if (best && !is_better(reached, least)) return;
        least = reached;
        best = std::move(sorties);
    };
    consider();
    if (order.size() <= few_targets) {
        std::ranges::sort(order);
        do {
            consider();
        } while (!due_() && std::ranges::next_permutation(order).found);
    }
    if (best && std::isinf(least.first)) best = shared_out(order).value_or(*best);
    if (best) improve(*best);
    return best;
}

// Where aircraft may not fly far, perhaps only some ways to share few targets out are possible, with the shortest
// tours: the best of all ways, each aircraft flying so. None where none is possible, or they are too many.
std::optional<Sorties> SortieSearch::shared_out(const std::vector<std::size_t>& order) const {
    const double ways = std::pow(double(aircraft_.size()), double(order.size()));
    if (order.size() > exact_flight_limit || ways > most_ways_to_share) return std::nullopt;
    std::map<std::pair<std::size_t, std::vector<std::size_t>>, Tour> known;
    std::optional<Sorties> best;
    Rank least{infinity, infinity};
    std::vector<std::size_t> owner(order.size(), 0);
    for (std::size_t way = 0; way < std::size_t(ways) && !due_(); ++way) {
        Sorties sorties;
        for (std::size_t a = 0; a < aircraft_.size(); ++a) {
            std::vector<std::size_t> share;
            for (std::size_t i = 0; i < order.size(); ++i) {
                if (owner[i] == a) share.push_back(order[i]);
            }
            const auto may = [&](std::size_t target) { return precedence_.may_breach(a, target); };
            if (share.size() > std::size_t(aircraft_[a]->breaches) || !std::ranges::all_of(share, may)) break;
            const auto [tour, is_new] = known.try_emplace({a, share});
            if (is_new) tour->second = shortest(a, share);
            sorties.push_back(tour->second);
        }
        for (std::size_t i = 0; i < owner.size() && ++owner[i] == aircraft_.size(); ++i) owner[i] = 0;
        if (sorties.size() < aircraft_.size()) continue;
        const Rank reached = rank_of(sorties);
        if (std::isinf(reached.first) || !is_better(reached, least)) continue;
        least = reached;
        best = std::move(sorties);
    }
    return best;
}

Tour SortieSearch::shortest(std::size_t aircraft, const std::vector<std::size_t>& share) const {
    const Agent& agent = *aircraft_[aircraft];
    if (agent.recharge) return shortest_with_landings(aircraft, share);
    std::vector<Target> targets;
    Tour known;
    for (const std::size_t target : share) {
        known.push_back({targets.size(), targets_[target].cells.front()});
        targets.push_back(targets_[target]);
    }
    Tour tour = shortest_tour(agent.begin(), agent.goal, targets, known, agent.airspace);
    for (Stop& stop : tour) stop.target = share[stop.target];
    return tour;
}

// Without the landings, with which it is home first: in any order of few targets. Perhaps only some cells are possible.
Tour SortieSearch::shortest_with_landings(std::size_t aircraft, std::vector<std::size_t> share) const {
    const Agent& agent = *aircraft_[aircraft];
    const auto stay = [&](std::size_t target) { return precedence_.stay(aircraft, target); };
    Tour best;
    for (const std::size_t target : share) best.push_back({target, targets_[target].cells.front()});
    double least = infinity;
    std::ranges::sort(share);
    do {
        std::vector<Visit> visits;
        for (const std::size_t target : share) visits.push_back({target, targets_[target].cells});
        std::vector<Tour> tours = waybreaker::with_landings(agent, visits, stay);
        if (tours.empty()) continue;
        const double home = fly(agent, tours.front(), stay, [](const Stop&, double, double) {});
        if (home >= least) continue;
        least = home;
        best = std::move(tours.front());
    } while (share.size() <= few_targets && !due_() && std::ranges::next_permutation(share).found);
    std::erase_if(best, [](const Stop& stop) { return stop.lands(); });
    return best;
}

// Gives a target to the aircraft, and puts it in the place, where it costs least. False if no aircraft may breach more.
bool SortieSearch::insert(Sorties& sorties, std::size_t target) const {
    Rank least;
    Sorties best;
    for (std::size_t a = 0; a < sorties.size(); ++a) {
        const Agent& aircraft = *aircraft_[a];
        if (sorties[a].size() >= std::size_t(aircraft.breaches) || !precedence_.may_breach(a, target)) continue;
        for (std::size_t at = 0; at <= sorties[a].size(); ++at) {
            for (const Cell cell : likely_cells(targets_[target], aircraft, sorties[a], at)) {
                Sorties changed = sorties;
                changed[a].insert(changed[a].begin() + std::ptrdiff_t(at), {target, cell});
                const Rank reached = rank_of(changed);
                if (!best.empty() && !is_better(reached, least)) continue;
                least = reached;
                best = std::move(changed);
            }
        }
    }
    if (best.empty()) return false;
    sorties = std::move(best);
    return true;
}

void SortieSearch::improve(Sorties& sorties) const {
    Rank least = rank_of(sorties);
    while (!due_() && (exchange_cells(sorties, least) || move_one(sorties, least))) {
    }
}

bool SortieSearch::move_one(Sorties& sorties, Rank& least) const {
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        Sorties changed = sorties;
        std::size_t taken = 0;
        for (Tour& tour : changed) {
            taken += std::erase_if(tour, [&](const Stop& stop) { return stop.target == target; });
        }
        if (taken == 0) continue;  // it opens by itself
        if (!insert(changed, target)) continue;
        const Rank reached = rank_of(changed);
        if (!is_better(reached, least)) continue;
        least = reached;
        sorties = std::move(changed);
        return true;
    }
    return false;
}

bool SortieSearch::exchange_cells(Sorties& sorties, Rank& least) const {
    bool any = false;
    for (Tour& tour : sorties) {
        for (Stop& stop : tour) {
            Cell best = stop.at;
            for (const Cell cell : targets_[stop.target].cells) {
                stop.at = cell;
                const Rank reached = rank_of(sorties);
                if (!is_better(reached, least)) continue;
                least = reached;
                best = cell;
                any = true;
            }
            stop.at = best;
        }
    }
    return any;
}

}  // namespace waybreaker

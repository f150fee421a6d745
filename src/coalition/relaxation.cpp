#include "coalition/relaxation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

#include "coalition/tuning.hpp"
#include "model/objective.hpp"

namespace waybreaker::coalition {
namespace {

// The nearest point with no negative coordinate whose coordinates add up to 1 (Duchi and others 2008).
void project_to_simplex(std::vector<double>& weights) {
    std::vector<double> sorted = weights;
    std::ranges::sort(sorted, std::greater<>());
    double sum = 0;
    double shift = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sum += sorted[i];
        const double next = (sum - 1) / double(i + 1);
        if (sorted[i] > next) shift = next;
    }
    for (double& weight : weights) weight = std::max(weight - shift, 0.0);
}

double squared_length(const std::vector<double>& weights, const std::vector<std::vector<double>>& prices) {
    double sum = 0;
    for (const double part : weights) sum += part * part;
    for (const std::vector<double>& parts : prices) {
        for (const double part : parts) sum += part * part;
    }
    return sum;
}

}  // namespace

Relaxation::Relaxation(const Problem& problem, Columns& columns, Workers& workers)
    : problem_(problem), columns_(columns), workers_(workers) {
    const std::size_t vehicles = columns.size();
    for (std::size_t i = 0; i < vehicles; ++i) best_.weights.push_back(problem.sums() ? problem.weight(i) : 0);
    best_.prices.resize(vehicles);
    centre_ = best_;
    number_obstacles();
    double sum = 0;
    double last = 0;
    std::size_t latest = 0;
    for (std::size_t i = 0; i < vehicles; ++i) {
        sum += weighted(problem.weight(i), columns.of(i).least);
        if (columns.of(i).least > last) latest = i;
        last = std::max(last, columns.of(i).least);
    }
    if (!problem.sums()) best_.weights[latest] = centre_.weights[latest] = 1;
    bound_ = problem.sums() ? sum + fixed() : std::max(last, fixed());
}

// What every plan costs beside its vehicles.
double Relaxation::fixed() const {
    double sum = 0;
    double last = 0;
    for (const Agent* agent : problem_.aircraft()) {
        sum += agent->weight * Problem::straight_flight(*agent);
        last = std::max(last, Problem::straight_flight(*agent));
    }
    for (const ObstacleId id : problem_.forced()) {
        sum += problem_.weighted_breach_time(id);
        if (problem_.rules().timing == Timing::enforce) last = std::max(last, problem_.earliest_return(id));
    }
    return problem_.objective(sum, last, 0);
}

void Relaxation::number_obstacles() {
    numbers_.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::vector<ObstacleId>& obstacles = columns_.of(i).obstacles;
        for (std::size_t at = numbers_[i].size(); at < obstacles.size(); ++at) {
            const auto [known, is_new] = number_of_.try_emplace(obstacles[at], std::uint32_t(numbered_.size()));
            if (is_new) {
                numbered_.push_back(obstacles[at]);
                detours_.push_back(problem_.sums() ? problem_.least_detour(obstacles[at]) : 0);
            }
            numbers_[i].push_back(known->second);
        }
        for (Prices* all : {&best_, &centre_}) all->prices[i].resize(obstacles.size(), 0);
    }
}

// What all pay for the obstacles that are known.
Offers Relaxation::offers(const Prices& at) const {
    std::vector<Offer> offers;
    for (std::size_t j = 0; j < numbered_.size(); ++j) {
        const double breach = problem_.sums() ? problem_.weighted_breach_time(numbered_[j]) : 0;
        offers.push_back({numbered_[j], -breach, detours_[j]});
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        for (std::size_t k = 0; k < at.prices[i].size(); ++k) offers[numbers_[i][k]].paid += at.prices[i][k];
    }
    return Offers(std::move(offers));
}

// No set that may be removed is paid better; marks those of such a set.
double Relaxation::best_paid(const Offers& offers, std::vector<ObstacleId>& chosen) const {
    const double by_count = offers.best(std::size_t(problem_.spare_removals()), 0, {}, &chosen);
    if (std::isinf(problem_.spare_budget())) return by_count;
    std::vector<ObstacleId> within;
    const double by_weight = offers.best_by_weight(problem_.map(), problem_.spare_budget(), within);
    if (by_weight < by_count) chosen = std::move(within);
    return std::min(by_count, by_weight);
}

// What vehicles take at these prices, and what is chosen for what they pay: on the known columns.
Relaxation::Answer Relaxation::answer(const Prices& at) const {
    Answer answer;
    std::vector<ObstacleId> chosen;
    answer.value = (problem_.sums() ? fixed() : 0) - best_paid(offers(at), chosen);
    answer.chosen.assign(numbered_.size(), 0);
    for (const ObstacleId id : chosen) answer.chosen[number_of_.at(id)] = 1;
    answer.taken.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (is_left_out(at.weights[i])) continue;
        const Cheapest one = cheapest(columns_.of(i), at.weights[i], at.prices[i]);
        answer.value += one.cost;
        answer.taken[i] = one.column;
    }
    return answer;
}

// The subgradient. Of a price: whether the vehicle takes the obstacle, less whether it is chosen. Of a weight, for a
// maximum: how much later than the mean the vehicle arrives, in parts of `scale`.
Relaxation::Prices Relaxation::direction(const Prices& at, const Answer& answer, double scale) const {
    Prices way;
    way.prices.resize(columns_.size());
    way.weights.assign(columns_.size(), 0);
    double mean = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        std::vector<double>& prices = way.prices[i];
        const Column& taken = columns_.of(i).columns[answer.taken[i]];
        prices.assign(at.prices[i].size(), 0);
        for (std::size_t k = 0; k < prices.size(); ++k) prices[k] -= answer.chosen[numbers_[i][k]];
        if (!is_left_out(at.weights[i])) {
            for (const std::uint32_t k : taken.opened) prices[k] += 1;
        }
        for (std::size_t k = 0; k < prices.size(); ++k) {
            if (at.prices[i][k] <= 0) prices[k] = std::max(prices[k], 0.0);
        }
        way.weights[i] = std::isinf(taken.arrival) ? 1 : taken.arrival / scale;
        mean += way.weights[i] / double(columns_.size());
    }
    for (double& weight : way.weights) weight = problem_.sums() ? 0 : weight - mean;
    return way;
}

// Subgradient steps (Polyak 1969) on the known columns; the best prices stay.
void Relaxation::ascend(double reached) {
    const double scale = std::max(reached, 1e-9);
    Prices at = best_;
    double best = -infinity;
    double share = 1;
    int failures = 0;
    for (int step = 0; step < tuning::most_subgradient_steps && share > tuning::least_step_length; ++step) {
        const Answer known = answer(at);
        if (known.value > best + tuning::least_gain_of_step * share * scale) {
            best = known.value;
            best_ = at;
            failures = 0;
        } else if (++failures == tuning::steps_before_halving) {
            share /= 2;
            failures = 0;
            at = best_;
            continue;
        }
        const double missing = reached - known.value;
        const Prices way = direction(at, known, scale);
        const double norm = squared_length(way.weights, way.prices);
        if (missing <= 1e-9 * scale || norm == 0) return;
        const double length = share * missing / norm;
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            for (std::size_t k = 0; k < at.prices[i].size(); ++k) {
                at.prices[i][k] = std::max(at.prices[i][k] + length * way.prices[i][k], 0.0);
            }
            at.weights[i] += length / scale * way.weights[i];
        }
        if (!problem_.sums()) project_to_simplex(at.weights);
    }
}

// The prices of one vehicle, by id. Obstacles that it does not know of cost what they are offered.
std::vector<double> Relaxation::prices_of(std::size_t vehicle, const Prices& at,
                                          const std::vector<double>& free) const {
    std::vector<double> prices(free.size(), 0);
    for (const Obstacle& obstacle : problem_.map().obstacles())
        prices[obstacle.id.value] = free[obstacle.id.value] * claim(vehicle, at.weights[vehicle], obstacle);
    for (std::size_t k = 0; k < at.prices[vehicle].size(); ++k) {
        prices[columns_.of(vehicle).obstacles[k].value] = at.prices[vehicle][k];
    }
    return prices;
}

// How an obstacle that a vehicle does not know of is charged, beside other vehicles: all that may gain alike. Where
// they do not collide some may gain far more than others, as who has no way at all: each by what it may gain at most.
double Relaxation::claim(std::size_t vehicle, double weight, const Obstacle& obstacle) const {
    if (problem_.rules().collisions) return columns_.may_gain(vehicle, obstacle) ? 1 : 0;
    return weight * columns_.most_gain(vehicle, obstacle);
}

// What vehicles that do not know of an obstacle, and may gain by it, can be charged without the bound losing by it: so
// searches look for what would gain. By id, for each unit of their claims. And what all pay then.
std::vector<double> Relaxation::offer_all(const Prices& at) {
    const std::size_t ids = problem_.map().obstacles().size() + 1;
    const FreeOffers free(offers(at), std::size_t(problem_.spare_removals()));
    std::vector<double> paid(ids, 0);
    std::vector<double> claims(ids, 0);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (at.weights[i] == 0) continue;
        std::vector<char> known(ids, 0);
        for (std::size_t k = 0; k < at.prices[i].size(); ++k) {
            const ObstacleId id = columns_.of(i).obstacles[k];
            paid[id.value] += at.prices[i][k];
            known[id.value] = 1;
        }
        for (const Obstacle& obstacle : problem_.map().obstacles()) {
            if (known[obstacle.id.value] == 0) claims[obstacle.id.value] += claim(i, at.weights[i], obstacle);
        }
    }
    const double most = problem_.rules().collisions ? infinity : 1;  // who pays all that it may gain, gains nothing
    std::vector<double> shares(ids, 0);
    std::vector<Offer> all;
    for (const Obstacle& obstacle : problem_.map().obstacles()) {
        const std::uint32_t id = obstacle.id.value;
        const auto number = number_of_.find(obstacle.id);
        double detour = number == number_of_.end() ? problem_.short_detour(obstacle.id) : detours_[number->second];
        if (!problem_.sums()) detour = 0;
        if (problem_.sums()) paid[id] -= problem_.weighted_breach_time(obstacle.id);
        if (claims[id] > 0 && std::isinf(problem_.spare_budget())) {
            const double more = std::min(std::max(free.of(detour) - paid[id], 0.0), most * claims[id]);
            shares[id] = more / claims[id];
            paid[id] += more;
        }
        all.push_back({obstacle.id, paid[id], detour});
    }
    proof_ = {problem_.sums() ? fixed() : 0, at.weights};
    proof_.sums = std::move(paid);
    proof_.offers = Offers(std::move(all));
    return shares;
}

// Searches at certain prices: for the best columns, or with a margin for all that cost up to so much more. Whether that
// has raised the bound or found new columns.
bool Relaxation::prove(Prices at, std::optional<double> margin) {
    for (double& weight : at.weights) weight = is_left_out(weight) ? 0 : weight;
    const std::vector<double> shares = offer_all(at);
    std::vector<ObstacleId> chosen;
    proof_.searches.resize(columns_.size());
    std::vector<char> found(columns_.size(), false);
    std::atomic<bool> due = false;
    workers_.for_each(columns_.size(), [&](std::size_t i, Worker& worker) {
        const double weight = at.weights[i];
        if (weight == 0 || due) return;
        if (problem_.interrupts().due()) {
            due = true;
            return;
        }
        std::vector<double> prices = prices_of(i, at, shares);
        for (double& price : prices) price /= weight;
        const std::size_t before = columns_.of(i).columns.size();
        const Columns::Search search =
            margin ? columns_.list(i, prices, *margin / weight, worker) : columns_.search(i, prices, worker);
        proof_.searches[i] = {search.least * weight, search.complete_below * weight};
        found[i] = columns_.of(i).columns.size() > before;
        // Those that are new keep the price that they were found at.
        for (std::size_t k = at.prices[i].size(); k < columns_.of(i).obstacles.size(); ++k) {
            const double price = prices[columns_.of(i).obstacles[k].value] * weight;
            for (Prices* all : {&at, &best_, &centre_}) all->prices[i].push_back(price);
        }
    });
    number_obstacles();
    if (due) return false;
    double value = proof_.fixed - best_paid(proof_.offers, chosen);
    for (const Columns::Search& search : proof_.searches) value += search.least;
    proof_.prices = at.prices;
    proof_.bound = value;
    proof_.complete = true;
    const bool gained = value > bound_;
    if (gained) {
        bound_ = value;
        centre_ = std::move(at);
    }
    return gained || std::ranges::find(found, true) != found.end();
}

// Between the best prices that are proven and those that look best on what is known: the latter may be far off.
bool Relaxation::tighten(double reached) {
    ascend(reached);
    Prices at = centre_;
    const auto approach = [](double& from, double to) { from += tuning::smoothing * (to - from); };
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        approach(at.weights[i], best_.weights[i]);
        for (std::size_t k = 0; k < at.prices[i].size(); ++k) approach(at.prices[i][k], best_.prices[i][k]);
    }
    // In the sum of many one column more of a vehicle hardly matters.
    if (problem_.sums() && columns_.size() > tuning::most_vehicles_with_margin) return prove(at);
    return prove(at, tuning::margin_of_round * reached / double(columns_.size()));
}

double Relaxation::bound_with(std::size_t removals) const {
    if (!proof_.complete) return bound_;
    double value = proof_.fixed - proof_.offers.best(removals);
    for (const Columns::Search& search : proof_.searches) value += search.least;
    return std::max(value, bound_);
}

std::vector<ObstacleId> Relaxation::wanted() const {
    std::vector<Offer> order = offers(best_).all();
    std::ranges::stable_sort(order, [](const Offer& a, const Offer& b) { return a.paid > b.paid; });
    std::vector<ObstacleId> wanted;
    for (const Offer& offer : order) wanted.push_back(offer.obstacle);
    return wanted;
}

}  // namespace waybreaker::coalition

#include "coalition/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace waybreaker::coalition {
namespace {

constexpr int steps_between_searches = 300;
constexpr int patience = 12;          // steps without gain before they are halved
constexpr double least_share = 1e-4;  // of the way to what is reached
constexpr double least_gain = 1e-6;   // of such a share
constexpr double least_weight_of_vehicle = 1e-6;

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

Relaxation::Relaxation(const Problem& problem, Columns& columns) : problem_(problem), columns_(columns) {
    const std::size_t vehicles = columns.size();
    best_.weights.assign(vehicles, problem.sums() ? 1 : 0);
    best_.prices.resize(vehicles);
    number_obstacles();
    double sum = 0;
    double last = 0;
    std::size_t latest = 0;
    for (std::size_t i = 0; i < vehicles; ++i) {
        sum += columns.of(i).least;
        if (columns.of(i).least > last) latest = i;
        last = std::max(last, columns.of(i).least);
    }
    if (!problem.sums()) best_.weights[latest] = 1;
    bound_ = problem.sums() ? sum + fixed() : std::max(last, fixed());
}

// What every plan costs beside its vehicles.
double Relaxation::fixed() const {
    double sum = 0;
    double last = 0;
    for (const Agent* agent : problem_.aircraft()) {
        sum += Problem::straight_flight(*agent);
        last = std::max(last, Problem::straight_flight(*agent));
    }
    for (const ObstacleId id : problem_.forced()) {
        sum += problem_.breach_time(id);
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
        best_.prices[i].resize(obstacles.size(), 0);
    }
    by_detour_.resize(numbered_.size());
    std::iota(by_detour_.begin(), by_detour_.end(), 0U);
    std::ranges::stable_sort(by_detour_, {}, [&](std::uint32_t j) { return detours_[j]; });
}

// What all pay for each obstacle, less what its breach costs in any case.
void Relaxation::sum_for(const Prices& at, std::vector<double>& sums) const {
    sums.assign(numbered_.size(), 0);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        for (std::size_t k = 0; k < at.prices[i].size(); ++k) sums[numbers_[i][k]] += at.prices[i][k];
    }
    if (!problem_.sums()) return;
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] -= problem_.breach_time(numbered_[j]);
}

// No set that may be removed has more paid for it, less the longest detour of its obstacles where flights count; marks
// those of such a set. Of the sets with no longer detour the best holds those that most is paid for.
double Relaxation::dearest(const std::vector<double>& sums, std::vector<char>& chosen) const {
    const std::size_t most = std::size_t(problem_.spare_removals());
    const auto less_paid = [&](std::uint32_t a, std::uint32_t b) {
        return sums[a] != sums[b] ? sums[a] > sums[b] : a < b;
    };
    std::vector<std::uint32_t> best;  // heap: what least is paid for on top
    double paid = 0;
    double by_count = 0;
    std::size_t last = 0;  // in order of detour
    for (std::size_t k = 0; k < by_detour_.size() && most > 0; ++k) {
        const std::uint32_t j = by_detour_[k];
        if (sums[j] <= 0) continue;
        if (best.size() == most) {
            if (!less_paid(j, best.front())) continue;
            paid -= sums[best.front()];
            std::ranges::pop_heap(best, less_paid);
            best.pop_back();
        }
        paid += sums[j];
        best.push_back(j);
        std::ranges::push_heap(best, less_paid);
        if (paid - detours_[j] <= by_count) continue;
        by_count = paid - detours_[j];
        last = k + 1;
    }
    mark_most_paid(sums, last, chosen);
    if (std::isinf(problem_.spare_budget())) return by_count;
    // The fractional knapsack.
    std::vector<std::uint32_t> order(sums.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto weight = [&](std::uint32_t j) { return problem_.map().obstacle(numbered_[j]).weight; };
    std::ranges::sort(order, [&](auto a, auto b) {
        const double left = sums[a] * weight(b);
        const double right = sums[b] * weight(a);
        return left != right ? left > right : a < b;
    });
    double by_weight = 0;
    double budget = problem_.spare_budget();
    std::vector<char> within(sums.size(), 0);
    for (const std::uint32_t j : order) {
        if (sums[j] <= 0 || budget <= 0) break;
        const double share = std::min(budget / weight(j), 1.0);
        by_weight += share * sums[j];
        budget -= weight(j);
        within[j] = share == 1 ? 1 : 0;
    }
    if (by_weight < by_count) chosen = std::move(within);
    return std::min(by_count, by_weight);
}

// Of the obstacles with the shortest detours, so many, those that most is paid for.
void Relaxation::mark_most_paid(const std::vector<double>& sums, std::size_t count, std::vector<char>& chosen) const {
    std::vector<std::uint32_t> order(by_detour_.begin(), by_detour_.begin() + std::ptrdiff_t(count));
    std::erase_if(order, [&](std::uint32_t j) { return sums[j] <= 0; });
    const std::size_t most = std::min(order.size(), std::size_t(problem_.spare_removals()));
    std::ranges::partial_sort(order, order.begin() + std::ptrdiff_t(most), [&](std::uint32_t a, std::uint32_t b) {
        return sums[a] != sums[b] ? sums[a] > sums[b] : a < b;
    });
    chosen.assign(sums.size(), 0);
    for (std::size_t k = 0; k < most; ++k) chosen[order[k]] = 1;
}

// What vehicles take at these prices, and what is chosen for what they pay: on the known columns.
Relaxation::Answer Relaxation::answer(const Prices& at) const {
    Answer answer;
    std::vector<double> sums;
    sum_for(at, sums);
    answer.value = (problem_.sums() ? fixed() : 0) - dearest(sums, answer.chosen);
    answer.taken.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (at.weights[i] < least_weight_of_vehicle) continue;
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
        if (at.weights[i] >= least_weight_of_vehicle) {
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
    for (int step = 0; step < steps_between_searches && share > least_share; ++step) {
        const Answer known = answer(at);
        if (known.value > best + least_gain * share * scale) {
            best = known.value;
            best_ = at;
            failures = 0;
        } else if (++failures == patience) {
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

// Searches at the best prices. Whether that has raised the bound or found new columns.
bool Relaxation::prove() {
    std::vector<double> sums;
    std::vector<char> chosen;
    sum_for(best_, sums);
    double value = (problem_.sums() ? fixed() : 0) - dearest(sums, chosen);
    std::size_t before = 0;
    std::size_t after = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const double weight = best_.weights[i];
        if (weight < least_weight_of_vehicle) continue;
        if (problem_.interrupts().due()) return false;
        std::vector<double> prices = best_.prices[i];
        for (double& price : prices) price /= weight;
        before += columns_.of(i).columns.size();
        const bool free = std::ranges::all_of(prices, [](double price) { return price == 0; });
        value += weight * (free ? columns_.of(i).least : columns_.search(i, prices));
        after += columns_.of(i).columns.size();
    }
    const bool gained = value > bound_;
    bound_ = std::max(bound_, value);
    number_obstacles();
    return gained || after > before;
}

void Relaxation::tighten(double reached, double close, int rounds) {
    for (int round = 0; round < rounds && bound_ * (1 + close) < reached; ++round) {
        if (problem_.interrupts().due()) return;
        ascend(reached);
        if (!prove()) return;
    }
}

std::vector<ObstacleId> Relaxation::wanted() const {
    std::vector<double> sums;
    sum_for(best_, sums);
    std::vector<std::uint32_t> order(sums.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](auto a, auto b) { return sums[a] > sums[b]; });
    std::vector<ObstacleId> wanted;
    for (const std::uint32_t j : order) wanted.push_back(numbered_[j]);
    return wanted;
}

}  // namespace waybreaker::coalition

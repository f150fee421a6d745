#include "coalition/columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "coalition/tuning.hpp"
#include "map/gap.hpp"

namespace waybreaker::coalition {
namespace {

double paid_for(std::span<const ObstacleId> opened, std::span<const double> prices) {
    double paid = 0;
    for (const ObstacleId id : opened) paid += prices[id.value];
    return paid;
}

}  // namespace

Cheapest cheapest(const Pool& pool, double weight, const std::vector<double>& prices) {
    Cheapest best;
    for (std::size_t c = 0; c < pool.columns.size(); ++c) {
        double cost = weight * pool.columns[c].arrival;
        for (const std::uint32_t at : pool.columns[c].opened) cost += prices[at];
        if (cost < best.cost) best = {cost, c};
    }
    return best;
}

Columns::Columns(const Problem& problem, Workers& workers, Shape shape, std::span<const team::Vehicle> closed)
    : problem_(problem),
      shape_(shape),
      heeds_times_(can_heed_times() &&
                   (problem.rules().collisions || problem.vehicles().size() <= tuning::most_vehicles_in_time_at_first)),
      most_expansions_(problem.rules().collisions ? tuning::most_pricing_expansions
                                                  : std::min(tuning::most_pricing_expansions,
                                                             tuning::most_first_expansions_of_all /
                                                                 std::max<std::size_t>(problem.vehicles().size(), 1))),
      pools_(problem.vehicles().size()),
      proofs_(pools_.size()),
      memories_(pools_.size()),
      timed_(pools_.size()),
      limited_(pools_.size(), false) {
    workers.for_each(size(), [&](std::size_t i, Worker& worker) {
        const Remembering remembering(searcher(worker), memories_[i]);
        add(i, {}, closed_length(i, closed, worker));
        if (problem.sums()) begin(i, worker);
    });
    if (!problem.sums()) begin_latest(workers.own());
}

bool Columns::heed_times() {
    return can_heed_times() && !std::exchange(heeds_times_, true);
}

bool Columns::search_longer() {
    return std::exchange(most_expansions_, tuning::most_pricing_expansions) < tuning::most_pricing_expansions;
}

// Where the last arrival counts, only those matter that may be the last.
void Columns::begin_latest(Worker& worker) {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto closed = [this](std::size_t i) { return pools_[i].columns.front().arrival; };
    std::ranges::stable_sort(order, std::greater<>(), closed);
    double last = 0;
    for (const std::size_t i : order) {
        if (closed(i) <= last) break;
        const Remembering remembering(searcher(worker), memories_[i]);
        begin(i, worker);
        last = std::max(last, pools_[i].least);
    }
}

// At least so long is the way with nothing opened but what must be.
double Columns::closed_length(std::size_t vehicle, std::span<const team::Vehicle> closed, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    const bool known = !closed.empty() && !closed[vehicle].way.empty() && problem_.forced().empty();
    if (known && shape_ == Shape::relaxed && team::drives_by_crossing(agent.body))
        return (closed[vehicle].bound - agent.ready_at) * agent.speed;
    return find(vehicle, 0, infinity, worker).lower_bound;
}

// The best set of that size or smaller.
CrossingResult Columns::find(std::size_t vehicle, int crossings, double length_limit, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    CrossingOptions options = options_for(vehicle);
    options.crossings = crossings;
    options.length_limit = length_limit;
    CrossingResult found = searcher(worker).find(problem_.map(), agent.start, agent.goal, options);
    note(vehicle, found);
    return found;
}

void Columns::begin(std::size_t vehicle, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    pools_[vehicle].least = pools_[vehicle].columns.front().arrival;
    if (agent.start == agent.goal || problem_.spare_removals() == 0) return;
    if (shape_ == Shape::relaxed) {
        begin_in_time(vehicle, worker);
    } else {
        begin_by_count(vehicle, worker);
    }
}

// The best set in time. Without waits it is found faster, and says where to look.
void Columns::begin_in_time(std::size_t vehicle, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    Pool& pool = pools_[vehicle];
    const double closed = (pool.columns.front().arrival - agent.ready_at) * agent.speed;
    CrossingResult best = find(vehicle, problem_.spare_removals(), closed, worker);
    const double least = std::min(best.lower_bound, closed);
    pool.least = arrival_of(agent, {}, least);
    if (std::isinf(least)) return;
    if (in_time()) {
        CrossingOptions options = options_for(vehicle);
        options.prices = {};
        options.limits.expansions = std::min(problem_.interrupts().expansions, tuning::most_first_expansions_in_time);
        options.length_limit = closed;
        options.expected = least;
        options.opened_after = [&](std::span<const ObstacleId> opened) { return each_opened_after(agent, opened); };
        best = crossing::Access::find(searcher(worker), problem_.map(), agent.start, agent.goal, options,
                                      {.opens_each_alone = true});
        note(vehicle, best);
        pool.least = std::max(pool.least, arrival_of(agent, {}, std::min(best.lower_bound, closed)));
    }
    if (best.status == SearchStatus::found) add_in_time(vehicle, best.best.crossed, best.best.cost, worker);
}

// The best set of one obstacle, of two, and so on, and of as many as may be.
void Columns::begin_by_count(std::size_t vehicle, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    Pool& pool = pools_[vehicle];
    double least = (pool.columns.front().arrival - agent.ready_at) * agent.speed;
    const int all = problem_.spare_removals();
    for (int count = 1; count <= all;
         count = count < tuning::most_sizes_of_own_body ? count + 1 : std::max(all, count + 1)) {
        const CrossingResult best = find(vehicle, count, least, worker);
        if (best.status == SearchStatus::found) add(vehicle, best.best.crossed, best.lower_bound);
        least = std::min(least, best.lower_bound);
    }
    pool.least = arrival_of(agent, {}, least);
    const std::vector<double> free(problem_.map().obstacles().size() + 1, 0);
    pool.least = std::max(pool.least, list_near(vehicle, free, tuning::most_margin * pool.least, worker).least);
}

// As if all were open: a search in time must not count the rubble of what it passes before a wait.
CrossingOptions Columns::options_for(std::size_t vehicle) const {
    const Agent& agent = *problem_.vehicles()[vehicle];
    CrossingOptions options;
    options.relaxed = shape_ == Shape::relaxed;
    // Who cuts corners is a point.
    const bool is_body = agent.body.corners == Corners::none;
    options.body = is_body ? agent.body : options.relaxed ? point_body : Body();
    options.crossings = problem_.spare_removals();
    options.removed = problem_.forced();
    options.protect = problem_.rules().protect;
    options.budget = problem_.spare_budget();
    options.prices = problem_.rubble_prices(vehicle);
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, most_expansions_);
    return options;
}

// What opens so late, or costs so much, that nothing is gained by it.
std::vector<ObstacleId> Columns::useless(const Agent& agent, std::span<const double> prices, double known) const {
    std::vector<ObstacleId> useless;
    for (const Obstacle& obstacle : problem_.map().obstacles()) {
        const double least = late_arrival(agent, obstacle, problem_.least_opening(obstacle.id));
        if (least + prices[obstacle.id.value] >= known) useless.push_back(obstacle.id);
    }
    return useless;
}

bool Columns::may_gain(std::size_t vehicle, const Obstacle& obstacle) const {
    const Agent& agent = *problem_.vehicles()[vehicle];
    const double closed = (pools_[vehicle].columns.front().arrival - agent.ready_at) * agent.speed;
    const double reach = agent.body.reach() + 1;
    return !obstacle.gone() &&
           gap(obstacle.bounds, agent.start) + gap(obstacle.bounds, agent.goal) - 2 * reach < closed;
}

double Columns::most_gain(std::size_t vehicle, const Obstacle& obstacle) const {
    if (!may_gain(vehicle, obstacle)) return 0;
    const Agent& agent = *problem_.vehicles()[vehicle];
    const double reach = agent.body.reach() + 1;
    const double way = gap(obstacle.bounds, agent.start) + gap(obstacle.bounds, agent.goal) - 2 * reach;
    const double least = std::max(pools_[vehicle].least, agent.ready_at + std::max(way, 0.0) / agent.speed);
    const double closed = pools_[vehicle].columns.front().arrival;
    return std::isinf(closed) ? least : std::max(closed - least, 0.0);
}

// In cells that it could drive until then, and through the rubble of one of them.
double Columns::opened_after(const Agent& agent, std::span<const ObstacleId> obstacles,
                             EarliestOpenings& openings) const {
    return (openings.of(obstacles).open + problem_.rules().rubble - agent.ready_at) * agent.speed;
}

// As if an aircraft could have each of them open as early as if it were the only one.
double Columns::each_opened_after(const Agent& agent, std::span<const ObstacleId> obstacles) const {
    double last = -infinity;
    for (const ObstacleId id : obstacles) last = std::max(last, problem_.earliest_opening(id));
    return (last + problem_.rules().rubble - agent.ready_at) * agent.speed;
}

// Who crosses an obstacle does so no earlier than the first aircraft can have it open, and has the rest of the way to
// go. Where the last arrival counts, the aircraft's own counts as well.
double Columns::arrival_of(const Agent& agent, std::span<const ObstacleId> opened, double length) const {
    double arrival = agent.ready_at + length / agent.speed;
    if (problem_.rules().timing == Timing::ignore) return arrival;
    for (const ObstacleId id : opened) {
        const double passed = problem_.earliest_opening(id) + problem_.rules().rubble;
        arrival = std::max(arrival, late_arrival(agent, problem_.map().obstacle(id), passed));
        if (problem_.rules().objective == Objective::makespan) {
            arrival = std::max(arrival, problem_.earliest_return(id));
        }
    }
    return arrival;
}

void Columns::add(std::size_t vehicle, std::span<const ObstacleId> opened, double length) {
    Pool& pool = pools_[vehicle];
    Column column;
    column.arrival = std::min(arrival_of(*problem_.vehicles()[vehicle], opened, length), problem_.unreached(vehicle));
    for (const ObstacleId id : opened) {
        const auto known = std::ranges::find(pool.obstacles, id);
        column.opened.push_back(std::uint32_t(known - pool.obstacles.begin()));
        if (known == pool.obstacles.end()) pool.obstacles.push_back(id);
    }
    std::ranges::sort(column.opened);
    const auto same = std::ranges::find(pool.columns, column.opened, &Column::opened);
    if (same == pool.columns.end()) {
        pool.columns.push_back(std::move(column));
    } else {
        same->arrival = std::min(same->arrival, column.arrival);
    }
}

// Patience is the method's own; the limits are the caller's.
void Columns::note(std::size_t vehicle, const CrossingResult& search) {
    const team::Interrupts& interrupts = problem_.interrupts();
    const bool ended = search.status == SearchStatus::limit_reached || search.status == SearchStatus::stopped;
    if (ended && (interrupts.due() || interrupts.expansions < tuning::most_pricing_expansions))
        limited_[vehicle] = true;
}

double Columns::best_known(std::size_t vehicle, std::span<const double> prices) const {
    std::vector<double> known_prices;
    for (const ObstacleId id : pools_[vehicle].obstacles) known_prices.push_back(prices[id.value]);
    return cheapest(pools_[vehicle], 1, known_prices).cost;
}

// By how much what is paid for a set can have fallen.
double Columns::greatest_fall(std::span<const double> from, std::span<const double> to) const {
    std::vector<double> falls;
    for (std::size_t id = 0; id < from.size(); ++id) {
        if (to[id] < from[id]) falls.push_back(from[id] - to[id]);
    }
    std::ranges::sort(falls, std::greater<>());
    falls.resize(std::min(falls.size(), std::size_t(problem_.spare_removals())));
    return std::accumulate(falls.begin(), falls.end(), 0.0);
}

Columns::Search Columns::search(std::size_t vehicle, std::span<const double> prices, Worker& worker) {
    const Remembering remembering(searcher(worker), memories_[vehicle]);
    return search_best(vehicle, prices, worker);
}

Columns::Search Columns::list(std::size_t vehicle, std::span<const double> prices, double margin, Worker& worker) {
    const Remembering remembering(searcher(worker), memories_[vehicle]);
    return list_near(vehicle, prices, margin, worker);
}

Columns::Query Columns::query(std::size_t vehicle, std::span<const double> prices, double less_than) const {
    const Agent& agent = *problem_.vehicles()[vehicle];
    Query query{{}, {}, useless(agent, prices, less_than), options_for(vehicle)};
    for (const double price : prices) query.prices.push_back(price * agent.speed);
    query.with_rubble = query.prices;
    for (std::size_t id = 0; id < query.options.prices.size(); ++id) query.with_rubble[id] += query.options.prices[id];
    query.protect.insert(query.protect.end(), query.options.protect.begin(), query.options.protect.end());
    query.options.prices = query.with_rubble;
    query.options.protect = query.protect;
    return query;
}

// First as if all were open: that takes a fraction of the time, is often in time, and says more than a search in time
// that a limit ends.
Columns::Search Columns::search_best(std::size_t vehicle, std::span<const double> prices, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    if (agent.start == agent.goal) return {agent.ready_at, infinity};
    Proof& proof = proofs_[vehicle];
    double best = best_known(vehicle, prices);
    if (proof.complete && proof.least - greatest_fall(proof.prices, prices) >= best * (1 - rounding))
        return {best, best};
    Query asked = query(vehicle, prices, best);
    CrossingOptions& options = asked.options;
    const auto find = [&](const crossing::Opener& opener) {
        if (std::isfinite(best)) {
            options.length_limit = (best - agent.ready_at) * agent.speed;
            options.expected = options.length_limit;
        }
        CrossingResult found =
            crossing::Access::find(searcher(worker), problem_.map(), agent.start, agent.goal, options, opener);
        note(vehicle, found);
        if (found.status == SearchStatus::found) {
            add_in_time(vehicle, found.best.crossed, found.best.cost - paid_for(found.best.crossed, asked.prices),
                        worker);
        }
        best = best_known(vehicle, prices);
        proof.complete = found.status == SearchStatus::found || found.status == SearchStatus::no_path;
        proof.least = std::min(best, std::max(proof.least, agent.ready_at + found.lower_bound / agent.speed));
    };
    proof.prices.assign(prices.begin(), prices.end());
    proof.least = 0;
    find({});
    if (in_time() && proof.least < best * (1 - rounding)) {
        options.prices = asked.prices;
        options.opened_after = [&](std::span<const ObstacleId> opened) { return each_opened_after(agent, opened); };
        options.limits.expansions = std::min(options.limits.expansions, tuning::most_pricing_expansions_in_time);
        find({.opens_each_alone = true});
    }
    return {proof.least, proof.least};
}

Columns::Search Columns::list_near(std::size_t vehicle, std::span<const double> prices, double margin, Worker& worker) {
    const Search proven = search_best(vehicle, prices, worker);
    const Agent& agent = *problem_.vehicles()[vehicle];
    if (agent.start == agent.goal || !proofs_[vehicle].complete) return proven;
    double best = best_known(vehicle, prices);
    if (std::isfinite(best)) margin = std::min(margin, tuning::most_margin * best);
    Query asked = query(vehicle, prices, best + margin);
    CrossingOptions& options = asked.options;
    if (std::isfinite(best)) {
        options.length_limit = (best + margin - agent.ready_at) * agent.speed;
        options.expected = options.length_limit;
    }
    if (in_time()) {
        options.prices = asked.prices;
        options.opened_after = [&](std::span<const ObstacleId> opened) {
            return opened_after(agent, opened, worker.openings);
        };
    }
    int added = 0;
    const CrossingResult rest =
        searcher(worker).enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (added == tuning::most_columns_of_enumeration ||
                agent.ready_at + path.cost / agent.speed >= best + margin)
                return false;
            ++added;
            const double length = path.cost - paid_for(path.crossed, asked.prices);
            add(vehicle, path.crossed, length);
            best = std::min(best, arrival_of(agent, path.crossed, length) + paid_for(path.crossed, prices));
            return true;
        });
    note(vehicle, rest);
    const double others = agent.ready_at + rest.lower_bound / agent.speed;
    return {std::max(proven.least, std::min(best, others)), std::max(proven.least, others)};
}

// When the vehicle arrives by way of such a set and by nothing else, all of it opened by the aircraft together; its way
// takes that length at least. Once for each set.
void Columns::add_in_time(std::size_t vehicle, std::span<const ObstacleId> opened, double length, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    if (!in_time() || opened.empty()) return add(vehicle, opened, length);
    Set set(opened.begin(), opened.end());
    std::ranges::sort(set);
    if (!timed_[vehicle].insert(set).second) return;
    double nearest = infinity;
    for (const ObstacleId id : set) nearest = std::min(nearest, gap(problem_.map().obstacle(id).bounds, agent.start));
    if (opened_after(agent, set, worker.openings) <= nearest) return add(vehicle, set, length);
    CrossingOptions options = options_for(vehicle);
    options.prices = {};
    options.only = set;
    options.crossings = int(set.size());
    options.opened_after = [&](std::span<const ObstacleId> ids) { return opened_after(agent, ids, worker.openings); };
    const CrossingResult found = searcher(worker).find(problem_.map(), agent.start, agent.goal, options);
    if (found.status == SearchStatus::found) {
        const bool crosses_all = found.best.crossed.size() == set.size();
        add(vehicle, found.best.crossed, crosses_all ? std::max(length, found.best.cost) : found.best.cost);
    } else {
        add(vehicle, set, std::max(length, found.lower_bound));
    }
}

}  // namespace waybreaker::coalition

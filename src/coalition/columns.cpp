#include "coalition/columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace waybreaker::coalition {
namespace {

constexpr double rounding = 1e-9;  // relative
// Of one search: to be told of many sets at once saves searches; most searches end long before so many expansions.
constexpr int most_told = 64;
// Relative: sets that cost so much more than the best are worth knowing; prices will change.
constexpr double margin_of_relaxed = 0.003;
constexpr double margin_of_own = 0.03;
constexpr std::uint64_t most_expansions = 10'000;
// Of sets with as many obstacles the best is looked for, and of those with as many as may be.
constexpr int most_counted = 3;

}  // namespace

Cheapest cheapest(const Wishes& wishes, double weight, const std::vector<double>& prices) {
    Cheapest best;
    for (std::size_t c = 0; c < wishes.columns.size(); ++c) {
        double cost = weight * wishes.columns[c].arrival;
        for (const std::uint32_t at : wishes.columns[c].opened) cost += prices[at];
        if (cost < best.cost) best = {cost, c};
    }
    return best;
}

Columns::Columns(const Problem& problem, CrossingSearcher& crossing, Shape shape)
    : problem_(problem), crossing_(crossing), shape_(shape), wishes_(problem.vehicles().size()) {
    for (std::size_t i = 0; i < size(); ++i) add(i, {}, find(i, 0, infinity).lower_bound);
    // Where the last arrival counts, only those matter that may be the last.
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto closed = [this](std::size_t i) { return wishes_[i].columns.front().arrival; };
    if (!problem.sums()) std::ranges::stable_sort(order, std::greater<>(), closed);
    double last = 0;
    for (const std::size_t i : order) {
        if (!problem.sums() && closed(i) <= last) break;
        begin(i);
        last = std::max(last, wishes_[i].least);
    }
}

// The best set of that size or smaller.
CrossingResult Columns::find(std::size_t vehicle, int crossings, double length_limit) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    CrossingOptions options = options_for(agent);
    options.crossings = crossings;
    options.length_limit = length_limit;
    CrossingResult found = crossing_.find(problem_.map(), agent.start, agent.goal, options);
    note(found);
    return found;
}

// The best set of one obstacle, of two, and so on, and of as many as may be.
void Columns::begin(std::size_t vehicle) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    if (agent.start == agent.goal) return;
    const double closed = (wishes_[vehicle].columns.front().arrival - agent.ready_at) * agent.speed;
    double least = closed;
    const int all = problem_.spare_removals();
    for (int count = 1; count <= all; count = count < most_counted ? count + 1 : std::max(all, count + 1)) {
        const CrossingResult best = find(vehicle, count, least);
        if (best.status == SearchStatus::found) add(vehicle, best.best.crossed, best.lower_bound);
        least = std::min(least, best.lower_bound);
    }
    Wishes& wishes = wishes_[vehicle];
    wishes.least = wishes.found = arrival_of(agent, {}, least);
    // What opens late makes these sets dearer than they look.
    const std::vector<double> free(wishes.obstacles.size(), 0);
    const bool late = cheapest(wishes, 1, free).cost > wishes.least * (1 + rounding);
    if (late || shape_ == Shape::own) wishes.least = std::max(wishes.least, search(vehicle, free));
}

CrossingOptions Columns::options_for(const Agent& agent) const {
    CrossingOptions options;
    options.relaxed = shape_ == Shape::relaxed;
    // Who cuts corners is a point.
    const bool is_body = agent.body.corners == Corners::none;
    options.body = is_body ? agent.body : options.relaxed ? point_body : Body();
    options.crossings = problem_.spare_removals();
    options.removed = problem_.forced();
    options.protect = problem_.rules().protect;
    options.budget = problem_.spare_budget();
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, most_expansions);
    return options;
}

// What opens so late, or is so dear, that nothing is gained by it.
std::vector<ObstacleId> Columns::useless(const Agent& agent, const std::map<ObstacleId, double>& price_of,
                                         double known) const {
    std::vector<ObstacleId> useless;
    for (const Obstacle& obstacle : problem_.map().obstacles()) {
        const auto price = price_of.find(obstacle.id);
        const double least = late_arrival(agent, obstacle, problem_.least_opening(obstacle.id));
        if (least + (price == price_of.end() ? 0 : price->second / agent.speed) >= known)
            useless.push_back(obstacle.id);
    }
    return useless;
}

// By way of an obstacle that is open then.
double Columns::late_arrival(const Agent& agent, const Obstacle& obstacle, double opening) {
    const double left = gap(obstacle.bounds, agent.goal) - agent.body.reach() - 1;
    return opening + std::max(left, 0.0) / agent.speed;
}

// Who crosses an obstacle does so no earlier than the first aircraft can have it open, and has the rest of the way to
// go. Where the last arrival counts, the aircraft's own counts as well.
double Columns::arrival_of(const Agent& agent, std::span<const ObstacleId> opened, double length) const {
    if (agent.start == agent.goal) return 0;
    double arrival = agent.ready_at + length / agent.speed;
    if (problem_.rules().timing == Timing::ignore) return arrival;
    for (const ObstacleId id : opened) {
        arrival = std::max(arrival, late_arrival(agent, problem_.map().obstacle(id), problem_.earliest_opening(id)));
        if (problem_.rules().objective == Objective::makespan) {
            arrival = std::max(arrival, problem_.earliest_return(id));
        }
    }
    return arrival;
}

void Columns::add(std::size_t vehicle, std::span<const ObstacleId> opened, double length) {
    Wishes& wishes = wishes_[vehicle];
    Column column;
    column.arrival = arrival_of(*problem_.vehicles()[vehicle], opened, length);
    for (const ObstacleId id : opened) {
        const auto known = std::ranges::find(wishes.obstacles, id);
        column.opened.push_back(std::uint32_t(known - wishes.obstacles.begin()));
        if (known == wishes.obstacles.end()) wishes.obstacles.push_back(id);
    }
    std::ranges::sort(column.opened);
    const auto same = std::ranges::find(wishes.columns, column.opened, &Column::opened);
    if (same == wishes.columns.end()) {
        wishes.columns.push_back(std::move(column));
    } else {
        same->arrival = std::min(same->arrival, column.arrival);
    }
}

// Patience is the method's own; the limits are the caller's.
void Columns::note(const CrossingResult& search) {
    const team::Interrupts& interrupts = problem_.interrupts();
    const bool ended = search.status == SearchStatus::limit_reached || search.status == SearchStatus::stopped;
    limited_ = limited_ || (ended && (interrupts.due() || interrupts.expansions < most_expansions));
}

double Columns::search(std::size_t vehicle, const std::vector<double>& prices) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    if (agent.start == agent.goal) return 0;
    const Wishes& wishes = wishes_[vehicle];
    std::map<ObstacleId, double> price_of;  // in cells
    for (std::size_t at = 0; at < prices.size(); ++at) {
        if (prices[at] > 0) price_of.emplace(wishes.obstacles[at], prices[at] * agent.speed);
    }
    CrossingOptions options = options_for(agent);
    options.done_after = [&](std::span<const ObstacleId> opened) {
        double sum = 0;
        for (const ObstacleId id : opened) {
            if (const auto found = price_of.find(id); found != price_of.end()) sum += found->second;
        }
        return sum;
    };
    options.adds_both = true;
    const double known = cheapest(wishes, 1, prices).cost;
    const double dearest = (known - agent.ready_at) * agent.speed;
    const double margin = shape_ == Shape::relaxed ? margin_of_relaxed : margin_of_own;
    if (std::isfinite(known)) {
        options.length_limit = dearest * (1 + margin);
    }
    double best = known;
    std::vector<ObstacleId> protect = useless(agent, price_of, known);
    protect.insert(protect.end(), options.protect.begin(), options.protect.end());
    options.protect = protect;
    int told = 0;
    options.expected = (wishes_[vehicle].found - agent.ready_at) * agent.speed;
    const CrossingResult rest =
        crossing_.enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (told == most_told || agent.ready_at + path.cost / agent.speed >= best * (1 + margin)) return false;
            ++told;
            add(vehicle, path.crossed, path.length);
            const double arrival = arrival_of(agent, path.crossed, path.length);
            const double price = options.done_after(path.crossed) / agent.speed;
            best = std::min(best, arrival + price);
            return true;
        });
    note(rest);
    wishes_[vehicle].found = std::min(best, agent.ready_at + rest.lower_bound / agent.speed);
    return wishes_[vehicle].found;
}

}  // namespace waybreaker::coalition

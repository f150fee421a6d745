#include "coalition/greedy.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "coalition/tuning.hpp"
#include "drive/opening.hpp"
#include "model/objective.hpp"

namespace waybreaker::coalition {
namespace {}  // namespace

Greedy::Greedy(const Problem& problem, Workers& workers)
    : problem_(problem),
      workers_(workers),
      openings_(problem.map(), problem.rules(), {problem.aircraft().begin(), problem.aircraft().end()}),
      memories_(problem.vehicles().size()),
      arrivals_(problem.vehicles().size()),
      budget_(problem.spare_budget()) {}

bool Greedy::take_next() {
    if (taken_.size() == std::size_t(problem_.spare_removals())) return false;
    workers_.for_each(arrivals_.size(), [&](std::size_t i, Worker& worker) { arrivals_[i] = search(i, worker); });
    limited_ = limited_ || std::ranges::any_of(arrivals_, &Arrivals::limited);
    team::Cost least = cost_with({});
    std::optional<ObstacleId> next;
    for (const ObstacleId id : useful()) {
        if (problem_.interrupts().due()) return false;
        const team::Cost cost = cost_with({id});
        if (!team::better(cost, least)) continue;
        least = cost;
        next = id;
    }
    if (!next) return false;
    taken_ = united(taken_, {*next});
    budget_ -= problem_.map().obstacle(*next).weight;
    return true;
}

// By the relaxed body where the square does not stand for the disc.
Greedy::Arrivals Greedy::search(std::size_t vehicle, Worker& worker) {
    const Agent& agent = *problem_.vehicles()[vehicle];
    Arrivals found;
    if (agent.start == agent.goal) {
        found.closed = agent.ready_at;
        return found;
    }
    const Set removed = united(problem_.forced(), taken_);
    CrossingOptions options;
    options.body = agent.body;
    options.relaxed = !square_stands_for(agent.body);
    options.removed = removed;
    options.protect = problem_.rules().protect;
    options.budget = budget_;
    options.limits = problem_.interrupts().limits();
    CrossingSearcher& searcher = options.relaxed ? worker.limits : worker.crossing;
    const Remembering remembering(searcher, memories_[vehicle]);
    const CrossingResult closed = searcher.find(problem_.map(), agent.start, agent.goal, options);
    if (closed.status == SearchStatus::found) {
        found.closed = agent.ready_at + closed.best.cost / agent.speed;
        options.length_limit = options.expected = closed.best.cost;
    }
    if (problem_.unreached(vehicle) < found.closed) {
        found.closed = problem_.unreached(vehicle);
        options.length_limit = options.expected = (found.closed - agent.ready_at) * agent.speed;
    }
    options.crossings = 1;
    options.prices = problem_.rubble_prices(vehicle);
    options.limits.expansions = std::min(options.limits.expansions, tuning::most_greedy_expansions);
    const CrossingResult all =
        searcher.enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (path.crossed.empty()) return false;  // what follows is no earlier
            const ObstacleId id = path.crossed.front();
            const double driven = agent.ready_at + path.cost / agent.speed;
            const double opened = problem_.earliest_opening(id) + problem_.rules().rubble;
            found.with.emplace(id, std::max(driven, late_arrival(agent, problem_.map().obstacle(id), opened)));
            return found.with.size() < tuning::most_greedy_obstacles;
        });
    found.limited = problem_.interrupts().due() || !came_to_its_end(closed.status) ||
                    (problem_.interrupts().expansions < tuning::most_greedy_expansions && !came_to_its_end(all.status));
    return found;
}

// Of all vehicles alone and of the aircraft, with those obstacles open as well; vehicles without a way first.
team::Cost Greedy::cost_with(const Set& more) {
    team::Cost cost;
    Finish finish;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
        double arrival = arrivals_[i].closed;
        for (const ObstacleId id : more) {
            const auto with = arrivals_[i].with.find(id);
            if (with != arrivals_[i].with.end()) arrival = std::min(arrival, with->second);
        }
        if (arrival == infinity) {
            ++cost.missing;
        } else {
            finish.add(AgentKind::ground, arrival, problem_.weight(i));
        }
    }
    const Returns& home = openings_.of(united(united(problem_.forced(), taken_), more)).home;
    finish.air = home.last;
    finish.flowtime += home.sum;
    const Rank rank = waybreaker::rank(problem_.rules().objective, finish);
    cost.first = rank.first;
    cost.second = rank.second;
    return cost;
}

// By which some vehicle arrives earlier.
Set Greedy::useful() const {
    Set useful;
    for (const Arrivals& arrivals : arrivals_) {
        for (const auto& [id, arrival] : arrivals.with) useful.push_back(id);
    }
    std::ranges::sort(useful);
    useful.erase(std::unique(useful.begin(), useful.end()), useful.end());
    return useful;
}

}  // namespace waybreaker::coalition

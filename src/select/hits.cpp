#include "select/hits.hpp"

#include <algorithm>

#include "core/stopwatch.hpp"

namespace waybreaker {
namespace {

Candidate opened(const Task& task, Searcher& searcher, std::span<const ObstacleId> removed) {
    const Stopwatch watch;
    const SearchResult search =
        searcher.find(OpenedMap(task.map, removed), task.driver.start, task.driver.goal, task.trip().by_cells());
    return candidate_of(task, opening_of({removed.begin(), removed.end()}, search, watch.seconds()));
}

}  // namespace

std::vector<ObstacleId> most_hit(const Map& map, std::span<const std::uint32_t> hits, int n) {
    std::vector<ObstacleId> chosen;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.destructible && hits[obstacle.id.value] > 0) chosen.push_back(obstacle.id);
    }
    const auto more_hits = [hits](ObstacleId a, ObstacleId b) {
        return hits[a.value] != hits[b.value] ? hits[a.value] > hits[b.value] : a < b;
    };
    const auto count = std::min(chosen.size(), std::size_t(std::max(n, 0)));
    std::partial_sort(chosen.begin(), chosen.begin() + std::ptrdiff_t(count), chosen.end(), more_hits);
    chosen.resize(count);
    return chosen;
}

std::vector<ObstacleId> most_hit(const Map& map, const Rules& rules, std::span<const std::uint32_t> hits, int n) {
    std::vector<std::uint32_t> countable(hits.begin(), hits.end());
    for (const ObstacleId id : rules.protect) countable[id.value] = 0;
    for (const ObstacleId id : rules.force) countable[id.value] = 0;
    for (const TimedOpening& opening : rules.opened) countable[opening.obstacle.value] = 0;
    return most_hit(map, countable, n);
}

SearchResult search_counting_hits(const Task& task, Searcher& searcher) {
    SearchOptions counting = task.trip().by_cells();
    counting.count_hits = true;
    return searcher.find(OpenedMap(task.map, task.opened()), task.driver.start, task.driver.goal, counting);
}

std::vector<ObstacleId> chosen_by_hits(const Task& task, std::span<const std::uint32_t> hits) {
    std::vector<ObstacleId> chosen = task.with_forced(most_hit(task.map, task.rules, hits, task.spare_removals()));
    double budget = task.rules.budget;
    const std::vector<ObstacleId> opened = task.opened();
    std::erase_if(chosen, [&](ObstacleId id) {
        if (std::ranges::find(opened, id) != opened.end()) return false;
        const double weight = task.map.obstacle(id).weight;
        if (weight > budget) return true;
        budget -= weight;
        return false;
    });
    return chosen;
}

Candidate HitsSelector::baseline(const Task& task) {
    const Stopwatch watch;
    SearchResult search = search_counting_hits(task, searchers_.cells);
    hits_ = std::move(search.hits);
    return around_late_openings(task, searchers_,
                                candidate_of(task, opening_of(task.opened(), search, watch.seconds())));
}

Selected HitsSelector::select(const Task& task, const Candidate& start) {
    const std::vector<ObstacleId> chosen = chosen_by_hits(task, hits_);
    Selected selected;
    std::vector<Candidate>& candidates = selected.candidates;
    if (chosen.empty() || start.opening.status == SearchStatus::stopped) return selected;
    if (task.rules.timing == Timing::ignore) {
        candidates.push_back(opened(task, searchers_.cells, chosen));
        return selected;
    }
    const double floor = task.objective(task.arrival(distance(task.driver.start, task.driver.goal)), task.least_flight);
    double best = cost(task, start);
    for (std::size_t count = task.given.size() + 1; count <= chosen.size(); ++count) {
        if (best <= floor * (1 + 1e-9) || task.deadline.passed()) break;
        candidates.push_back(
            around_late_openings(task, searchers_, opened(task, searchers_.cells, std::span(chosen).first(count))));
        best = std::min(best, cost(task, candidates.back()));
        if (candidates.back().opening.status == SearchStatus::stopped) break;
    }
    selected.limited = task.deadline.passed();
    return selected;
}

}  // namespace waybreaker

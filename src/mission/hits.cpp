#include "mission/hits.hpp"

#include <algorithm>

#include "core/stopwatch.hpp"
#include "waybreaker/breach.hpp"

namespace waybreaker {
namespace {

// Lets stand again what the ground path does without, but for what is removed in any case, which comes first.
void keep_needed(const Task& task, Candidate& candidate, std::span<const Cell> path) {
    for (std::size_t i = candidate.removed.size(); i-- > task.rules.force.size();) {
        std::vector<ObstacleId> others = candidate.removed;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const OpenedMap map(task.map, others);
        const auto blocked = [&](Cell a, Cell b) { return !line_of_sight(map, a, b, task.driver.body); };
        if (std::ranges::adjacent_find(path, blocked) == path.end()) candidate.removed = std::move(others);
    }
}

Candidate opened(const Task& task, Searcher& searcher, std::span<const ObstacleId> removed) {
    const Stopwatch watch;
    const SearchResult search =
        searcher.find(OpenedMap(task.map, removed), task.driver.start, task.driver.goal, cell_search(task));
    Candidate candidate = candidate_of({removed.begin(), removed.end()}, search, watch.seconds());
    if (task.rules.timing == Timing::enforce && candidate.ground.length) keep_needed(task, candidate, search.path);
    return candidate;
}

}  // namespace

SearchResult search_counting_hits(const Task& task, Searcher& searcher) {
    SearchOptions counting = cell_search(task);
    counting.count_hits = true;
    return searcher.find(OpenedMap(task.map), task.driver.start, task.driver.goal, counting);
}

std::vector<ObstacleId> chosen_by_hits(const Task& task, std::span<const std::uint32_t> hits) {
    const Rules& rules = task.rules;
    std::vector<std::uint32_t> countable(hits.begin(), hits.end());
    for (const ObstacleId id : rules.protect) countable[id.value] = 0;
    for (const ObstacleId id : rules.force) countable[id.value] = 0;
    std::vector<ObstacleId> chosen = task.with_forced(most_hit(task.map, countable, task.spare_removals()));
    double budget = rules.budget;
    std::erase_if(chosen, [&](ObstacleId id) {
        const double weight = task.map.obstacle(id).weight;
        if (weight > budget) return true;
        budget -= weight;
        return false;
    });
    return chosen;
}

std::vector<Draft> drafts_by_hits(const Task& task, Searcher& searcher, const Draft& least,
                                  std::span<const ObstacleId> chosen) {
    if (chosen.empty() || least.candidate.status == SearchStatus::stopped) return {};
    std::vector<Draft> drafts;
    if (task.rules.timing == Timing::ignore) {
        drafts.push_back(draft_of(task, opened(task, searcher, chosen)));
        return drafts;
    }
    const double floor =
        task.objective(distance(task.driver.start, task.driver.goal) / task.driver.speed, task.least_flight);
    double best = cost(task, least);
    for (std::size_t count = task.rules.force.size() + 1; count <= chosen.size(); ++count) {
        if (best <= floor * (1 + 1e-9) || task.deadline.passed()) break;
        drafts.push_back(draft_of(task, opened(task, searcher, chosen.first(count))));
        best = std::min(best, cost(task, drafts.back()));
        if (drafts.back().candidate.status == SearchStatus::stopped) break;
    }
    return drafts;
}

}  // namespace waybreaker

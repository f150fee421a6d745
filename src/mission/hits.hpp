// The paper's way to select: the obstacles that the search ran into most often.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mission/candidate.hpp"

namespace waybreaker {

// The ground path without removal, and on the way how often each obstacle was in it (the paper's step 2).
SearchResult search_counting_hits(const Task& task, Searcher& searcher);

// What is removed in any case, then the most hit obstacles that the options allow to be removed, most hits first.
std::vector<ObstacleId> chosen_by_hits(const Task& task, std::span<const std::uint32_t> hits);

// What removing them leads to. The paper removes them all: one draft. With timing enforced there is one for each
// beginning of the list beyond `least`, without what the ground path does not need open after all, so that more
// removals never cost more.
std::vector<Draft> drafts_by_hits(const Task& task, Searcher& searcher, const Draft& least,
                                  std::span<const ObstacleId> chosen);

}  // namespace waybreaker

// The paper's way to select: the obstacles that the search ran into most often (section 3, "argmax obstacles(o)").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "select/selector.hpp"

namespace waybreaker {

// The n destructible obstacles with the most hits, most hits first; equal counts: the smaller id. An obstacle without a
// hit is never chosen, so there may be fewer than n. `hits` is SearchResult::hits.
std::vector<ObstacleId> most_hit(const Map& map, std::span<const std::uint32_t> hits, int n);

// The same of those that the rules allow to be removed, but do not force.
std::vector<ObstacleId> most_hit(const Map& map, const Rules& rules, std::span<const std::uint32_t> hits, int n);

// What must be removed, then the most hit obstacles that the rules allow to be removed, most hits first.
std::vector<ObstacleId> chosen_by_hits(const Task& task, std::span<const std::uint32_t> hits);

// The ground path without removal, and on the way how often each obstacle was in it (the paper's step 2).
SearchResult search_counting_hits(const Task& task, Searcher& searcher);

class HitsSelector : public Selector {
  public:
    explicit HitsSelector(const Searchers& searchers) : searchers_(searchers) {}
    Candidate baseline(const Task& task) override;
    // The paper removes all of the most hit: one candidate. With timing enforced there is one for each beginning of the
    // list beyond `start`, without what the ground path does not need open after all, so that more removals never cost
    // more.
    Selected select(const Task& task, const Candidate& start) override;
    std::span<const std::uint32_t> hits() const override { return hits_; }

  private:
    Searchers searchers_;
    std::vector<std::uint32_t> hits_;
};

}  // namespace waybreaker

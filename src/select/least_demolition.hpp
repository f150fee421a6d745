// Of the plans that are about as good as the best one, the one that demolishes the least.
#pragma once

#include <cstdint>

#include "select/selector.hpp"

namespace waybreaker {

struct LeastDemolition {
    Candidate candidate;
    // Cells that every plan within the tolerance demolishes, proven: the candidate's own, if none demolishes fewer.
    std::uint64_t least = 0;
    bool limited = false;  // the time ended the search
};

// Looks for the smallest budget of cells with which the selection still comes within the tolerance of `best`, by
// halving what is left between a budget that is proven to be too small and the cells of the best candidate so far:
// O(log cells) selections, each with half of the time that is left. Then, where the proof has a gap, for the largest
// budget that is proven to be too small.
//
// `start` removes nothing but what must be; `selected` is what the choice of `best` led to.
// REQUIRES: rules.minimise_demolition, and weights in proportion to cells if there is a budget (validate of
// method.hpp).
LeastDemolition demolish_least(const Task& task, const Searchers& searchers, Selector& selector,
                               const Candidate& baseline, const Candidate& start, const Selected& selected,
                               const Candidate& best);

}  // namespace waybreaker

// Of the plans that are about as good as the best one, the one that demolishes the least.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "select/selector.hpp"

namespace waybreaker {

struct LeastDemolition {
    Candidate candidate;
    // Cells that every plan within the tolerance demolishes, proven: the candidate's own, if none demolishes fewer.
    std::uint64_t least = 0;
    bool limited = false;  // the time ended the search
};

// What planning within a budget of cells led to.
struct WithinBudget {
    std::optional<std::uint64_t> cells;  // of a plan within the tolerance
    bool proven = false;                 // that there is none
};

struct LeastCells {
    std::uint64_t least = 0;  // no plan within the tolerance demolishes fewer, proven
    bool limited = false;     // the deadline ended the search
};

// Looks for the smallest budget of cells with which planning still comes within the tolerance, by halving what is left
// between a budget that is proven to be too small and the cells of the most frugal plan so far: O(log cells) calls of
// `within`. Then, where the proof has a gap, for the largest budget that is proven to be too small.
// `forced`: cells that every plan demolishes; `known`: those of a plan within the tolerance.
LeastCells least_cells(std::uint64_t forced, std::uint64_t known, const Deadline& deadline,
                       const std::function<WithinBudget(std::uint64_t)>& within);

// By id, from 1: what each obstacle weighs where a budget is one of cells.
std::vector<double> cells_as_weights(const Map& map);

// The selections within budgets of cells, each with half of the time that is left.
//
// `start` removes nothing but what must be; `selected` is what the choice of `best` led to.
// REQUIRES: rules.minimise_demolition, and weights in proportion to cells if there is a budget (validate of
// method.hpp).
LeastDemolition demolish_least(const Task& task, const Searchers& searchers, Selector& selector,
                               const Candidate& baseline, const Candidate& start, const Selected& selected,
                               const Candidate& best);

}  // namespace waybreaker

// Selector: a way to select the obstacles to remove. All have one interface; the mission's best candidate is its plan.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "select/candidate.hpp"

namespace waybreaker {

// What a selection led to, in the order in which it was found.
struct Selected {
    std::vector<Candidate> candidates = {};
    // Of the objective, over all plans that keep to the rules; where the way to select proves one.
    std::optional<double> bound = {};
    bool limited = false;   // a limit ended the selection
    bool may_miss = false;  // it ended by itself, but no proof says that there is nothing else
};

class Selector {
  public:
    virtual ~Selector() = default;

    // The mission without removal. To be called first: some ways learn from it what to remove.
    virtual Candidate baseline(const Task& task) = 0;
    // What to remove beyond what must be. `start`: the best without. The task may have other rules than that of
    // baseline().
    virtual Selected select(const Task& task, const Candidate& start) = 0;
    // How often each obstacle was in the way of the baseline, by id; empty for ways that do not count.
    virtual std::span<const std::uint32_t> hits() const { return {}; }
};

// The searchers must outlive it.
std::unique_ptr<Selector> selector_of(const Method& method, const Searchers& searchers);

// What every selection starts from: the baseline, or with what the rules say must be removed.
Candidate start_of(const Task& task, const Searchers& searchers, const Candidate& baseline);

}  // namespace waybreaker

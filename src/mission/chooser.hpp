// Chooser: the two ways to select, behind one face.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mission/candidate.hpp"
#include "waybreaker/crossing.hpp"

namespace waybreaker {

class Chooser {
  public:
    Chooser(const Task& task, Searcher& searcher, CrossingSearcher& crossing)
        : task_(task), searcher_(searcher), crossing_(crossing) {}

    // The mission without removal.
    Draft nothing();
    // What every choice under the task's rules starts from: the mission without removal, or with what must be removed.
    Draft least(const Task& task, const Draft& nothing);
    // What the method's way of selecting leads to beyond that. REQUIRES: nothing() was called, for the paper's way
    // counts there.
    std::vector<Draft> drafts(const Task& task, const Draft& least);
    // Of the objective, over all plans the last drafts() could have made, if its way proves one.
    std::optional<double> bound() const { return bound_; }
    // Whether a limit ended what has been chosen so far.
    bool limited() const { return limited_; }
    // By obstacle, for the paper's way; else empty.
    std::span<const std::uint32_t> hits() const { return hits_; }

  private:
    const Task& task_;
    Searcher& searcher_;
    CrossingSearcher& crossing_;
    std::vector<std::uint32_t> hits_;
    std::optional<double> bound_;
    bool limited_ = false;
};

}  // namespace waybreaker

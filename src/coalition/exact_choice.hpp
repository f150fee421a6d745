// Exact choice: evaluates the sets that a relaxation points to, and bounds all others.
#pragma once

#include <cstddef>
#include <optional>

#include "coalition/evaluation.hpp"
#include "coalition/relaxation.hpp"

namespace waybreaker::coalition {

class ExactChoice {
  public:
    // All arguments must outlive it.
    ExactChoice(const Problem& problem, Workers& workers, Columns& columns, Relaxation& relaxation,
                Evaluation& evaluation)
        : problem_(problem),
          workers_(workers),
          columns_(columns),
          relaxation_(relaxation),
          evaluation_(evaluation),
          bound_(relaxation.bound()) {}

    void run();
    // No plan is below, collisions or not.
    double bound() const { return bound_; }

  private:
    bool due() const { return problem_.interrupts().due(); }
    double reached() const { return evaluation_.reached(); }
    // A plan that is so near to the bound, or as near as the caller needs it.
    bool is_within(double gap) const { return reached() <= bound_ * (1 + std::max(gap, problem_.interrupts().gap)); }
    void improve_prices();
    void try_jointly();
    void try_for_own_bodies();
    void try_own_missions();
    std::optional<std::size_t> decisive() const;
    double least_of_others(std::size_t vehicle) const;
    void try_all();
    Set most_wanted() const;

    const Problem& problem_;
    Workers& workers_;
    Columns& columns_;
    Relaxation& relaxation_;
    Evaluation& evaluation_;
    double bound_;
};

}  // namespace waybreaker::coalition

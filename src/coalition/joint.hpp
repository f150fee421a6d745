// Joint: which sets vehicles drive through together, best first. With prices alone each has a set of its own, and the
// best mixture of those is a weaker bound than the best set that all share.
//
// Branch and bound over the columns that searches at certain prices have enumerated (docs/exact.md, Theorem 4). A node
// fixes the columns S_i of some vehicles, and so a set X of obstacles that these need. No plan with them is below
//     fixed + sum_these (w_i t_i(S_i) + p_i(S_i)) + sum_others min_i - max_{X' with X} (p(X') - f(X')),
// nor below the objective of these arrivals, the others' earliest, and the shortest flights past X.
#pragma once

#include <optional>
#include <vector>

#include "coalition/relaxation.hpp"

namespace waybreaker::coalition {

class Joint {
  public:
    // All arguments must outlive it, and not change meanwhile. Nothing of what costs `reached` or more is enumerated.
    Joint(const Problem& problem, const Columns& columns, const Relaxation::Proof& proof, EarliestOpenings& openings,
          double reached);

    // The next set in order of its limit, what must be removed aside. None if there is no other, or after a number of
    // nodes.
    std::optional<Set> next();
    // No plan is below.
    double bound() const;
    // No plan that removes a set that next() has not given is below.
    double rest() const { return std::min(bound_of_unknown_, open_.empty() ? reached_ : open_.front().bound); }

  private:
    struct Candidate {
        const Column* column = nullptr;
        Set opened;
        double cost = 0;  // weighted arrival, and prices
    };
    // The columns of some vehicles.
    struct Node {
        double bound = 0;
        std::size_t depth = 0;  // vehicles that have one
        double cost = 0;        // of these
        double sum = 0;         // of weighted arrivals
        double last = 0;
        Set opened;
    };

    void add_candidates(std::size_t vehicle);
    void expand(const Node& node);
    std::optional<double> bound_of(const Node& node) const;
    double bound_by_prices(const Node& node, double flights) const;

    const Problem& problem_;
    const Columns& columns_;
    const Relaxation::Proof& proof_;
    EarliestOpenings& openings_;
    double reached_;
    std::vector<std::size_t> order_;                  // vehicles with candidates
    std::vector<std::vector<Candidate>> candidates_;  // in that order; the cheapest first
    std::vector<double> least_cost_after_;            // by depth: of the vehicles that follow
    std::vector<double> least_sum_after_;             // the same of weighted arrivals
    double least_last_ = 0;                           // of any vehicle
    double bound_of_unknown_ = infinity;              // bound of plans with an unknown column
    std::vector<Node> open_;                          // heap
    std::vector<Set> enumerated_;
    int expanded_ = 0;
    double least_ = infinity;  // bound of the first set that next() has given
};

}  // namespace waybreaker::coalition

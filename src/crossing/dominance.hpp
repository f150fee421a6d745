// Dominance: which of two labels at a vertex need not be expanded.
#pragma once

#include <span>
#include <vector>

#include "crossing/geometry/convex.hpp"
#include "crossing/in_time/gates.hpp"
#include "crossing/labels/crossed_sets.hpp"
#include "crossing/labels/labels.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

class Dominance {
  public:
    // All must outlive it.
    Dominance(const CrossingQuery& query, const CrossingProgress& progress, const CrossedSets& sets,
              const std::vector<GateGroup>& groups, Convex& convex)
        : query_(query), progress_(progress), sets_(sets), groups_(groups), convex_(convex) {}

    // Whatever path goes on from `worse` goes on from `better` as well, costs no more and crosses no more: what only
    // `better` has crossed, and paid for, is made up for by what `worse` has and can never use again.
    bool operator()(const Label& better, const Label& worse) const;

  private:
    bool all_lost(const Label& label, std::span<const ObstacleId> but) const;
    bool lost(ObstacleId obstacle, const Label& label) const;
    double gain(const Label& better, const Label& worse) const;
    double price(ObstacleId obstacle) const {
        return query_.options->prices.empty() ? 0 : 2 * query_.options->prices[obstacle.value];
    }
    double weight(ObstacleId obstacle) const;

    const CrossingQuery& query_;
    const CrossingProgress& progress_;
    const CrossedSets& sets_;
    const std::vector<GateGroup>& groups_;
    Convex& convex_;
};

}  // namespace waybreaker::crossing

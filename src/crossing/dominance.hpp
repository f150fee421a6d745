// Dominance: which of two ways to be at a vertex need not be followed.
#pragma once

#include <span>
#include <vector>

#include "crossing/convex.hpp"
#include "crossing/gates.hpp"
#include "crossing/labels.hpp"
#include "crossing/regions.hpp"

namespace waybreaker::crossing {

struct Dominance {
    const Regions& regions;
    Convex& convex;
    const ObstacleSets& sets;
    const std::vector<GateGroup>& groups;
    bool weighs;  // whether the budget is limited
    Vertex goal;
    double limit;                     // half cells: dearer paths are not looked for
    bool by_count;                    // false: only what is crossed within what the other has crossed is as good,
    std::size_t full;                 // but whoever has crossed so many crosses nothing else
    std::span<const double> prices;   // by id; empty: nothing is paid
    const std::vector<double>& paid;  // by set, half cells

    // Whatever way goes on from `worse` goes on from `better` as well, costs no more and crosses no more: what only
    // `better` has crossed, and paid for, is made up for by what `worse` has and can never use again.
    bool operator()(const Label& better, const Label& worse) const;

  private:
    bool all_lost(const Label& label, std::span<const ObstacleId> but) const;
    bool lost(ObstacleId obstacle, const Label& label) const;
    double gain(const Label& better, const Label& worse) const;
    double price(ObstacleId obstacle) const { return prices.empty() ? 0 : 2 * prices[obstacle.value]; }
    double weight(ObstacleId obstacle) const { return weighs ? regions.weight(obstacle) : 0; }
};

}  // namespace waybreaker::crossing

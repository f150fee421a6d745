// Local search over tours: a good tour fast, without proof.
#pragma once

#include "flight/target.hpp"

namespace waybreaker {

// A tour no longer than the given one that neither a better cell for one stop, nor reversing a part of the tour, nor
// moving up to three stops elsewhere makes shorter. Deterministic. Time per round O(stops^2 + cells); few rounds.
Tour improved_tour(Point start, Tour tour, Point goal, std::span<const Target> targets, const Airspace& air = {});

}  // namespace waybreaker

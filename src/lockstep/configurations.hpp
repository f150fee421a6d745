// Where all vehicles are, one time after the other, until all are at their goals.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "lockstep/lattice.hpp"

namespace waybreaker::lockstep {

using Configuration = std::vector<Site>;

// From `starts` to `goals`: in each step none ends where another does, no two swap places, and no more of them go round
// in a circle. By LaCAM (Okumura: LaCAM: search-based algorithm for quick multi-agent pathfinding, AAAI 2023), whose
// configurations come from PIBT (Okumura, Machida, Défago, Tamura, Artificial Intelligence 310, 2022). Depth first, so
// the first plan is a quick one, not a good one. None after so many configurations, or if `due`. Another seed may find
// one where this one strays. `left` holds each vehicle's distances to its goal.
std::optional<std::vector<Configuration>> move_all(const Lattice& lattice, const Configuration& starts,
                                                   const Configuration& goals,
                                                   std::span<const std::vector<std::uint32_t>> left, std::uint64_t seed,
                                                   std::size_t most_configurations, const std::function<bool()>& due);

}  // namespace waybreaker::lockstep

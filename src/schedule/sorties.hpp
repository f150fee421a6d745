// Sorties: who of several aircraft breaches which target, in which order and from which cells. Local search: good
// sorties fast, without proof.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "flight/target.hpp"
#include "model/objective.hpp"
#include "schedule/precedence.hpp"

namespace waybreaker {

// The tours of all aircraft, in their order.
using Sorties = std::vector<Tour>;

// By more than rounding: 1e-9 of the figure.
bool is_better(const Rank& a, const Rank& b);

class SortieSearch {
  public:
    // `due`: whether time is over. All arguments must outlive it.
    SortieSearch(std::span<const Agent* const> aircraft, std::span<const Target> targets, const Precedence& precedence,
                 Objective objective, const std::function<bool()>& due)
        : aircraft_(aircraft),
          targets_(targets),
          precedence_(precedence),
          objective_(objective),
          due_(due),
          recharge_(std::ranges::any_of(aircraft, [](const Agent* agent) { return agent->recharge.has_value(); })) {}

    // By the objective, with the landings of with_landings; infinity where a vehicle has no drive, or an aircraft would
    // fly too far.
    Rank rank_of(const Sorties& sorties) const;
    // With the landings with which they are best, of those that each aircraft could make, one after the other; without
    // any where there is no way to land.
    Sorties with_landings(Sorties sorties) const;
    // Those below pass landings by; with_landings adds them.
    //
    // The best of those that insert one target after the other, each where it costs least: in the order given, and,
    // where they are few, in every order; then improved. None if the aircraft may not breach as many.
    // Targets that the order leaves out open by themselves.
    std::optional<Sorties> find(std::vector<std::size_t> order) const;
    // Moves single targets and exchanges cells while that gains.
    void improve(Sorties& sorties) const;

  private:
    std::optional<Sorties> shared_out(const std::vector<std::size_t>& order) const;
    Tour shortest(std::size_t aircraft, const std::vector<std::size_t>& share) const;
    Tour shortest_with_landings(std::size_t aircraft, std::vector<std::size_t> share) const;
    bool insert(Sorties& sorties, std::size_t target) const;
    bool move_one(Sorties& sorties, Rank& least) const;
    bool exchange_cells(Sorties& sorties, Rank& least) const;
    Rank rank_as_given(const Sorties& sorties) const;

    std::span<const Agent* const> aircraft_;
    std::span<const Target> targets_;
    const Precedence& precedence_;
    Objective objective_;
    const std::function<bool()>& due_;
    bool recharge_;  // whether any of them may
};

}  // namespace waybreaker

// Large neighbourhood search over the paths of a team (Li, Chen, Harabor, Stuckey, Koenig: MAPF-LNS, IJCAI 2021;
// MAPF-LNS2, AAAI 2022): take the paths of a few vehicles away, plan these one after the other past all the rest, keep
// what is better.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "team/fleet.hpp"

namespace waybreaker::team {

// The same numbers everywhere, which the standard's distributions do not promise (Steele, Lea, Flood: SplitMix 2014).
class Random {
  public:
    // From 0 to count - 1. REQUIRES: count > 0.
    std::size_t below(std::size_t count) {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return std::size_t((z ^ (z >> 31U)) % count);
    }
    template <class Value>
    void shuffle(std::vector<Value>& values) {
        for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
    }

  private:
    std::uint64_t state_ = 0;
};

class NeighbourhoodSearch {
  public:
    NeighbourhoodSearch(Fleet& fleet, const Interrupts& interrupts) : fleet_(fleet), interrupts_(interrupts) {}

    // Until every vehicle has a path, time is over, or so many tries have failed to help.
    void repair();
    // Until nobody loses time on the others, time is over, or so many tries in a row have gained nothing. Calls
    // `gained` after each that has.
    void improve(const std::function<void()>& gained);

  private:
    std::vector<std::uint32_t> around(std::uint32_t vehicle, std::size_t most);
    std::optional<std::uint32_t> delayed();
    bool replan(const std::vector<std::uint32_t>& order, bool repairing);

    Fleet& fleet_;
    const Interrupts& interrupts_;
    Random random_;
};

}  // namespace waybreaker::team

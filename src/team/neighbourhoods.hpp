// Large neighbourhood search over the paths of a team (Li, Chen, Harabor, Stuckey, Koenig: MAPF-LNS, IJCAI 2021;
// MAPF-LNS2, AAAI 2022): take the paths of a few vehicles away, plan these one after the other past all the rest, keep
// what is better.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "team/fleet.hpp"

namespace waybreaker::team {

class NeighbourhoodSearch {
  public:
    NeighbourhoodSearch(Fleet& fleet, const Interrupts& interrupts) : fleet_(fleet), interrupts_(interrupts) {}

    // Until every vehicle has a path, time is over, or so many tries have failed to help.
    void repair();
    // Plans each that loses time once again. Whether any has gained. REQUIRES: all have a path.
    bool shorten_waits();
    // Until the objective is no more than `enough`, nobody loses time on the others, time is over, or so many tries in
    // a row have gained nothing. Calls `gained` after each that has.
    void improve(double enough, const std::function<void()>& gained);

  private:
    std::vector<std::uint32_t> around(std::uint32_t vehicle, std::size_t most);
    double delay(std::uint32_t vehicle) const;
    std::optional<std::uint32_t> delayed();
    bool replan(const std::vector<std::uint32_t>& order, bool repairing);

    Fleet& fleet_;
    const Interrupts& interrupts_;
    Random random_{0};
};

}  // namespace waybreaker::team

// Landings: where on a tour an aircraft recharges.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "flight/target.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// A stop of a tour, at one of these cells.
struct Visit {
    std::size_t target = 0;
    std::vector<Cell> cells;
};

// Tours past all of these, in that order, with landings for which the battery is enough: of those at the same cells
// none that leaves every stop later than another. The one that is home first comes first; where they are many, some are
// left out. None where no way was found. stay(target): how long the aircraft stays there, in units of time. REQUIRES:
// it recharges.
std::vector<Tour> with_landings(const Agent& aircraft, std::span<const Visit> visits,
                                const std::function<double(std::size_t)>& stay);
// The same at the cells of a tour without landings.
std::vector<Tour> with_landings(const Agent& aircraft, const Tour& tour,
                                const std::function<double(std::size_t)>& stay);

}  // namespace waybreaker

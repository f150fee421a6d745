// Every set that may be removed, where these are few: none of them needs to be guessed then.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

// All sets of at most `largest` of the obstacles that are allowed, the empty one first, the smaller ones before the
// larger. Empty if there are more than `most`. REQUIRES: the obstacles ascend; no part of an allowed set is not
// allowed.
std::vector<std::vector<ObstacleId>> all_sets(std::span<const ObstacleId> obstacles, int largest,
                                              const std::function<bool(std::span<const ObstacleId>)>& allowed,
                                              std::size_t most);

}  // namespace waybreaker

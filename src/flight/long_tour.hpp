// A good tour of many targets, without proof: see docs/flight.md.
#pragma once

#include "core/stopwatch.hpp"
#include "flight/target.hpp"

namespace waybreaker {

// A tour no longer than `known` that no better cells, order (2-opt, Or-opt), or re-planned part of `exact_window` stops
// in a row makes shorter by more than rounding; or the best one found before the deadline. Deterministic but for that.
inline constexpr std::size_t exact_window = 6;
Tour good_tour(Point start, Point goal, std::span<const Target> targets, const Tour& known, const Airspace& air = {},
               const Deadline& deadline = Deadline());

}  // namespace waybreaker

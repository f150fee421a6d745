// Tuning of the crossing search: every constant that was chosen by measuring, not by proof. Paths and bounds are right
// whatever they are: they decide how long a search takes, and those marked BOUND also how much is proven. What was
// tried besides: docs/notes/tried.md.
#pragma once

#include <cstddef>
#include <cstdint>

namespace waybreaker::crossing::tuning {

// Ellipses (search.cpp). Shares of the least cost by which the limit of the first ellipse lies above it; then it grows
// by the factors below. Other growth, 1.5 to 8 times, is within 10 %, better here and worse there.
inline constexpr double first_slack = 0.002;
inline constexpr double first_slack_with_guess = 0.004;  // the caller expects a cost, which is near the truth
inline constexpr double first_slack_of_detours = 0.4;    // nothing can be crossed, or the search is weighted
inline constexpr double small_slack = 0.02;              // below it the slack grows faster
inline constexpr double growth_of_small_slack = 4;
inline constexpr double growth_of_slack = 2;
inline constexpr double largest_slack = 2;   // then at once to the longest path that matters
inline constexpr double last_stretch = 1.5;  // likewise where so many times the slack would reach beyond it

// Fan (geometry/fan.cpp). Bends of an outline that are followed to see whether a corner leads into a notch: 1.5 times
// fewer labels than without, and fewer bends gain nothing. The cells to look at, on each side, grow with it.
inline constexpr int longest_notch = 8;
inline constexpr int widest_notch = 16;  // cells

// Convex obstacles (geometry/convex.cpp). Cells of the box around an obstacle: in larger ones, which would take longer
// to look at than they save, it counts as not convex.
inline constexpr std::int64_t largest_convex_box = 1 << 14;

// Grown maps (geometry/regions.cpp). Members of all regions together; with more the map counts as too dense for so wide
// a body. That is about as much memory as a map of 4096 x 4096.
inline constexpr std::size_t most_region_members = std::size_t{1} << 23U;

// Cost to go where nothing else opens (labels/cost_to_go.cpp), BOUND. Labels expanded from one vertex: with 24 too
// little is learnt to gain anything, 64 take 11 % more instructions in all.
inline constexpr std::size_t most_expanded_for_cost_to_go = 256;
// The same for each label of the search itself, and labels that it is ahead at first (in_time/further_crossings.cpp):
// where sets are many, what is learnt of one serves few labels. With 4 or 1, 7 or 30 % more instructions; without a
// limit some missions on maps of sections take four times as long.
inline constexpr std::uint64_t cost_to_go_for_each_label = 8;
inline constexpr std::uint64_t labels_in_advance = 100;

// Lengths of paths to gates (in_time/path_lengths.hpp), BOUND. Labels expanded for one: with 40 or 32, weaker bounds,
// no faster in all. Lengths kept from one query to the next: some ten megabytes.
inline constexpr std::uint64_t most_expanded_for_length = 160;
inline constexpr std::size_t most_lengths = 1U << 16U;

// Bound by steps (steps/step_search.cpp). Nodes, of eight bytes if they are used, and labels expanded (BOUND): some ten
// seconds. Cells of the box around an obstacle up to which it is crossed at once, without nodes: half the time.
inline constexpr std::uint64_t most_step_nodes = std::uint64_t{1} << 28U;
inline constexpr std::uint64_t most_steps_expanded = std::uint64_t{1} << 26U;
inline constexpr std::uint64_t small_box = 25;
// Bits of a cost that do not tell buckets apart: a bucket is a sixteenth of a cell wide (steps/buckets.hpp).
inline constexpr unsigned bucket_bits = 10;

}  // namespace waybreaker::crossing::tuning

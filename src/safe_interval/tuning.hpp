// Tuning of the search past others that move: every constant that was chosen by measuring, not by proof. Paths keep
// clear of all others whatever they are: they decide how long a search takes, and those marked PATH also how early the
// path arrives. What was tried besides: docs/notes/tried.md, teams without aircraft.
#pragma once

#include <cstddef>

namespace waybreaker::safe_interval::tuning {

// Regions that are searched (searcher.cpp). Cells of a map up to which all of it is; in a larger one, first the tiles
// next to the known path. PATH.
inline constexpr std::size_t small_map = 4096;
// Cells of driving or waiting that the path next to the known one may lose before paths farther off are tried: about as
// far as an agent goes around another without leaving that region. 3 and 5 cells give the same flowtime, and first
// plans take 35 and 15 % longer. PATH.
inline constexpr double least_loss = 10;
// Cells of a map beyond which that is never tried: distances would take too long. PATH.
inline constexpr std::size_t largest_map = std::size_t{1} << 22U;
// Lengths, in cells, to which the length of paths farther off is rounded up, so that the next search finds its
// distances known.
inline constexpr double length_unit = 16;

// Distances (distances.hpp, distance_memory.cpp). Cells on a side of a tile: how far a path next to the known one may
// stray, four to eight. PATH. Bytes kept for later searches.
inline constexpr int tile_side = 4;
inline constexpr std::size_t most_bytes = std::size_t{1} << 27U;
// Cells on a side of a tile of steps that are looked at once for all searches (open_steps.hpp).
inline constexpr std::size_t step_tile_side = 64;

// Index of discs in motion (traffic.cpp). Cells on a side of its squares: small ones where there is much traffic to a
// cell, doubled until there are no more squares than this.
inline constexpr int least_square_side = 4;
inline constexpr std::size_t most_squares = std::size_t{1} << 18U;

}  // namespace waybreaker::safe_interval::tuning

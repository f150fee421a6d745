// The 3 x 3 cells around a cell as nine bits, and what follows from them: which steps are legal, which survive JPS's
// pruning.
//
// Bit 3 * (dy + 1) + (dx + 1) stands for the cell, or the step, at offset (dx, dy); bit 4 is the middle.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numbers>

#include "waybreaker/body.hpp"

namespace waybreaker {

using Neighbourhood = std::uint16_t;  // a set of offsets

struct Step {
    int dx;
    int dy;
    double cost;
};

inline constexpr double diagonal_cost = std::numbers::sqrt2;

inline constexpr std::array<Step, 9> steps{{{-1, -1, diagonal_cost},
                                            {0, -1, 1},
                                            {1, -1, diagonal_cost},
                                            {-1, 0, 1},
                                            {0, 0, 0},
                                            {1, 0, 1},
                                            {-1, 1, diagonal_cost},
                                            {0, 1, 1},
                                            {1, 1, diagonal_cost}}};

constexpr int step_index(int dx, int dy) {
    return 3 * (dy + 1) + dx + 1;
}
constexpr Neighbourhood step_bit(int dx, int dy) {
    return Neighbourhood(1U << step_index(dx, dy));
}

// Blocked cells around a cell of the map; the frame around the map counts as blocked.
inline Neighbourhood blocked_around(const OpenedMap& map, Cell c) {
    const unsigned word = unsigned(c.x) / 64;
    const unsigned shift = unsigned(c.x) % 64;
    const auto three = [&](const std::uint64_t* line) {
        return unsigned((line[word] >> shift) | (line[word + 1] << 1 << (63 - shift))) & 7U;
    };
    return Neighbourhood(three(map.row(c.y - 1)) | three(map.row(c.y)) << 3 | three(map.row(c.y + 1)) << 6);
}

template <class Visit>
void for_each_offset(Neighbourhood set, Visit visit) {
    for (unsigned rest = set; rest != 0; rest &= rest - 1) visit(std::countr_zero(rest));
}

// For every pattern of blocked cells the steps that may be taken from the middle.
using StepTable = std::array<Neighbourhood, 512>;
const StepTable& legal_steps(Corners corners, bool diagonal);

// JPS: for every pattern and every step by which the middle was reached, the steps that are not pruned: those to which
// no path inside the 3 x 3 cells that avoids the middle is as short (after a straight step) or shorter (after a
// diagonal one). (Harabor and Grastien 2011, section "Neighbour pruning rules"; computed from that definition for each
// corner rule.)
using PrunedStepTable = std::array<std::array<Neighbourhood, 9>, 512>;
const PrunedStepTable& unpruned_steps(Corners corners);

}  // namespace waybreaker

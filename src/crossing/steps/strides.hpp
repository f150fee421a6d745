// Strides: moves from cell to cell, and what they cost: docs/exact.md, Theorem 5.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "waybreaker/cell.hpp"

namespace waybreaker::crossing {

// Costs are integers, rounded down. A straight step and a diagonal one after the other may lead straight to where they
// end: a stride.
inline constexpr std::uint32_t step_cost = 1U << 14U;
inline constexpr std::uint32_t diagonal_cost = 23170;  // sqrt(2)
inline constexpr std::uint32_t stride_cost = 36635;    // sqrt(5)
// No straight piece of a path is so much shorter than its steps and strides: sqrt(10 - 4 sqrt(5)).
inline constexpr double most_of_line = 1.0274864;

// Cost of the cheapest steps and strides over free ground.
inline std::uint32_t cost_between(Cell a, Cell b) {
    const auto x = std::uint32_t(std::abs(a.x - b.x));
    const auto y = std::uint32_t(std::abs(a.y - b.y));
    const auto [shorter, longer] = std::minmax(x, y);
    return 2 * shorter <= longer ? (longer - 2 * shorter) * step_cost + shorter * stride_cost
                                 : (2 * shorter - longer) * diagonal_cost + (longer - shorter) * stride_cost;
}

// The cells around one, two each way: bit 5 (dy + 2) + dx + 2.
using Around = std::uint32_t;
constexpr Around bit_of(int dx, int dy) {
    return Around{1} << unsigned(5 * (dy + 2) + dx + 2);
}

struct Move {
    int dx;
    int dy;
    std::uint32_t cost;
    // Free, these or those.
    Around needs;
    Around or_needs;
};

constexpr std::array<Move, 16> make_moves() {
    std::array<Move, 16> moves{};
    std::size_t count = 0;
    for (const int s : {-1, 1}) {
        const Around straight = bit_of(s, 0);
        const Around steep = bit_of(0, s);
        moves[count++] = {s, 0, step_cost, straight, straight};
        moves[count++] = {0, s, step_cost, steep, steep};
        for (const int t : {-1, 1}) {
            const Around beside = bit_of(s, 0) | bit_of(0, t) | bit_of(s, t);
            moves[count++] = {s, t, diagonal_cost, beside, beside};
            const Around flat = bit_of(s, 0) | bit_of(s, t) | bit_of(2 * s, t);
            moves[count++] = {2 * s, t, stride_cost, flat | bit_of(2 * s, 0), flat | bit_of(0, t)};
            const Around upright = bit_of(0, t) | bit_of(s, t) | bit_of(s, 2 * t);
            moves[count++] = {s, 2 * t, stride_cost, upright | bit_of(0, 2 * t), upright | bit_of(s, 0)};
        }
    }
    return moves;
}
inline constexpr std::array<Move, 16> moves = make_moves();
inline constexpr Around next_to = [] {
    Around cells = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) cells |= bit_of(dx, dy);
    }
    return cells;
}();

}  // namespace waybreaker::crossing

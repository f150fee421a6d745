// Piece: some cells of one target and the box around them, what the exact flight works with while it need not know the
// very cell.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker {

struct Piece {
    std::size_t target;
    std::span<Cell> cells;  // never empty; splitting reorders them
    Box box;                // the smallest around the cells
    std::size_t whole;      // what it is a part of, as an index into the pieces it was made from
};

Piece make_piece(std::size_t target, std::span<Cell> cells, std::size_t whole);

// Halves a piece `times` times across the longer side of its box, or until its cells are single, and appends the parts.
void split(const Piece& piece, std::size_t whole, int times, std::vector<Piece>& parts);

bool before_in_scan(Cell a, Cell b);

Box box_of(Cell c);
Box united(const Box& a, const Box& b);

// Distance of the nearest two cells two boxes can hold, squared.
inline double squared_gap(const Box& a, const Box& b) {
    const double dx = std::max({a.min.x - b.max.x, b.min.x - a.max.x, 0});
    const double dy = std::max({a.min.y - b.max.y, b.min.y - a.max.y, 0});
    return dx * dx + dy * dy;
}

// Of a place and the nearest cell that a box can hold, squared.
inline double squared_gap(Point a, const Box& b) {
    const double dx = std::max({a.x - b.max.x, b.min.x - a.x, 0.0});
    const double dy = std::max({a.y - b.max.y, b.min.y - a.y, 0.0});
    return dx * dx + dy * dy;
}

}  // namespace waybreaker

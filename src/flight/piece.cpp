#include "flight/piece.hpp"

#include <algorithm>

namespace waybreaker {

Piece make_piece(std::size_t target, std::span<Cell> cells, std::size_t whole) {
    Box box = box_of(cells.front());
    for (const Cell c : cells) box = united(box, box_of(c));
    return {target, cells, box, whole};
}

void split(const Piece& piece, std::size_t whole, int times, std::vector<Piece>& parts) {
    if (times == 0 || piece.cells.size() == 1) {
        parts.push_back({piece.target, piece.cells, piece.box, whole});
        return;
    }
    const std::size_t half = piece.cells.size() / 2;
    const bool wide = piece.box.max.x - piece.box.min.x >= piece.box.max.y - piece.box.min.y;
    std::ranges::nth_element(piece.cells, piece.cells.begin() + std::ptrdiff_t(half),
                             [wide](Cell a, Cell b) { return wide ? a < b : before_in_scan(a, b); });
    split(make_piece(piece.target, piece.cells.first(half), whole), whole, times - 1, parts);
    split(make_piece(piece.target, piece.cells.subspan(half), whole), whole, times - 1, parts);
}

bool before_in_scan(Cell a, Cell b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

Box box_of(Cell c) {
    return {c, c};
}

Box united(const Box& a, const Box& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

}  // namespace waybreaker

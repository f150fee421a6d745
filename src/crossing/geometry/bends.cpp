#include "crossing/geometry/bends.hpp"

namespace waybreaker::crossing {

void Bends::start_query(const Map& map) {
    if (map_ == map.identity()) return;
    map_ = map.identity();
    bends_.assign(1, {});
    after_.assign(1, {});
    slots_.assign(1024, {});
}

std::uint64_t Bends::key_of(const Side& side) {
    const Step out = side.outward;
    const unsigned way =
        unsigned(out.x + 1) << 1U | unsigned(out.y + 1) << 3U | unsigned(side.along.x + side.along.y > 0);
    return std::uint64_t(std::uint32_t(side.cell.x)) << 37U | std::uint64_t(std::uint32_t(side.cell.y)) << 5U | way;
}

std::uint32_t Bends::ahead(const Outline& outline, Side side) {
    Outline::Turn turn = outline.turn(side);
    while (turn == Outline::Turn::straight) {
        side = Outline::next(side, turn);
        turn = outline.turn(side);
    }
    const std::uint64_t key = key_of(side);
    std::size_t slot = slot_of(key);
    while (slots_[slot].bend != 0) {
        if (slots_[slot].key == key) return slots_[slot].bend;
        slot = (slot + 1) & (slots_.size() - 1);
    }
    const auto bend = std::uint32_t(bends_.size());
    const bool convex = turn == Outline::Turn::away;
    bends_.push_back({.at = outline.bend(side, turn), .quadrant = convex ? -(side.along + side.outward) : Step{}});
    after_.push_back(Outline::next(side, turn));
    slots_[slot] = {key, bend};
    if (2 * bends_.size() >= slots_.size()) grow();
    return bend;
}

void Bends::grow() {
    std::vector<Slot> smaller(2 * slots_.size());
    smaller.swap(slots_);
    for (const Slot& known : smaller) {
        if (known.bend == 0) continue;
        std::size_t slot = slot_of(known.key);
        while (slots_[slot].bend != 0) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = known;
    }
}

}  // namespace waybreaker::crossing

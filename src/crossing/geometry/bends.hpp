// Bends: where outlines turn, linked in the order in which one follows them. Traced when first followed and kept for as
// long as the map is the same, so that its cells are looked at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "crossing/geometry/outline.hpp"

namespace waybreaker::crossing {

// A bend of an outline followed in one direction; in the other it is another one.
struct Bend {
    Vertex at;
    Step quadrant;           // if convex: where the obstacle is; else (0, 0)
    std::uint32_t next = 0;  // the bend after it; 0: not known yet
    std::uint64_t seen = 0;  // the last look that came by
};

class Bends {
  public:
    void start_query(const Map& map);

    // The bend at the end of the straight run that a side is part of.
    std::uint32_t ahead(const Outline& outline, Side side);
    std::uint32_t next(const Outline& outline, std::uint32_t bend) {
        if (bends_[bend].next == 0) {
            const std::uint32_t found = ahead(outline, after_[bend]);
            bends_[bend].next = found;
        }
        return bends_[bend].next;
    }
    Bend& operator[](std::uint32_t bend) { return bends_[bend]; }

  private:
    // Key of a bend: the cell, the side that ends there, and the direction along it, in one number.
    static std::uint64_t key_of(const Side& side);
    std::size_t slot_of(std::uint64_t key) const {
        return std::size_t((key * 0x9e3779b97f4a7c15U) >> 29) & (slots_.size() - 1);
    }
    void grow();

    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t bend = 0;  // 0: empty
    };
    std::shared_ptr<const void> map_;  // the identity of the map they are of
    std::vector<Bend> bends_;          // from 1
    std::vector<Side> after_;          // the side that each goes on with
    std::vector<Slot> slots_;          // hash table, open addressing
};

}  // namespace waybreaker::crossing

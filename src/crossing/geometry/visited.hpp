// Visited: the corners that one expansion has noted before, so that none is noted twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossing/geometry/lattice.hpp"

namespace waybreaker::crossing {

// A small cache that may forget, which costs time only.
class Visited {
  public:
    void clear() { ++round_; }

    // Whether v was noted on that side (below 64) since clear(); now it is.
    bool before(Vertex v, unsigned side) {
        const std::uint64_t key =
            (std::uint64_t(std::uint32_t(v.x)) << 38) ^ (std::uint64_t(std::uint32_t(v.y)) << 6) ^ side;
        Slot& slot = slots_[std::size_t((key * 0x9e3779b97f4a7c15U) >> 53)];
        if (slot.key == key && slot.round == round_) return true;
        slot = {key, round_};
        return false;
    }

  private:
    struct Slot {
        std::uint64_t key = 0;
        std::uint64_t round = 0;
    };
    std::vector<Slot> slots_ = std::vector<Slot>(2048);
    std::uint64_t round_ = 1;
};

}  // namespace waybreaker::crossing

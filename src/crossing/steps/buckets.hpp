// Buckets: the open list of a search whose costs are integers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossing/tuning.hpp"

namespace waybreaker::crossing {

// Entries in buckets of a sixteenth of a cell; within one the last comes first.
template <class Entry>
class Buckets {
  public:
    explicit Buckets(std::uint32_t first) : first_(first >> tuning::bucket_bits) {}

    void push(std::uint32_t key, const Entry& entry) {
        const std::size_t bucket = std::max<std::size_t>((key >> tuning::bucket_bits) - first_, current_);
        if (bucket >= heads_.size()) heads_.resize(bucket + bucket / 2 + 64, none);
        std::uint32_t slot = free_;
        if (slot != none) {
            free_ = slots_[slot].next;
            slots_[slot] = {entry, heads_[bucket]};
        } else {
            slot = std::uint32_t(slots_.size());
            slots_.push_back({entry, heads_[bucket]});
        }
        heads_[bucket] = slot;
        ++count_;
    }
    bool empty() const { return count_ == 0; }
    // Precondition: not empty.
    Entry pop() {
        while (heads_[current_] == none) ++current_;
        const std::uint32_t slot = heads_[current_];
        heads_[current_] = slots_[slot].next;
        slots_[slot].next = free_;
        free_ = slot;
        --count_;
        return slots_[slot].entry;
    }
    // No entry has a smaller key.
    std::uint32_t least() const { return std::uint32_t(first_ + current_) << tuning::bucket_bits; }

  private:
    static constexpr std::uint32_t none = UINT32_MAX;
    struct Slot {
        Entry entry;
        std::uint32_t next;
    };
    std::size_t first_;
    std::size_t current_ = 0;
    std::vector<std::uint32_t> heads_;  // by bucket
    std::vector<Slot> slots_;
    std::uint32_t free_ = none;
    std::size_t count_ = 0;
};

}  // namespace waybreaker::crossing

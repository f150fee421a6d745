// Open list: entries in the total order (f, larger or smaller g, cell), so that runs repeat to the bit.
//
// Entries wait unsorted in buckets of f, 1/64 of a cell wide; a bucket is sorted when its turn comes. So an entry is
// compared with a few others only, and one that is never taken with none. A node whose g falls is pushed again and
// closed when the better entry surfaces; the search skips the older one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/node_store.hpp"

namespace waybreaker {

struct OpenEntry {
    double f;
    float g;  // settles ties of f only, so that an entry fits into 16 bytes
    CellKey key;
};

// Ties: which of two entries with equal f comes first, the one with the larger g or the smaller.
struct LargerGFirst {
    static bool before(const OpenEntry& a, const OpenEntry& b) {
        if (a.f != b.f) return a.f < b.f;
        if (a.g != b.g) return a.g > b.g;
        return a.key.value < b.key.value;
    }
};
struct SmallerGFirst {
    static bool before(const OpenEntry& a, const OpenEntry& b) {
        if (a.f != b.f) return a.f < b.f;
        if (a.g != b.g) return a.g < b.g;
        return a.key.value < b.key.value;
    }
};

// Memory of an open list, reused from query to query.
struct OpenMemory {
    struct Waiting {
        OpenEntry entry;
        std::uint32_t next;  // in the same bucket
    };
    std::vector<OpenEntry> sorted;
    std::vector<Waiting> waiting;
    std::vector<std::uint32_t> buckets;  // first of each bucket's chain
};

template <class Order>
class OpenList {
  public:
    explicit OpenList(OpenMemory& memory) : sorted_(memory.sorted), waiting_(memory.waiting), buckets_(memory.buckets) {
        sorted_.clear();
        buckets_.clear();
    }

    bool empty() const { return sorted_.empty() && waiting_count_ == 0; }

    void push(const OpenEntry& entry) {
        if (is_first_) least_f_ = entry.f;
        is_first_ = false;
        const std::size_t bucket = bucket_of(entry.f);
        if (bucket <= current_) {
            insert(entry);
            return;
        }
        if (bucket >= buckets_.size()) buckets_.resize(bucket + 1, none);
        std::uint32_t slot = free_;
        if (slot != none) {
            free_ = waiting_[slot].next;
        } else {
            slot = used_++;
            if (slot == waiting_.size()) waiting_.resize(2 * waiting_.size() + 64);
        }
        waiting_[slot] = {entry, buckets_[bucket]};
        buckets_[bucket] = slot;
        ++waiting_count_;
    }

    // Precondition: not empty.
    OpenEntry pop() {
        while (sorted_.empty()) advance();
        const OpenEntry first = sorted_.back();
        sorted_.pop_back();
        return first;
    }

  private:
    static constexpr double buckets_per_cell = 64;
    static constexpr std::size_t few = 32;                // up to so many entries insertion sort is the fastest
    static constexpr std::size_t last_bucket = 1U << 20;  // whatever lies beyond shares it
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::size_t bucket_of(double f) const {
        const double bucket = (f - least_f_) * buckets_per_cell;
        return bucket <= 0 ? 0 : bucket < double(last_bucket) ? std::size_t(bucket) : last_bucket;
    }

    // Moves the next bucket among the sorted.
    void advance() {
        std::uint32_t slot = buckets_[++current_];
        buckets_[current_] = none;
        while (slot != none) {
            sorted_.push_back(waiting_[slot].entry);
            const std::uint32_t next = waiting_[slot].next;
            waiting_[slot].next = free_;
            free_ = slot;
            slot = next;
            --waiting_count_;
        }
        if (sorted_.size() > few) {
            std::sort(sorted_.begin(), sorted_.end(), comes_later);
        } else {
            for (std::size_t end = 1; end < sorted_.size(); ++end) sink(end);
        }
    }

    void insert(const OpenEntry& entry) {
        if (sorted_.size() > few) {
            sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), entry, comes_later), entry);
        } else {
            sorted_.push_back(entry);
            sink(sorted_.size() - 1);
        }
    }

    // Insertion sort's step: moves the entry at `end` to its place among those before it.
    void sink(std::size_t end) {
        const OpenEntry entry = sorted_[end];
        for (; end > 0 && Order::before(sorted_[end - 1], entry); --end) sorted_[end] = sorted_[end - 1];
        sorted_[end] = entry;
    }

    static bool comes_later(const OpenEntry& a, const OpenEntry& b) { return Order::before(b, a); }

    std::vector<OpenEntry>& sorted_;  // the current bucket, its first entry last
    std::vector<OpenMemory::Waiting>& waiting_;
    std::vector<std::uint32_t>& buckets_;
    std::uint32_t used_ = 0;         // slots of waiting_ that were ever used by this query
    std::uint32_t free_ = none;      // slots of waiting_ to be used again
    std::size_t waiting_count_ = 0;  // entries in buckets
    std::size_t current_ = 0;        // bucket that is sorted; earlier f go there too
    bool is_first_ = true;
    double least_f_ = 0;  // where bucket 0 begins: the f of the first entry
};

}  // namespace waybreaker

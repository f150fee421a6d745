// Open list: entries in the total order (f, larger or smaller g, cell), so that runs repeat to the bit.
//
// Entries near the least f lie in a 4-ary heap, the others unsorted in buckets of f, one sixteenth of a cell wide; a
// bucket moves into the heap when its turn comes. So most entries are sorted among few others, and those never taken
// not at all. A node whose g falls is pushed again and closed when the better entry surfaces; the search skips the
// older one.
#pragma once

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

// Of two entries with equal f, the one with the larger g comes first, or the smaller.
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
    std::vector<OpenEntry> heap;
    std::vector<Waiting> waiting;
    std::vector<std::uint32_t> buckets;  // first of each bucket's chain
};

template <class Order>
class OpenList {
  public:
    explicit OpenList(OpenMemory& memory) : heap_(memory.heap), waiting_(memory.waiting), buckets_(memory.buckets) {
        heap_.clear();
        buckets_.clear();
    }

    bool empty() const { return heap_.empty() && waiting_count_ == 0; }

    void push(const OpenEntry& entry) {
        if (is_first_) least_f_ = entry.f;
        is_first_ = false;
        const std::size_t bucket = bucket_of(entry.f);
        if (bucket <= current_) {
            push_heap(entry);
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
        while (heap_.empty()) advance();
        return pop_heap();
    }

  private:
    static constexpr double buckets_per_cell = 32;
    static constexpr std::size_t last_bucket = 1U << 20;  // whatever lies beyond shares it
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    std::size_t bucket_of(double f) const {
        const double bucket = (f - least_f_) * buckets_per_cell;
        return bucket <= 0 ? 0 : bucket < double(last_bucket) ? std::size_t(bucket) : last_bucket;
    }

    // Moves the next bucket into the heap.
    void advance() {
        std::uint32_t slot = buckets_[++current_];
        buckets_[current_] = none;
        while (slot != none) {
            push_heap(waiting_[slot].entry);
            const std::uint32_t next = waiting_[slot].next;
            waiting_[slot].next = free_;
            free_ = slot;
            slot = next;
            --waiting_count_;
        }
    }

    void push_heap(const OpenEntry& entry) {
        std::size_t hole = heap_.size();
        heap_.push_back(entry);
        while (hole > 0) {
            const std::size_t parent = (hole - 1) / 4;
            if (!Order::before(entry, heap_[parent])) break;
            heap_[hole] = heap_[parent];
            hole = parent;
        }
        heap_[hole] = entry;
    }

    OpenEntry pop_heap() {
        const OpenEntry top = heap_.front();
        const OpenEntry moved = heap_.back();
        heap_.pop_back();
        const std::size_t size = heap_.size();
        if (size == 0) return top;
        std::size_t hole = 0;
        for (;;) {
            const std::size_t first = 4 * hole + 1;
            if (first >= size) break;
            const std::size_t end = first + 4 < size ? first + 4 : size;
            std::size_t best = first;
            for (std::size_t child = first + 1; child < end; ++child) {
                if (Order::before(heap_[child], heap_[best])) best = child;
            }
            if (!Order::before(heap_[best], moved)) break;
            heap_[hole] = heap_[best];
            hole = best;
        }
        heap_[hole] = moved;
        return top;
    }

    std::vector<OpenEntry>& heap_;
    std::vector<OpenMemory::Waiting>& waiting_;
    std::vector<std::uint32_t>& buckets_;
    std::uint32_t used_ = 0;         // slots of waiting_ that were ever used by this query
    std::uint32_t free_ = none;      // slots of waiting_ to be used again
    std::size_t waiting_count_ = 0;  // entries in buckets
    std::size_t current_ = 0;        // bucket that the heap stands for; earlier f go there too
    bool is_first_ = true;
    double least_f_ = 0;  // where bucket 0 begins: the f of the first entry
};

}  // namespace waybreaker

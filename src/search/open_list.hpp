// Open list: a 4-ary heap in the total order (f, larger or smaller g, cell), so that runs repeat to the bit.
//
// A node whose g falls is pushed again; the search skips the older entries when they surface (their g is not the
// node's). That costs a little room and saves writing every node's place in the heap at every swap.
#pragma once

#include <cstddef>
#include <vector>

#include "search/node_store.hpp"

namespace waybreaker {

struct OpenEntry {
    double f;
    double g;
    CellKey key;
};

// Of two entries with equal f, the one with the larger g first, or the smaller.
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

template <class Order>
class OpenList {
  public:
    explicit OpenList(std::vector<OpenEntry>& memory) : heap_(memory) { heap_.clear(); }

    bool empty() const { return heap_.empty(); }

    void push(const OpenEntry& entry) {
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

    OpenEntry pop() {
        const OpenEntry top = heap_.front();
        const OpenEntry moved = heap_.back();
        heap_.pop_back();
        if (heap_.empty()) return top;
        const std::size_t size = heap_.size();
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

  private:
    std::vector<OpenEntry>& heap_;
};

}  // namespace waybreaker

// Node store: what a search knows of each cell, 16 bytes a cell, reused from query to query without clearing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>

#include "waybreaker/cell.hpp"

namespace waybreaker {

// A cell in 32 bits, ordered by row, then column.
struct CellKey {
    std::uint32_t value;
    CellKey() = default;
    explicit CellKey(Cell c) : value(std::uint32_t(c.y) << 16 | std::uint32_t(c.x)) {}
    Cell cell() const { return {int(value & 0xFFFF), int(value >> 16)}; }
};

// All bits zero is a node that no query has seen.
struct Node {
    double g;
    CellKey parent;
    std::uint32_t stamp;  // 2 * query while open, 2 * query + 1 once closed; other values: not seen by this query
};

class NodeStore {
  public:
    // `first_query` is for tests of the wrap-around.
    explicit NodeStore(std::uint32_t first_query = 0) : stamp_(2 * first_query) {}

    // Forgets everything, in constant time. Pages of memory that no search has visited are never touched.
    void begin_query(int width, int height) {
        width_ = std::size_t(width);
        const std::size_t cells = width_ * std::size_t(height);
        if (size_ < cells) {
            nodes_.reset(static_cast<Node*>(std::calloc(cells, sizeof(Node))));
            size_ = nodes_ ? cells : 0;
            if (!nodes_) throw std::bad_alloc();
        }
        stamp_ += 2;
        if (stamp_ == 0) {  // wrapped around: old stamps could be mistaken for new ones
            std::fill_n(nodes_.get(), size_, Node{});
            stamp_ = 2;
        }
    }

    std::size_t index(Cell c) const { return std::size_t(c.y) * width_ + std::size_t(c.x); }
    std::size_t width() const { return width_; }
    Node& operator[](std::size_t index) { return nodes_[index]; }
    Node& at(Cell c) { return nodes_[index(c)]; }

    bool is_open(const Node& node) const { return node.stamp == stamp_; }
    bool is_closed(const Node& node) const { return node.stamp == stamp_ + 1; }
    double g(const Node& node) const {
        return (node.stamp | 1U) == stamp_ + 1 ? node.g : std::numeric_limits<double>::infinity();
    }
    // Whether this query has reached the node from that parent.
    bool has_parent(const Node& node, CellKey parent) const {
        return (node.stamp | 1U) == stamp_ + 1 && node.parent.value == parent.value;
    }
    void open(Node& node) const { node.stamp = stamp_; }
    void close(Node& node) const { node.stamp = stamp_ + 1; }

  private:
    struct Free {
        void operator()(Node* nodes) const { std::free(nodes); }
    };

    std::unique_ptr<Node[], Free> nodes_;
    std::size_t size_ = 0;
    std::size_t width_ = 0;
    std::uint32_t stamp_;
};

}  // namespace waybreaker

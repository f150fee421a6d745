#include "safe_interval/distances.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::safe_interval {
namespace {

float length(Cell a, Cell b) {
    return float(distance(a, b));
}

}  // namespace

// Lazy Theta* from the goal.
class Distances::Flood {
  public:
    Flood(Distances& distances, const LineOfSight& sight)
        : to_(distances), sight_(sight), settled_(distances.entries_.size()) {}

    // Whether it came to its end in time.
    bool run(Cell goal, const Deadline& deadline) {
        push(goal, {0, goal});
        for (unsigned turn = 1; !open_.empty(); ++turn) {
            if (turn % 1024 == 0 && deadline.passed()) return false;
            std::pop_heap(open_.begin(), open_.end());
            const Cell here = open_.back().cell;
            open_.pop_back();
            if (settled_[to_.index(here)]) continue;
            settle(here);
            for (const Cell step : steps) reach({here.x + step.x, here.y + step.y}, here);
        }
        return true;
    }

  private:
    struct Open {
        float length;
        Cell cell;
        bool operator<(const Open& other) const {
            return length != other.length ? length > other.length : cell > other.cell;
        }
    };

    void push(Cell cell, const Entry& entry) {
        to_.entries_[to_.index(cell)] = entry;
        open_.push_back({entry.length, cell});
        std::push_heap(open_.begin(), open_.end());
    }

    // As far as is known without a look: straight from what `by` goes to.
    void reach(Cell cell, Cell by) {
        const std::uint32_t at = to_.index(cell);
        if (at == none || settled_[at]) return;
        const Cell next = to_.next(by);
        const float far = to_.to_goal(next) + length(next, cell);
        if (far >= to_.entries_[at].length || !sight_.fits(cell) || !sight_.clear(by, cell)) return;
        push(cell, {far, next});
    }

    // Without sight of what it was to go to, it goes by the best neighbour that is settled.
    void settle(Cell here) {
        Entry& entry = to_.entries_[to_.index(here)];
        settled_[to_.index(here)] = 1;
        if (sight_.clear(here, entry.next)) return;
        entry.length = unknown;
        for (const Cell step : steps) {
            const Cell beside{here.x + step.x, here.y + step.y};
            const std::uint32_t at = to_.index(beside);
            if (at == none || !settled_[at] || !sight_.clear(here, beside)) continue;
            const float far = to_.entries_[at].length + length(here, beside);
            if (far < entry.length) entry = {far, beside};
        }
    }

    Distances& to_;
    const LineOfSight& sight_;
    std::vector<char> settled_;  // by entry
    std::vector<Open> open_;     // heap
};

Distances::Distances(const OpenedMap& map, const LineOfSight& sight, Cell goal, std::span<const Cell> way,
                     const Deadline& deadline)
    : right_(map.width()), bottom_(map.height()) {
    if (!way.empty()) {
        const auto [west, east] = std::ranges::minmax(way, {}, &Cell::x);
        const auto [north, south] = std::ranges::minmax(way, {}, &Cell::y);
        left_ = std::max(west.x - side, 0);
        top_ = std::max(north.y - side, 0);
        right_ = std::min(east.x + side + 1, map.width());
        bottom_ = std::min(south.y + side + 1, map.height());
    }
    columns_ = unsigned(right_ - left_ - 1) / side + 1;
    const unsigned rows = unsigned(bottom_ - top_ - 1) / side + 1;
    tiles_.assign(std::size_t(columns_) * rows, none);
    if (way.empty()) {
        for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) add_tile(tile);
    } else {
        add_tiles_near(way);
    }
    complete_ = Flood(*this, sight).run(goal, deadline);
}

void Distances::add_tile(std::uint32_t number) {
    if (tiles_[number] != none) return;
    tiles_[number] = std::uint32_t(entries_.size());
    entries_.resize(entries_.size() + std::size_t(side) * side);
}

void Distances::add_tiles_near(std::span<const Cell> way) {
    const int rows = int(tiles_.size() / columns_);
    const auto add_around = [&](double x, double y) {
        const int column = int(x - left_) / side;
        const int row = int(y - top_) / side;
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows - 1); ++r) {
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, int(columns_) - 1); ++c) {
                add_tile(unsigned(r) * columns_ + unsigned(c));
            }
        }
    };
    add_around(way[0].x, way[0].y);
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Cell a = way[i - 1];
        const Cell b = way[i];
        const int parts = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / (side / 2) + 1;
        for (int k = 1; k <= parts; ++k) {
            const double share = double(k) / parts;
            add_around(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
        }
    }
}

}  // namespace waybreaker::safe_interval

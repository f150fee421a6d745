#include "safe_interval/distances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace waybreaker::safe_interval {
namespace {

float length(Cell a, Cell b) {
    return float(distance(a, b));
}

}  // namespace

// Lazy Theta* from the goal, and from the cells of the way.
class Distances::Flood {
  public:
    Flood(Distances& distances, const LineOfSight& sight, OpenSteps& open_steps)
        : to_(distances),
          sight_(sight),
          open_steps_(open_steps),
          settled_(distances.entries_.size()),
          on_way_(settled_) {}

    // Whether it came to its end in time.
    bool run(std::span<const Cell> way, const Deadline& deadline) {
        push(way.back(), {0, way.back()});
        for (std::size_t i = way.size() - 1; i > 0; --i) {
            const std::uint32_t at = to_.index(way[i - 1]);
            const float along = to_.to_goal(way[i]) + length(way[i - 1], way[i]);
            if (along < to_.entries_[at].length) push(way[i - 1], {along, way[i]});
            on_way_[at] = 1;
        }
        for (unsigned turn = 1; !open_.empty(); ++turn) {
            if (turn % 1024 == 0 && deadline.passed()) return false;
            std::pop_heap(open_.begin(), open_.end());
            const Cell here = open_.back().cell;
            open_.pop_back();
            if (settled_[to_.index(here)]) continue;
            settle(here);
            open_steps_.from(here, sight_, [&](Cell beside) { reach(beside, here); });
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

    // Estimates without a look: straight from what `by` goes to. A cell of the way has a length to keep, so it
    // looks first.
    void reach(Cell cell, Cell by) {
        const std::uint32_t at = to_.index(cell);
        if (at == none || settled_[at]) return;
        const Cell next = to_.next(by);
        const float far = to_.to_goal(next) + length(next, cell);
        if (far >= to_.entries_[at].length) return;
        if (on_way_[at] && !sight_.clear(cell, next)) return;
        push(cell, {far, next});
    }

    // Takes the best of what its settled neighbours go to, if that is in sight, and of these themselves.
    void settle(Cell here) {
        Entry& entry = to_.entries_[to_.index(here)];
        settled_[to_.index(here)] = 1;
        if (!sight_.clear(here, entry.next)) entry.length = unknown;
        Cell hidden = entry.next;
        open_steps_.from(here, sight_, [&](Cell beside) {
            const std::uint32_t at = to_.index(beside);
            if (at == none || !settled_[at]) return;
            const auto [rest, next] = to_.entries_[at];
            const float straight = to_.to_goal(next) + length(here, next);
            if (straight < entry.length && next != hidden) {
                if (sight_.clear(here, next)) {
                    entry = {straight, next};
                    return;
                }
                hidden = next;
            }
            if (const float by = rest + length(here, beside); by < entry.length) entry = {by, beside};
        });
    }

    Distances& to_;
    const LineOfSight& sight_;
    OpenSteps& open_steps_;
    std::vector<char> settled_;  // by entry, as the next
    std::vector<char> on_way_;
    std::vector<Open> open_;  // heap
};

Distances::Distances(const OpenedMap& map, const LineOfSight& sight, OpenSteps& open_steps, std::span<const Cell> way,
                     Region region, const Deadline& deadline) {
    const auto [west, east] = std::ranges::minmax(way, {}, &Cell::x);
    const auto [north, south] = std::ranges::minmax(way, {}, &Cell::y);
    const double most_aside = region == along_the_path ? side : region.longest / 2;
    const int aside = int(std::min(most_aside, double(std::max(map.width(), map.height()))));
    left_ = std::max(west.x - aside, 0);
    top_ = std::max(north.y - aside, 0);
    right_ = std::min(east.x + aside + 1, map.width());
    bottom_ = std::min(south.y + aside + 1, map.height());
    columns_ = unsigned(right_ - left_ - 1) / side + 1;
    const unsigned rows = unsigned(bottom_ - top_ - 1) / side + 1;
    tiles_.assign(std::size_t(columns_) * rows, none);
    if (region == along_the_path) {
        add_tiles_near(way);
    } else {
        add_tiles_within(region.longest, way.front(), way.back());
    }
    complete_ = Flood(*this, sight, open_steps).run(way, deadline);
}

void Distances::add_tile(std::uint32_t number) {
    if (tiles_[number] != none) return;
    tiles_[number] = std::uint32_t(entries_.size());
    entries_.resize(entries_.size() + std::size_t(side) * side);
}

// Adds the tiles that touch the ellipse.
void Distances::add_tiles_within(double longest, Cell start, Cell goal) {
    constexpr double to_corner = side / 2.0 * std::numbers::sqrt2;
    for (std::uint32_t tile = 0; tile < tiles_.size(); ++tile) {
        const Point middle(left_ + int(tile % columns_) * side + (side - 1) / 2.0,
                           top_ + int(tile / columns_) * side + (side - 1) / 2.0);
        if (distance(middle, Point(start)) + distance(middle, Point(goal)) <= longest + 2 * to_corner) add_tile(tile);
    }
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

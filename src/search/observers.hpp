// Observers of a search, plugged into the loop at compile time: unused ones cost nothing.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "map/line_of_sight.hpp"
#include "search/surroundings.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {

// Ignores all events; base of the others.
struct NoObserver {
    void generated(Cell, Cell, double, double) {}
    void updated(Cell, Cell, double, double) {}
    void expanded(Cell, Cell, double, double) {}
    // After expanded(), unless the cell is the goal: the blocked cells around it.
    void surrounded(Cell, Neighbourhood) {}
};

// The paper's contribution to the search (Algorithm 1, lines 11-13): how often each obstacle was in the way of a step.
// For an agent wider than a cell that is every obstacle its disc would touch where it cannot stand.
class HitCounter : public NoObserver {
  public:
    HitCounter(const OpenedMap& map, const LineOfSight& sight, bool wide)
        : map_(map), sight_(sight), wide_(wide), hits_(map.map().obstacles().size() + 1, 0) {}

    void surrounded(Cell cell, Neighbourhood blocked) {
        constexpr Neighbourhood all_around = 0x1FF & ~(1U << step_index(0, 0));
        for_each_offset(wide_ ? all_around : blocked, [&](int i) {
            const Cell neighbour{cell.x + steps[std::size_t(i)].dx, cell.y + steps[std::size_t(i)].dy};
            if (!map_.map().grid().contains(neighbour)) return;
            if (wide_) {
                count_touched(neighbour);
            } else {
                ++hits_[map_.map().obstacle_at(neighbour).value];
            }
        });
    }
    std::vector<std::uint32_t> take() { return std::move(hits_); }

  private:
    void count_touched(Cell at) {
        touched_.clear();
        for (int v = 0; sight_.disc_row(v) >= 0; ++v) {
            touch_row(at, v);
            if (v > 0) touch_row(at, -v);
        }
        std::sort(touched_.begin(), touched_.end());
        touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
        for (const ObstacleId id : touched_) ++hits_[id.value];
    }

    void touch_row(Cell at, int v) {
        const int reach = sight_.disc_row(v);
        for (Cell c{at.x - reach, at.y + v}; c.x <= at.x + reach; ++c.x) {
            if (map_.map().grid().contains(c) && map_.blocked(c)) touched_.push_back(map_.map().obstacle_at(c));
        }
    }

    const OpenedMap& map_;
    const LineOfSight& sight_;
    bool wide_;
    std::vector<std::uint32_t> hits_;
    std::vector<ObstacleId> touched_;  // by one disc; kept for its memory
};

// Passes everything on to a listener, and counts hits as well.
class ListeningHitCounter : public HitCounter {
  public:
    ListeningHitCounter(HitCounter counter, SearchListener& listener)
        : HitCounter(std::move(counter)), listener_(listener) {}

    void generated(Cell cell, Cell parent, double g, double f) { listener_.generated(cell, parent, g, f); }
    void updated(Cell cell, Cell parent, double g, double f) { listener_.updated(cell, parent, g, f); }
    void expanded(Cell cell, Cell parent, double g, double f) { listener_.expanded(cell, parent, g, f); }

  private:
    SearchListener& listener_;
};

}  // namespace waybreaker

// Observers of a search. Each is a part that plugs into the loop at compile time: what nobody asks for costs nothing.
#pragma once

#include <vector>

#include "map/line_of_sight.hpp"
#include "search/surroundings.hpp"
#include "waybreaker/search.hpp"

namespace waybreaker {

// Hears nothing; the others build on it.
struct NoObserver {
    void generated(Cell, Cell, double, double) {}
    void updated(Cell, Cell, double, double) {}
    void expanded(Cell, Cell, double, double) {}
    // After expanded(), unless the cell is the goal: the blocked cells around it.
    void surrounded(Cell, Neighbourhood) {}
};

// The paper's contribution to the search (Algorithm 1, lines 11-13): how often each obstacle was in the way.
class HitCounter : public NoObserver {
  public:
    explicit HitCounter(const OpenedMap& map) : map_(map), hits_(map.map().obstacles().size() + 1, 0) {}

    void surrounded(Cell cell, Neighbourhood blocked) {
        for_each_offset(blocked, [&](int i) {
            const Cell neighbour{cell.x + steps[std::size_t(i)].dx, cell.y + steps[std::size_t(i)].dy};
            if (map_.map().grid().contains(neighbour)) ++hits_[map_.map().obstacle_at(neighbour).value];
        });
    }
    std::vector<std::uint32_t> take() { return std::move(hits_); }

  private:
    const OpenedMap& map_;
    std::vector<std::uint32_t> hits_;
};

// Passes everything on to a listener, and counts hits as well.
class ListeningHitCounter : public HitCounter {
  public:
    ListeningHitCounter(const OpenedMap& map, SearchListener& listener) : HitCounter(map), listener_(listener) {}

    void generated(Cell cell, Cell parent, double g, double f) { listener_.generated(cell, parent, g, f); }
    void updated(Cell cell, Cell parent, double g, double f) { listener_.updated(cell, parent, g, f); }
    void expanded(Cell cell, Cell parent, double g, double f) { listener_.expanded(cell, parent, g, f); }

  private:
    SearchListener& listener_;
};

}  // namespace waybreaker

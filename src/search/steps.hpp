// Steps: where a search can go from a cell. Grid neighbours, neighbours of a wide agent, jump points.
#pragma once

#include <array>

#include "map/line_of_sight.hpp"
#include "search/node_store.hpp"
#include "search/surroundings.hpp"

namespace waybreaker {

// The four or eight neighbours.
class GridSteps {
  public:
    static constexpr bool pruned = false;  // by where the cell is entered from
    // `unit_cost`: every step costs 1, so that path length is the number of steps (BFS).
    GridSteps(const OpenedMap& map, Corners corners, bool diagonal, bool unit_cost)
        : legal_(legal_steps(corners, diagonal)) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            offset_[i] = steps[i].dy * std::ptrdiff_t(map.width()) + steps[i].dx;
            cost_[i] = unit_cost ? 1 : steps[i].cost;
        }
    }

    template <class Visit>
    void for_each(NodeStore& nodes, Cell cell, Cell /*parent*/, Neighbourhood blocked, Visit visit) const {
        Node* const here = &nodes.at(cell);
        for_each_offset(legal_[blocked], [&](int i) {
            const auto step = std::size_t(i);
            visit(Cell{cell.x + steps[step].dx, cell.y + steps[step].dy}, here[offset_[step]], cost_[step]);
        });
    }

  private:
    const StepTable& legal_;
    std::array<std::ptrdiff_t, 9> offset_;
    std::array<double, 9> cost_;
};

// The same for an agent that is wider than a cell: a step must be clear for its whole disc.
class WideSteps {
  public:
    static constexpr bool pruned = false;  // by where the cell is entered from
    WideSteps(const LineOfSight& sight, bool diagonal, bool unit_cost)
        : sight_(sight), diagonal_(diagonal), unit_cost_(unit_cost) {}

    template <class Visit>
    void for_each(NodeStore& nodes, Cell cell, Cell /*parent*/, Neighbourhood blocked, Visit visit) const {
        for (const Step& step : steps) {
            if (step.cost == 0 || (!diagonal_ && step.cost != 1)) continue;
            if ((blocked & step_bit(step.dx, step.dy)) != 0) continue;
            const Cell to{cell.x + step.dx, cell.y + step.dy};
            if (!sight_.fits(to) || !sight_.clear(cell, to)) continue;
            visit(to, nodes.at(to), unit_cost_ ? 1 : step.cost);
        }
    }

  private:
    const LineOfSight& sight_;
    bool diagonal_;
    bool unit_cost_;
};

}  // namespace waybreaker

// Jump points (Harabor and Grastien 2011): successors of JPS, found by scanning lines of the map a word at a time.
#pragma once

#include "search/node_store.hpp"
#include "search/surroundings.hpp"
#include "waybreaker/body.hpp"

namespace waybreaker {

class JumpSteps {
  public:
    static constexpr bool pruned = true;  // by where the cell is entered from
    JumpSteps(const OpenedMap& map, Corners corners, Cell goal)
        : map_(map),
          corners_(corners),
          goal_(goal),
          legal_(legal_steps(corners, true)),
          kept_(unpruned_steps(corners)) {}

    template <class Visit>
    void for_each(NodeStore& nodes, Cell cell, Cell parent, Neighbourhood blocked, Visit visit) const {
        const int arrival = step_index(sign(cell.x - parent.x), sign(cell.y - parent.y));
        for_each_offset(kept_[blocked][std::size_t(arrival)], [&](int i) {
            const Step& step = steps[std::size_t(i)];
            const int length = step.cost == 1 ? straight_jump(cell, step) : diagonal_jump(cell, step);
            if (length == 0) return;
            const Cell to{cell.x + length * step.dx, cell.y + length * step.dy};
            visit(to, nodes.at(to), length * step.cost);
        });
    }

  private:
    static int sign(int n) { return (n > 0) - (n < 0); }

    // How many steps to the next jump point in that direction; 0 if there is none.
    int straight_jump(Cell from, const Step& step) const;
    int diagonal_jump(Cell from, const Step& step) const;

    const OpenedMap& map_;
    Corners corners_;
    Cell goal_;
    const StepTable& legal_;
    const PrunedStepTable& kept_;
};

}  // namespace waybreaker

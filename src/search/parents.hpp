// Parent rules: whose child a cell becomes when it is reached. That choice is all that tells A*, Theta* and Lazy Theta*
// apart.
//
// relax() gives back a function of (to, node of to, cost of the step) that the loop calls for every open or new
// successor.
#pragma once

#include "map/line_of_sight.hpp"
#include "search/node_store.hpp"
#include "search/surroundings.hpp"

namespace waybreaker {

// The cell it was reached from: A*, Dijkstra, BFS, JPS.
struct StepParents {
    template <class Search>
    void settle(Search&, Cell, Node&) const {}

    template <class Search>
    auto relax(Search& search, Cell cell, const Node& node) const {
        return [&search, cell, g = node.g](Cell to, Node& next, double cost) {
            if (g + cost < search.nodes().g(next)) search.improve(to, next, cell, g + cost);
        };
    }
};

// Theta*: the parent of that cell, where it is in sight; else that cell.
//
// By the triangle inequality the way through the grandparent is never longer than the way through the cell. So if not
// even that would improve the successor, neither can, and line of sight need not be looked at.
struct ThetaParents {
    const LineOfSight& sight;

    template <class Search>
    void settle(Search&, Cell, Node&) const {}

    template <class Search>
    auto relax(Search& search, Cell cell, const Node& node) const {
        const Cell parent = node.parent.cell();
        return [this, &search, cell, g = node.g, parent, parent_g = search.nodes().at(parent).g](Cell to, Node& next,
                                                                                                 double cost) {
            const double known = search.nodes().g(next);
            const double straight = parent_g + distance(parent, to);
            if (straight >= known) return;
            if (sight.clear(parent, to)) {
                search.improve(to, next, parent, straight);
            } else if (g + cost < known) {
                search.improve(to, next, cell, g + cost);
            }
        };
    }
};

// Lazy Theta*: takes the grandparent on trust and looks when the cell is taken from the open list; if it is out of
// sight, the best closed neighbour becomes the parent. (Nash, Koenig, Tovey 2010.)
template <class Steps>
struct LazyThetaParents {
    const LineOfSight& sight;
    const Steps& moves;

    template <class Search>
    void settle(Search& search, Cell cell, Node& node) const {
        if (sight.clear(node.parent.cell(), cell)) return;
        NodeStore& nodes = search.nodes();
        node.g = std::numeric_limits<double>::infinity();
        moves.for_each(nodes, cell, cell, blocked_around(search.query().map, cell),
                       [&](Cell from, const Node& neighbour, double cost) {
                           if (!nodes.is_closed(neighbour) || neighbour.g + cost >= node.g) return;
                           node.g = neighbour.g + cost;
                           node.parent = CellKey(from);
                       });
    }

    template <class Search>
    auto relax(Search& search, Cell /*cell*/, const Node& node) const {
        const Cell parent = node.parent.cell();
        return [&search, parent, parent_g = search.nodes().at(parent).g](Cell to, Node& next, double /*cost*/) {
            const double straight = parent_g + distance(parent, to);
            if (straight < search.nodes().g(next)) search.improve(to, next, parent, straight);
        };
    }
};

}  // namespace waybreaker

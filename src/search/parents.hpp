// Parent rules: which node becomes a cell's parent when the cell is reached. Only this distinguishes A*, Theta* and
// Lazy Theta*.
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
// Two things save most line-of-sight tests. By the triangle inequality the path through the grandparent is never
// longer than the path through the cell, so where not even that would improve the successor, neither can. And sight can
// be inferred: see inferred().
class ThetaParents {
  public:
    ThetaParents(const OpenedMap& map, const LineOfSight& sight) : map_(map), sight_(sight) {}

    template <class Search>
    void settle(Search&, Cell, Node&) const {}

    template <class Search>
    auto relax(Search& search, Cell cell, const Node& node) const {
        const Cell parent = node.parent.cell();
        return [this, &search, cell, g = node.g, parent, parent_g = search.nodes().at(parent).g](Cell to, Node& next,
                                                                                                 double cost) {
            if (search.nodes().has_parent(next, CellKey(parent))) return;  // nothing would change
            const double known = search.nodes().g(next);
            const double straight = parent_g + distance(parent, to);
            if (straight >= known) return;
            if (inferred(search.nodes(), parent, to, &next) || sight_.clear(parent, to)) {
                search.improve(to, next, parent, straight);
            } else if (g + cost < known) {
                search.improve(to, next, cell, g + cost);
            }
        };
    }

  private:
    // Whether `to` is surely in sight of `from` because cells before it are: those that have `from` as their parent.
    //
    // Consider the line of cells across the segment k cells before its end. The segment passes between two neighbours
    // there, or through one cell. The strips swept to these two are less than one cell apart, so together they cover
    // all that the segment sweeps before that line. What it sweeps on the last k + 1 lines lies within two cells of it
    // and is tested here. (tests/search checks both claims for every segment up to some length.)
    bool inferred(const NodeStore& nodes, Cell from, Cell to, const Node* node) const {
        if (!sight_.is_unit_disc()) return false;
        const int dx = to.x - from.x;
        const int dy = to.y - from.y;
        const Axis x{std::abs(dx), dx < 0 ? -1 : 1, dx < 0 ? -1 : 1, to.x};
        const Axis y{std::abs(dy), dy < 0 ? -1 : 1, std::ptrdiff_t(nodes.width()) * (dy < 0 ? -1 : 1), to.y};
        return x.length >= y.length
                   ? inferred(nodes, CellKey(from), node, x, y, [this](int column) { return map_.column(column); })
                   : inferred(nodes, CellKey(from), node, y, x, [this](int row) { return map_.row(row); });
    }

    // A segment along one axis: cells to its end, direction, distance of neighbours in the node store, where it ends.
    struct Axis {
        int length;
        int step;
        std::ptrdiff_t stride;
        int end;
    };

    template <class LineAt>
    static bool inferred(const NodeStore& nodes, CellKey from, const Node* node, const Axis& major, const Axis& minor,
                         LineAt line_at) {
        constexpr int furthest = 8;  // lines back; beyond, testing the whole segment is as cheap
        // On line k the segment lies (behind - rest / major.length) cells before its end across.
        int behind[furthest + 1]{};
        int rest = 0;
        for (int k = 1; k <= furthest && k < major.length; ++k) {
            rest -= minor.length;
            behind[k] = behind[k - 1];
            if (rest < 0) {
                rest += major.length;
                ++behind[k];
            }
            const Node* const lower = node - k * major.stride - behind[k] * minor.stride;
            if (!nodes.has_parent(*lower, from) || (rest > 0 && !nodes.has_parent(*(lower + minor.stride), from)))
                continue;
            for (; k >= 0; --k) {
                // Cells that it may sweep on this line: two cells beyond the lower neighbour to one before, in the
                // segment's box.
                const int near = std::max(behind[k] - 2, 0);
                const int far = std::min(behind[k] + 1, minor.length);
                const int first = minor.step > 0 ? minor.end - far : minor.end + near;
                if (any_bit(line_at(major.end - major.step * k), unsigned(first + 1), unsigned(first + 1 + far - near)))
                    return false;
            }
            return true;
        }
        return false;
    }

    const OpenedMap& map_;
    const LineOfSight& sight_;
};

// Lazy Theta*: assumes the grandparent is in sight and tests it when the cell is taken from the open list; if it is out
// of sight, the best closed neighbour becomes the parent. (Nash, Koenig, Tovey 2010.)
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

// The one best-first loop. What makes it Theta*, A*, JPS, ... are three parts that plug in:
//
//   Steps      where one can go from a cell:   for_each(cell, parent, blocked, visit(to, cost))
//   Parents    whose child a new cell becomes: settle(node) when it is taken from the open list, relax(...) when it is
//   reached Observers  who listens:                    expanded / generated / updated; empty ones cost nothing
//
// Paper, Algorithm 1; Nash et al. 2007 (Theta*), Hart et al. 1968 (A*).
#pragma once

#include <algorithm>
#include <vector>

#include "core/stopwatch.hpp"
#include "search/heuristic.hpp"
#include "search/node_store.hpp"
#include "search/open_list.hpp"
#include "search/surroundings.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {

// The map and the options as the loop needs them, computed once per query.
struct Query {
    const OpenedMap& map;
    Cell start;
    Cell goal;
    Heuristic heuristic;
    double weight;
    const SearchOptions& options;
};

template <class Steps, class Parents, class Order, class Observer>
class BestFirst {
  public:
    BestFirst(const Query& query, NodeStore& nodes, OpenMemory& open_memory, const Steps& moves, const Parents& parents,
              Observer& observer)
        : query_(query),
          nodes_(nodes),
          open_(open_memory),
          moves_(moves),
          parents_(parents),
          observer_(observer),
          deadline_(query.options.limits.seconds) {}

    SearchResult run() {
        nodes_.begin_query(query_.map.width(), query_.map.height());
        improve(query_.start, nodes_.at(query_.start), query_.start, 0);
        result_.status = loop();
        result_.generated = generated_;
        if (result_.status == SearchStatus::found) trace_path();
        return std::move(result_);
    }

    NodeStore& nodes() { return nodes_; }
    const Query& query() const { return query_; }

    // Makes `to` a child of `parent` with path length g. Precondition: that is shorter than its path so far.
    void improve(Cell to, Node& node, Cell parent, double g) {
        const bool is_new = !nodes_.is_open(node);
        node.g = g;
        node.parent = CellKey(parent);
        nodes_.open(node);
        const double f = g + query_.weight * estimate(query_.heuristic, to, query_.goal);
        open_.push({f, float(g), CellKey(to)});
        if (is_new) {
            ++generated_;
            observer_.generated(to, parent, g, f);
        } else {
            observer_.updated(to, parent, g, f);
        }
    }

  private:
    SearchStatus loop() {
        while (!open_.empty()) {
            const OpenEntry entry = open_.pop();
            const Cell cell = entry.key.cell();
            Node& node = nodes_.at(cell);
            if (nodes_.is_closed(node)) continue;  // by a shorter way, found later
            if (result_.expanded >= query_.options.limits.expansions) return SearchStatus::limit_reached;
            if (result_.expanded % 1024 == 0) {
                if (query_.options.limits.stop.stop_requested()) return SearchStatus::stopped;
                if (result_.expanded > 0 && deadline_.passed()) return SearchStatus::limit_reached;
            }
            parents_.settle(*this, cell, node);
            nodes_.close(node);
            ++result_.expanded;
            const Neighbourhood blocked = blocked_around(query_.map, cell);
            observer_.expanded(cell, node.parent.cell(), node.g, entry.f);
            if (cell == query_.goal) return SearchStatus::found;
            observer_.surrounded(cell, blocked);
            const auto relax = parents_.relax(*this, cell, node);
            moves_.for_each(nodes_, cell, node.parent.cell(), blocked, [&](Cell to, Node& next, double cost) {
                if (!nodes_.is_closed(next) || reopens(node.g + cost, next)) relax(to, next, cost);
            });
        }
        return SearchStatus::no_path;
    }

    // Steps that are pruned by where a cell is entered from are pruned for good only if the way there is shortest. With
    // a weight it may not be when the cell is closed.
    static bool reopens(double g, const Node& closed) {
        constexpr double rounding = 1e-12;  // relative
        return Steps::pruned && g < closed.g * (1 - rounding);
    }

    // Turning points only: a straight line through several nodes is one segment.
    void trace_path() {
        std::vector<Cell>& path = result_.path;
        for (Cell cell = query_.goal;; cell = nodes_.at(cell).parent.cell()) {
            const std::size_t n = path.size();
            if (n >= 2 && straight(path[n - 2], path[n - 1], cell)) path.pop_back();
            path.push_back(cell);
            if (cell == query_.start) break;
        }
        std::reverse(path.begin(), path.end());
        for (std::size_t i = 1; i < path.size(); ++i) result_.length += distance(path[i - 1], path[i]);
    }

    static bool straight(Cell a, Cell b, Cell c) {
        const std::int64_t ux = b.x - a.x;
        const std::int64_t uy = b.y - a.y;
        const std::int64_t vx = c.x - b.x;
        const std::int64_t vy = c.y - b.y;
        return ux * vy == uy * vx && ux * vx + uy * vy > 0;
    }

    Query query_;
    NodeStore& nodes_;
    OpenList<Order> open_;
    const Steps& moves_;
    const Parents& parents_;
    Observer& observer_;
    Deadline deadline_;
    SearchResult result_;
    std::uint64_t generated_ = 0;
};

}  // namespace waybreaker

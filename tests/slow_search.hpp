// A slow and obvious search, the textbook loop of each planner (Nash et al. 2007, 2010; Hart et al. 1968), as the
// reference for the fast one: same total order of the open list, every line of sight tested, nothing inferred or
// skipped.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "plain_map.hpp"
#include "slow_sight.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker::slow {

class Search {
  public:
    // Not for JPS, whose successors are what makes it. `plain` is the opened map, for all questions but the line of
    // sight between two cells apart, which has tests of its own.
    Search(const OpenedMap& map, const PlainMap& plain, Cell start, Cell goal, const SearchOptions& options)
        : map_(map), plain_(plain), goal_(goal), options_(options), labels_(waybreaker::plain(map.map())) {
        result.hits.assign(map.map().obstacles().size() + 1, 0);
        if (!stands(start) || !stands(goal)) return;
        reach(start, start, 0);
        while (!open_.empty()) {
            const Cell cell = std::get<2>(*open_.begin());
            open_.erase(open_.begin());
            if (options.planner == Algorithm::lazy_theta) settle(cell);
            closed_.insert(cell);
            ++result.expanded;
            if (cell == goal) {
                result.status = SearchStatus::found;
                trace(start);
                break;
            }
            expand(cell);
        }
        result.generated = result.expanded + open_.size();
    }

    SearchResult result;

  private:
    struct Node {
        double g = std::numeric_limits<double>::infinity();
        double f = 0;
        Cell parent;
    };
    using Entry = std::tuple<double, float, Cell>;

    bool theta() const { return options_.planner == Algorithm::theta || options_.planner == Algorithm::lazy_theta; }
    bool stands(Cell c) const { return plain_.contains(c) && sees(plain_, c, c, options_.body); }

    bool may_step(Cell from, int dx, int dy) const {
        const Body& body = options_.body;
        const Cell to{from.x + dx, from.y + dy};
        if ((dx == 0 && dy == 0) || !stands(to)) return false;
        if (dx == 0 || dy == 0) return sees(plain_, from, to, body);
        const int blocked_sides = (plain_.blocked({to.x, from.y}) ? 1 : 0) + (plain_.blocked({from.x, to.y}) ? 1 : 0);
        switch (body.corners) {
            case Corners::none:
                return options_.diagonal && blocked_sides == 0 && sees(plain_, from, to, body);
            case Corners::cut:
                return options_.diagonal && blocked_sides <= 1;
            case Corners::squeeze:
                return options_.diagonal;
        }
        return false;
    }

    double step_cost(Cell a, Cell b) const { return options_.planner == Algorithm::bfs ? 1 : distance(a, b); }

    double estimate(Cell c) const {
        if (options_.planner == Algorithm::dijkstra || options_.planner == Algorithm::bfs) return 0;
        const int dx = std::abs(c.x - goal_.x);
        const int dy = std::abs(c.y - goal_.y);
        const Heuristic usual = theta()             ? Heuristic::euclidean
                                : options_.diagonal ? Heuristic::octile
                                                    : Heuristic::manhattan;
        switch (options_.heuristic.value_or(usual)) {
            case Heuristic::euclidean:
                return distance(c, goal_);
            case Heuristic::octile:
                return std::max(dx, dy) + (std::sqrt(2.0) - 1) * std::min(dx, dy);
            case Heuristic::chebyshev:
                return std::max(dx, dy);
            case Heuristic::manhattan:
                return dx + dy;
            case Heuristic::zero:
                break;
        }
        return 0;
    }

    // Of equal f the larger g (or the smaller) comes first, then the cell that comes first in the map.
    Entry entry(Cell c, const Node& node) const {
        const float g = float(node.g);
        return {node.f, options_.tie_break == TieBreak::g_max ? -g : g, c};
    }
    struct Before {
        bool operator()(const Entry& a, const Entry& b) const {
            const auto key = [](const Entry& e) {
                return std::tuple(std::get<0>(e), std::get<1>(e), std::get<2>(e).y, std::get<2>(e).x);
            };
            return key(a) < key(b);
        }
    };

    void reach(Cell to, Cell parent, double g) {
        Node& node = nodes_[to];
        if (g >= node.g) return;
        open_.erase(entry(to, node));
        node = {g, g + options_.weight * estimate(to), parent};
        open_.insert(entry(to, node));
    }

    // The obstacles that the agent would touch if it stood on a cell; for a point, whose cell that is.
    std::set<std::uint32_t> in_the_way(Cell at) const {
        std::set<std::uint32_t> ids;
        if (!labels_.contains(at)) return ids;
        const bool disc = options_.body.corners == Corners::none;
        const auto radius = std::int64_t(std::llround(options_.body.radius * 1000));
        const int margin = int(options_.body.radius) + 1;
        for (int y = at.y - margin; y <= at.y + margin; ++y) {
            for (int x = at.x - margin; x <= at.x + margin; ++x) {
                const Cell c{x, y};
                if (!labels_.contains(c) || !plain_.blocked(c)) continue;
                if (c == at || (disc && disc_meets(at, at, radius, c))) ids.insert(labels_.at(c));
            }
        }
        return ids;
    }

    void expand(Cell cell) {
        const Node node = nodes_[cell];
        const double parent_g = nodes_[node.parent].g;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell to{cell.x + dx, cell.y + dy};
                for (const std::uint32_t id : in_the_way(to)) ++result.hits[id];
                if (!may_step(cell, dx, dy) || closed_.count(to) > 0) continue;
                const bool trusted = options_.planner == Algorithm::lazy_theta;
                if (theta() && (trusted || line_of_sight(map_, node.parent, to, options_.body))) {
                    reach(to, node.parent, parent_g + distance(node.parent, to));
                } else {
                    reach(to, cell, node.g + step_cost(cell, to));
                }
            }
        }
    }

    // Lazy Theta*: the parent was taken on trust. If it is out of sight, the best closed neighbour becomes the parent;
    // of equally good ones the first in scan order.
    void settle(Cell cell) {
        Node& node = nodes_[cell];
        if (line_of_sight(map_, node.parent, cell, options_.body)) return;
        node.g = std::numeric_limits<double>::infinity();
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Cell from{cell.x + dx, cell.y + dy};
                if (!may_step(cell, dx, dy) || closed_.count(from) == 0) continue;
                const double g = nodes_[from].g + step_cost(from, cell);
                if (g < node.g) node = {g, node.f, from};
            }
        }
    }

    // Turning points only.
    void trace(Cell start) {
        std::vector<Cell>& path = result.path;
        path = {goal_};
        while (path.front() != start) path.insert(path.begin(), nodes_[path.front()].parent);
        for (std::size_t i = 1; i + 1 < path.size();) {
            const Point a = centre(path[i - 1]);
            const Point b = centre(path[i]);
            const Point c = centre(path[i + 1]);
            const bool straight = cross(a, b, c) == 0 && dot(b, a, c) < 0;
            if (straight) {
                path.erase(path.begin() + std::ptrdiff_t(i));
            } else {
                ++i;
            }
        }
        for (std::size_t i = 1; i < path.size(); ++i) result.length += distance(path[i - 1], path[i]);
    }

    const OpenedMap& map_;
    const PlainMap& plain_;
    Cell goal_;
    SearchOptions options_;
    PlainMap labels_;
    std::map<Cell, Node> nodes_;
    std::set<Cell> closed_;
    std::set<Entry, Before> open_;
};

}  // namespace waybreaker::slow

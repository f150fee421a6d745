#include "drive/centres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace waybreaker {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr std::size_t most_cells = std::size_t{1} << 18U;
constexpr std::size_t most_centres = 4096;
// Steps from cell to cell are at most that much longer than a straight line: sqrt(4 - 2 sqrt(2)).
constexpr double most_of_line = 1.0823922002923940;
constexpr double rounding = 1e-9;

// The cells of a box that holds the ellipse of all paths up to a length.
class Centres {
  public:
    Centres(const OpenedMap& map, Cell start, Cell goal, const Body& body, double known)
        : map_(map), start_(start), goal_(goal), body_(body), known_(known * (1 + rounding)) {
        const double half = known_ / 2 + 1;
        const auto first = [&](int a, int b) { return std::max(0, int(std::floor((a + b) / 2.0 - half))); };
        const auto last = [&](int a, int b, int size) {
            return int(std::min(double(size - 1), std::ceil((a + b) / 2.0 + half)));
        };
        from_ = {first(start.x, goal.x), first(start.y, goal.y)};
        to_ = {last(start.x, goal.x, map.width()), last(start.y, goal.y, map.height())};
    }

    std::size_t cells() const { return std::size_t(width()) * std::size_t(to_.y - from_.y + 1); }

    double least(std::uint64_t most_looks) {
        measure_steps();
        collect();
        if (centres_.size() > most_centres) return 0;
        struct Node {
            double cost;
            std::size_t centre;
            bool operator>(const Node& other) const {
                return cost != other.cost ? cost > other.cost : centre > other.centre;
            }
        };
        std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
        std::vector<double> reached(centres_.size(), unreached);
        std::vector<char> closed(centres_.size(), 0);
        const auto begin = std::size_t(std::ranges::find(centres_, start_, &Centre::cell) - centres_.begin());
        if (begin == centres_.size()) return known_;
        reached[begin] = 0;
        open.push({centres_[begin].rest, begin});
        while (!open.empty()) {
            const auto [cost, at] = open.top();
            open.pop();
            if (closed[at]) continue;
            closed[at] = 1;
            const Cell cell = centres_[at].cell;
            if (cell == goal_ || most_looks == 0) return cost;
            for (std::size_t to = 0; to < centres_.size(); ++to) {
                if (closed[to]) continue;
                const double length = reached[at] + distance(cell, centres_[to].cell);
                if (length >= reached[to] || length + centres_[to].rest > known_) continue;
                if (most_looks == 0) return cost;
                --most_looks;
                if (!line_of_sight(map_, cell, centres_[to].cell, body_)) continue;
                reached[to] = length;
                open.push({length + centres_[to].rest, to});
            }
        }
        return known_;
    }

  private:
    struct Centre {
        Cell cell;
        double rest;  // to the goal, at least
    };

    int width() const { return to_.x - from_.x + 1; }
    std::size_t index(Cell c) const {
        return std::size_t(c.y - from_.y) * std::size_t(width()) + std::size_t(c.x - from_.x);
    }
    bool contains(Cell c) const { return c.x >= from_.x && c.x <= to_.x && c.y >= from_.y && c.y <= to_.y; }

    // To the goal, from cell to cell, over corners as well: a line crosses cells that are free, one beside the other.
    void measure_steps() {
        steps_.assign(cells(), unreached);
        using Reached = std::pair<double, std::size_t>;
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
        steps_[index(goal_)] = 0;
        open.emplace(0, index(goal_));
        while (!open.empty()) {
            const auto [steps, i] = open.top();
            open.pop();
            if (steps > steps_[i]) continue;
            const Cell at{from_.x + int(i % std::size_t(width())), from_.y + int(i / std::size_t(width()))};
            for (const auto& [dx, dy] : neighbours) {
                const Cell to{at.x + dx, at.y + dy};
                if (!contains(to) || map_.blocked(to)) continue;
                const double more = steps + std::sqrt(double(dx * dx + dy * dy));
                if (more >= steps_[index(to)] || more > known_ * most_of_line) continue;
                steps_[index(to)] = more;
                open.emplace(more, index(to));
            }
        }
    }

    // Where a path that is no longer than the one known may bend.
    void collect() {
        for (Cell c{0, from_.y}; c.y <= to_.y; ++c.y) {
            for (c.x = from_.x; c.x <= to_.x; ++c.x) {
                const double rest = std::max(distance(c, goal_), steps_[index(c)] / most_of_line);
                if (distance(start_, c) + rest > known_ || !fits(map_, c, body_)) continue;
                centres_.push_back({c, rest});
            }
        }
    }

    static constexpr std::array<std::pair<int, int>, 8> neighbours{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

    const OpenedMap& map_;
    Cell start_;
    Cell goal_;
    const Body& body_;
    double known_;
    Cell from_;
    Cell to_;
    std::vector<double> steps_;  // by cell of the box
    std::vector<Centre> centres_;
};

}  // namespace

double least_through_centres(const OpenedMap& map, Cell start, Cell goal, const Body& body, double known,
                             std::uint64_t most_looks) {
    const double straight = std::min(distance(start, goal), known);
    Centres centres(map, start, goal, body, known);
    if (centres.cells() > most_cells) return straight;
    return std::clamp(centres.least(most_looks), straight, known);
}

}  // namespace waybreaker

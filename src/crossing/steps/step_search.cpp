#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>

#include "core/interrupt.hpp"
#include "crossing/step_bound.hpp"
#include "crossing/steps/buckets.hpp"
#include "crossing/steps/strides.hpp"
#include "crossing/tuning.hpp"

namespace waybreaker {
namespace {

using namespace crossing;

// Cells that two strides save on their steps: one stride may be cut where a path enters an obstacle, and one where it
// leaves it.
constexpr double most_cut = 0.3563;

// A* over the cells, in layers by the number of obstacles crossed. To cross one, a path flies from a cell beside it to
// another, as if nothing stood in the box around it. So none is crossed twice, whatever the path.
class StepSearch {
  public:
    StepSearch(const Map& map, Cell start, Cell goal, const CrossingOptions& options)
        : map_(map),
          opened_(map, options.removed),
          start_(start),
          goal_(goal),
          crossings_(options.crossings),
          expansions_(std::min(options.limits.expansions, tuning::most_steps_expanded)),
          interrupt_(options.limits.seconds, options.limits.stop),
          straight_(distance(start, goal)),
          longest_(options.length_limit),
          open_(cost_between(start, goal)),
          solid_(map.obstacles().size() + 1, !options.only.empty()) {
        for (const ObstacleId id : options.only) solid_[id.value] = false;
        for (const ObstacleId id : options.protect) solid_[id.value] = true;
        for (const Obstacle& obstacle : map.obstacles()) {
            if (!obstacle.destructible) solid_[obstacle.id.value] = true;
        }
        const double most_cost = (longest_ * most_of_line + most_cut * crossings_) * step_cost + step_cost;
        if (most_cost < double(most_cost_)) most_cost_ = std::uint32_t(most_cost);
    }

    StepBound run() {
        if (straight_ > longest_) return {.least = longest_};
        if (!set_out()) return {.least = straight_, .limited = true};
        reach({.at = start_}, {.cost = 1});
        for (std::uint64_t expanded = 0; !open_.empty(); ++expanded) {
            const Entry entry = open_.pop();
            if (interrupt_.due() || expanded == expansions_) return {.least = cells(open_.least()), .limited = true};
            here_ = node_of(entry.place);
            const Node node = *here_;
            if (node.cost != entry.cost) continue;
            if (entry.place.at == goal_ && !entry.place.within) {
                return {.least = cells(open_.least()), .crossed = crossed(node)};
            }
            if (!entry.place.within) {
                expand(entry.place, node);
            } else {
                fly(entry.place, node);
            }
        }
        return {.least = too_costly_ ? cells(most_cost_) : longest_};
    }

  private:
    // On the ground, or within the box around an obstacle that is being crossed.
    struct Place {
        Cell at;
        std::uint32_t layer = 0;
        ObstacleId within = {};
    };
    struct Node {
        std::uint32_t cost = 0;  // one more than it is; 0: not reached
        std::uint32_t crossed = 0;
    };
    struct Entry {
        Place place;
        std::uint32_t cost;  // as of the node
    };
    struct Crossed {
        ObstacleId obstacle;
        std::uint32_t before;
    };
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };

    // Makes room for the cells of the ellipse that holds all paths that matter. False if they are too many for the
    // time.
    bool set_out() {
        const double half = std::min(longest_, 1e9) / 2 + 1;
        const auto first = [&](int a, int b) { return int(std::max(0.0, std::floor((a + b) / 2.0 - half))); };
        const auto last = [&](int a, int b, int size) {
            return int(std::min(double(size - 1), std::ceil((a + b) / 2.0 + half)));
        };
        all_ = {{first(start_.x, goal_.x), first(start_.y, goal_.y)},
                {last(start_.x, goal_.x, map_.width()), last(start_.y, goal_.y, map_.height())}};
        std::uint64_t nodes = area(all_) * layers();
        first_within_.assign(map_.obstacles().size() + 1, 0);
        for (const Obstacle& obstacle : map_.obstacles()) {
            if (crossings_ == 0 || solid_[obstacle.id.value]) continue;
            const Box box = around(obstacle.id);
            if (box.min.x > box.max.x || box.min.y > box.max.y) continue;
            const bool small = area(box) <= tuning::small_box;
            first_within_[obstacle.id.value] = small ? hops : nodes;
            if (!small) nodes += area(box) * std::uint64_t(crossings_);
        }
        if (nodes > tuning::most_step_nodes) return false;
        // Fresh pages are zero and cost nothing until used.
        nodes_.reset(static_cast<Node*>(std::calloc(std::size_t(nodes), sizeof(Node))));
        return nodes_ != nullptr;
    }

    std::uint64_t layers() const { return std::uint64_t(crossings_) + 1; }
    static std::uint64_t area(const Box& box) {
        return std::uint64_t(box.max.x - box.min.x + 1) * std::uint64_t(box.max.y - box.min.y + 1);
    }
    static std::uint64_t index(const Box& box, Cell c) {
        return std::uint64_t(c.y - box.min.y) * std::uint64_t(box.max.x - box.min.x + 1) +
               std::uint64_t(c.x - box.min.x);
    }
    static bool holds(const Box& box, Cell c) {
        return c.x >= box.min.x && c.x <= box.max.x && c.y >= box.min.y && c.y <= box.max.y;
    }
    Box around(ObstacleId obstacle) const {
        const Box box = map_.obstacle(obstacle).bounds;
        return {{std::max(box.min.x - 1, all_.min.x), std::max(box.min.y - 1, all_.min.y)},
                {std::min(box.max.x + 1, all_.max.x), std::min(box.max.y + 1, all_.max.y)}};
    }
    Node* node_of(const Place& place) const {
        if (!place.within) return nodes_.get() + index(all_, place.at) * layers() + place.layer;
        return nodes_.get() + first_within_[place.within.value] +
               index(around(place.within), place.at) * std::uint64_t(crossings_) + place.layer - 1;
    }

    double cells(std::uint32_t cost) const {
        const double least = (double(cost) / step_cost - most_cut * crossings_) / most_of_line;
        return std::min(std::max(least, straight_), longest_);
    }

    // Puts a place into the open list, unless it was reached at no higher cost in this layer or one before.
    void reach(const Place& place, Node* node, Node reached) {
        const std::uint32_t before = place.within ? place.layer - 1 : place.layer;
        for (std::uint32_t back = 0; back <= before; ++back) {
            const std::uint32_t cost = (node - back)->cost;
            if (cost != 0 && cost <= reached.cost) return;
        }
        const std::uint32_t key = reached.cost + cost_between(place.at, goal_);
        if (key > most_cost_) {
            too_costly_ = true;
            return;
        }
        *node = reached;
        open_.push(key, {place, reached.cost});
    }
    void reach(const Place& place, Node reached) { reach(place, node_of(place), reached); }

    // Reaches the place a step or a stride away.
    void reach_next(const Place& from, const Move& move, const Box& box, std::uint64_t nodes_per_cell, Node node) {
        const Cell to{from.at.x + move.dx, from.at.y + move.dy};
        if (!holds(box, to)) return;
        const auto cells = std::int64_t(move.dy) * (box.max.x - box.min.x + 1) + move.dx;
        Node* const next = here_ + cells * std::int64_t(nodes_per_cell);
        reach({to, from.layer, from.within}, next, {node.cost + move.cost, node.crossed});
    }

    Around blocked_around(Cell c) const {
        Around blocked = 0;
        for (int dy = -2; dy <= 2; ++dy) {
            const std::uint64_t* const row = opened_.row(std::clamp(c.y + dy, -1, map_.height()));
            std::uint64_t bits = 0;  // of the cells from c.x - 2 on, whose bits begin at c.x - 1
            if (c.x == 0) {
                bits = row[0] << 1U | 1U;
            } else {
                const unsigned begin = unsigned(c.x) - 1;
                bits = row[begin / 64] >> (begin % 64);
                if (begin % 64 > 59) bits |= row[begin / 64 + 1] << (64 - begin % 64);
            }
            blocked |= Around(bits & 31U) << unsigned(5 * (dy + 2));
        }
        return blocked;
    }

    void expand(const Place& from, const Node& node) {
        const Around blocked = blocked_around(from.at);
        if ((blocked & bit_of(0, 0)) == 0) {
            for (const Move& move : moves) {
                if ((blocked & move.needs) != 0 && (blocked & move.or_needs) != 0) continue;
                reach_next(from, move, all_, layers(), node);
            }
        }
        if (int(from.layer) == crossings_ || (blocked & next_to) == 0) return;
        for_each_beside(from.at, [&](ObstacleId obstacle) {
            if (solid_[obstacle.value]) return;
            crossed_.push_back({obstacle, node.crossed});
            const Node entered{node.cost, std::uint32_t(crossed_.size() - 1)};
            if (first_within_[obstacle.value] == hops) {
                hop({from.at, from.layer + 1, obstacle}, entered);
            } else {
                reach({from.at, from.layer + 1, obstacle}, entered);
            }
        });
    }

    // Crosses a small obstacle: at once to all cells around it.
    void hop(const Place& from, const Node& node) {
        const Box box = around(from.within);
        for (Cell to = box.min; to.y <= box.max.y; ++to.y) {
            for (to.x = box.min.x; to.x <= box.max.x; ++to.x) {
                if (!leaves(from.within, to) || !is_beside(from.within, to)) continue;
                reach({to, from.layer}, {node.cost + cost_between(from.at, to), node.crossed});
            }
        }
    }

    void fly(const Place& from, const Node& node) {
        const Box box = around(from.within);
        for (const Move& move : moves) {
            reach_next(from, move, box, std::uint64_t(crossings_), node);
        }
        if (!leaves(from.within, from.at) || !is_beside(from.within, from.at)) return;
        reach({from.at, from.layer}, node);
    }

    // Whether who has crossed the obstacle may be there.
    bool leaves(ObstacleId crossed, Cell c) const {
        const ObstacleId here = map_.obstacle_at(c);
        return here != crossed && !(solid_[here.value] && opened_.blocked(c));
    }

    bool is_beside(ObstacleId obstacle, Cell c) const {
        for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, map_.height() - 1); ++y) {
            for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, map_.width() - 1); ++x) {
                if (map_.obstacle_at({x, y}) == obstacle) return true;
            }
        }
        return false;
    }

    // Visits the obstacles beside a cell, each once.
    template <class Visit>
    void for_each_beside(Cell c, Visit visit) const {
        std::array<ObstacleId, 9> seen;
        std::size_t count = 0;
        for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, map_.height() - 1); ++y) {
            for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, map_.width() - 1); ++x) {
                const ObstacleId obstacle = map_.obstacle_at({x, y});
                if (!obstacle || !opened_.blocked({x, y})) continue;
                if (std::find(seen.begin(), seen.begin() + count, obstacle) != seen.begin() + count) continue;
                seen[count++] = obstacle;
                visit(obstacle);
            }
        }
    }

    std::vector<ObstacleId> crossed(const Node& node) const {
        std::vector<ObstacleId> crossed;
        for (std::uint32_t at = node.crossed; at != 0; at = crossed_[at].before) {
            crossed.push_back(crossed_[at].obstacle);
        }
        std::ranges::reverse(crossed);
        return crossed;
    }

    const Map& map_;
    OpenedMap opened_;
    Cell start_;
    Cell goal_;
    int crossings_;
    std::uint64_t expansions_;
    Interrupt interrupt_;
    double straight_;
    double longest_;
    std::uint32_t most_cost_ = UINT32_MAX / 2;  // paths that cost more are not looked for,
    bool too_costly_ = false;                   // and there were some
    Box all_;
    Buckets<Entry> open_;
    std::vector<char> solid_;                          // by obstacle: never crossed
    static constexpr std::uint64_t hops = UINT64_MAX;  // it has no nodes within
    std::vector<std::uint64_t> first_within_;          // nodes, by obstacle
    std::unique_ptr<Node[], Free> nodes_;
    Node* here_ = nullptr;              // of the place whose turn it is
    std::vector<Crossed> crossed_{{}};  // the first is nothing
};

}  // namespace

StepBound least_by_steps(const Map& map, Cell start, Cell goal, const CrossingOptions& options) {
    return StepSearch(map, start, goal, options).run();
}

}  // namespace waybreaker

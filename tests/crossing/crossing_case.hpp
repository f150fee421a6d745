// Random crossing problems, small enough for the oracle; and how a path is judged.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "crossing/access.hpp"
#include "random_map.hpp"
#include "slow_crossing.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {

// Who moves on a map that is not grown.
struct Mover {
    Body body;
    bool relaxed = false;
};
inline const std::vector<Mover> movers{{Body{}}, {point_body}, {Body{}, true}};

struct CrossingCase {
    Map map;
    Cell start;
    Cell goal;
    Body body = {};
    int crossings = 0;
    std::vector<ObstacleId> removed = {};
    std::vector<ObstacleId> protect = {};
    double budget = std::numeric_limits<double>::infinity();
    std::vector<double> done_after = {};  // empty: none
    bool relaxed = false;
    std::vector<double> prices = {};  // by id; empty: none

    void set(const Mover& mover) {
        body = mover.body;
        relaxed = mover.relaxed;
    }

    CrossingOptions options() const {
        CrossingOptions options;
        options.body = body;
        options.relaxed = relaxed;
        options.crossings = crossings;
        options.removed = removed;
        options.protect = protect;
        options.budget = budget;
        options.prices = prices;
        return options;
    }

    crossing::Opener opener() const {
        crossing::Opener opener;
        if (!done_after.empty()) {
            opener.done_after = [this](std::span<const ObstacleId> crossed) {
                double last = 0;
                for (const ObstacleId id : crossed) last = std::max(last, done_after[id.value]);
                return last;
            };
        }
        return opener;
    }

    CrossingResult find(CrossingSearcher& searcher, const CrossingOptions& options) const {
        return crossing::Access::find(searcher, map, start, goal, options, opener());
    }
    CrossingResult find(CrossingSearcher& searcher) const { return find(searcher, options()); }
    CrossingResult find(const CrossingOptions& options) const {
        CrossingSearcher searcher;
        return find(searcher, options);
    }
    CrossingResult find() const { return find(options()); }
    CrossingResult enumerate(const CrossingOptions& options,
                             const std::function<bool(const CrossingPath&)>& accept) const {
        CrossingSearcher searcher;
        return crossing::Access::enumerate(searcher, map, start, goal, options, opener(), accept);
    }

    slow::CrossingOracle oracle() const { return {plain(map), body, relaxed, start, goal}; }

    // The sets of obstacles that may be crossed: not those that a path would start or end in.
    std::vector<slow::Set> choices() const {
        slow::Set candidates = 0;
        for (const Obstacle& obstacle : map.obstacles()) {
            if (obstacle.destructible) candidates |= slow::Set{1} << obstacle.id.value;
        }
        for (const Cell end : {start, goal}) candidates &= ~slow::needed(plain(map), body, relaxed, end);
        std::vector<slow::Set> sets =
            slow::subsets(candidates & ~slow::set_of(removed) & ~slow::set_of(protect), crossings);
        std::erase_if(sets, [&](slow::Set set) { return weight(set) > budget; });
        return sets;
    }

    double weight(slow::Set set) const {
        double sum = 0;
        for (const Obstacle& obstacle : map.obstacles()) sum += (set >> obstacle.id.value & 1) ? obstacle.weight : 0;
        return sum;
    }

    // Of a path of that length that crosses that set.
    double cost(double length, slow::Set set) const {
        double paid = 0;
        for (std::size_t id = 0; id < prices.size(); ++id) paid += (set >> id & 1) ? prices[id] : 0;
        return unpaid(length, set) + paid;
    }
    double unpaid(double length, slow::Set set) const {
        for (std::size_t id = 0; id < done_after.size(); ++id) {
            if (set >> id & 1) length = std::max(length, done_after[id]);
        }
        return length;
    }

    // An obstacle is a letter, a capital one if nothing may remove it. Start and goal hide what is there.
    friend std::ostream& operator<<(std::ostream& out, const CrossingCase& problem) {
        const auto list = [&](const char* name, const std::vector<ObstacleId>& ids) {
            out << name;
            for (const ObstacleId id : ids) out << ' ' << letter(id.value, true);
        };
        for (Cell c; c.y < problem.map.height(); ++c.y) {
            for (c.x = 0; c.x < problem.map.width(); ++c.x) {
                const ObstacleId id = problem.map.obstacle_at(c);
                if (c == problem.start || c == problem.goal) {
                    out << (c == problem.start ? 'S' : 'G');
                } else {
                    out << (id ? letter(id.value, problem.map.obstacle(id).destructible) : '.');
                }
            }
            out << '\n';
        }
        out << (problem.relaxed ? "relaxed, " : "") << "radius " << problem.body.radius << " from " << problem.start.x
            << "," << problem.start.y << " to " << problem.goal.x << "," << problem.goal.y
            << ", n = " << problem.crossings;
        list(", removed", problem.removed);
        list(", protected", problem.protect);
        out << ", weights";
        for (const Obstacle& obstacle : problem.map.obstacles()) out << ' ' << obstacle.weight;
        out << ", budget " << problem.budget << ", done after";
        for (const double cost : problem.done_after) out << ' ' << cost;
        out << ", prices";
        for (const double price : problem.prices) out << ' ' << price;
        return out << '\n';
    }

  private:
    static char letter(std::uint32_t id, bool destructible) {
        return id > 26 ? '#' : char((destructible ? 'a' : 'A') + int(id) - 1);
    }
};

// A label map of some rectangles, frames and single cells: they touch, overlap, nest, and may come in several parts.
inline rc::Gen<std::vector<std::uint32_t>> random_labels(int width, int height) {
    return rc::gen::exec([=] {
        std::vector<std::uint32_t> labels(std::size_t(width) * std::size_t(height));
        const int shapes = *number(0, 9);
        for (int i = 0; i < shapes; ++i) {
            const auto label = std::uint32_t(*number(1, 7));
            const Cell min{*number(0, width - 1), *number(0, height - 1)};
            const Cell max{std::min(min.x + *number(0, 4), width - 1), std::min(min.y + *number(0, 4), height - 1)};
            const bool frame = *number(0, 2) == 0;
            for (Cell c = min; c.y <= max.y; ++c.y) {
                for (c.x = min.x; c.x <= max.x; ++c.x) {
                    const bool inner = c.x > min.x && c.x < max.x && c.y > min.y && c.y < max.y;
                    if (!frame || !inner) labels[std::size_t(c.y * width + c.x)] = label;
                }
            }
        }
        return labels;
    });
}

inline Map random_label_map(int most_side) {
    const int width = *number(1, most_side);
    const int height = *number(1, most_side);
    std::vector<ObstacleAttributes> attributes(8);
    for (ObstacleAttributes& label : attributes) label.destructible = *number(0, 5) > 0;
    return Map::from_labels(width, height, *random_labels(width, height), attributes);
}

inline Map random_connected_map(int most_side) {
    const PlainMap map = *random_map(most_side, most_side);
    return Map(map.grid(), *rc::gen::element(Connectivity::four, Connectivity::eight));
}

// Walls and stones, the walls cut along a lattice: each square of it is an obstacle.
inline Map random_sections(int most_side) {
    const PlainMap walls = *random_map(most_side, most_side);
    const int side = *number(2, 4);
    std::vector<std::uint32_t> labels;
    for (const Cell c : walls.cells()) {
        const bool stone = *number(0, 11) == 0;
        const int square = 2 + c.y / side * most_side + c.x / side;
        labels.push_back(!walls.blocked(c) ? 0 : stone ? 1 : std::uint32_t(square));
    }
    const std::vector<ObstacleAttributes> attributes{
        {}, {.destructible = false, .source_id = 0, .weight = 1, .breach_time = 0}};
    return Map::from_labels(walls.width, walls.height, std::move(labels), attributes);
}

// Few enough sets to try them all.
inline int most_crossings(const Map& map) {
    const std::size_t obstacles = map.obstacles().size();
    return obstacles <= 9 ? 4 : obstacles <= 13 ? 3 : obstacles <= 25 ? 2 : 1;
}

// A budget, and weights in whole numbers, so that sums are exact.
inline double random_budget(Map& map) {
    std::vector<double> weights;
    for (std::size_t id = 0; id <= map.obstacles().size(); ++id) weights.push_back(*number(1, 4));
    map = map.with_weights(weights);
    return *number(0, 8);
}

// When an aircraft has removed each obstacle, by id, and is home.
inline rc::Gen<std::vector<double>> some_times(const Map& map) {
    return rc::gen::container<std::vector<double>>(map.obstacles().size() + 1,
                                                   rc::gen::map(number(0, 16), [](int t) { return double(t); }));
}

inline CrossingCase random_case(Map map) {
    RC_PRE(map.obstacles().size() <= slow::most_obstacles);
    const int crossings = *number(0, most_crossings(map));
    const auto sometimes = [&](int most) {
        return *number(0, 3) == 0 ? some_obstacles(map, most) : std::vector<ObstacleId>{};
    };
    std::vector<ObstacleId> removed = sometimes(2);
    std::vector<ObstacleId> protect = sometimes(2);
    double budget = std::numeric_limits<double>::infinity();
    if (*number(0, 3) == 0) budget = random_budget(map);
    std::vector<double> done_after;
    if (*number(0, 3) == 0) done_after = *some_times(map);
    std::vector<double> prices;
    if (*number(0, 2) == 0) {
        for (std::size_t id = 0; id <= map.obstacles().size(); ++id) prices.push_back(0.5 * *number(0, 8));
    }
    const PlainMap opened = plain(map, removed);
    const Cell start = *number(0, 20) == 0 ? any_cell(opened) : any_free_cell(opened);
    const Cell goal = *number(0, 20) == 0 ? any_cell(opened) : any_free_cell(opened);
    const Mover mover = *rc::gen::elementOf(movers);
    return {std::move(map), start,  goal,       mover.body,    crossings, removed,
            protect,        budget, done_after, mover.relaxed, prices};
}

inline rc::Gen<CrossingCase> any_case(int most_side) {
    return rc::gen::exec([=] {
        return random_case(*number(0, 1) == 0 ? random_connected_map(most_side) : random_label_map(most_side));
    });
}

// One wall after the other, each with at most one gap and of a few obstacles that come back in later walls: paths are
// long, bend often, and cross the same obstacle again.
inline rc::Gen<CrossingCase> any_walls() {
    return rc::gen::exec([] {
        const int width = *number(4, 16);
        const int height = *number(2, 8);
        const int kinds = *number(2, 12);
        std::vector<std::uint32_t> labels(std::size_t(width * height));
        for (int x = 1; x < width - 1; x += 2) {
            const int gap = *number(-1, height - 1);
            const int split = *number(0, height);
            const auto above = std::uint32_t(*number(1, kinds));
            const auto below = std::uint32_t(*number(1, kinds));
            for (int y = 0; y < height; ++y) {
                if (y != gap) labels[std::size_t(y * width + x)] = y < split ? above : below;
            }
        }
        CrossingCase problem{
            Map::from_labels(width, height, labels), {0, *number(0, height - 1)}, {width - 1, *number(0, height - 1)}};
        problem.set(*rc::gen::elementOf(movers));
        problem.crossings = *number(0, 3);
        if (*number(0, 1) == 0) problem.budget = random_budget(problem.map);
        return problem;
    });
}

inline bool same_length(double a, double b) {
    return a == b || std::abs(a - b) <= 1e-9 * (1 + a);
}

// What is wrong with a path; nothing if it is legal, as long as it says, and crosses what it says.
inline std::string path_fault(const CrossingCase& problem, const slow::CrossingOracle& oracle,
                              const CrossingPath& found) {
    const std::vector<Point>& path = found.path;
    if (path.empty() || path.front() != Point(problem.start) || path.back() != Point(problem.goal)) {
        return "it does not lead from start to goal";
    }
    const slow::Set crossed = slow::set_of(found.crossed);
    if (std::size_t(std::popcount(crossed)) != found.crossed.size()) return "an obstacle is listed twice";
    if (crossed & slow::set_of(problem.removed)) return "a removed obstacle counts as crossed";
    const std::vector<slow::Set> choices = problem.choices();
    if (std::find(choices.begin(), choices.end(), crossed) == choices.end()) return "it may not cross that";

    const slow::Set gone = crossed | slow::set_of(problem.removed);
    slow::Set met = 0;
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto doubled = [](Point p) { return slow::Point{std::llround(2 * p.x), std::llround(2 * p.y)}; };
        const std::vector<slow::Set> demands = oracle.demands(doubled(path[i - 1]), doubled(path[i]));
        if (!slow::CrossingOracle::met(demands, gone)) return "leg " + std::to_string(i) + " is blocked";
        for (const slow::Set demand : demands) met |= demand;
        if (i > 1) {
            const std::vector<slow::Set> turn =
                oracle.demands_of_turn(doubled(path[i - 2]), doubled(path[i - 1]), doubled(path[i]));
            if (!slow::CrossingOracle::met(turn, gone)) return "turn " + std::to_string(i) + " is pinched";
            for (const slow::Set demand : turn) met |= demand;
        }
        length += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
    }
    if ((crossed & met) != crossed) return "it counts an obstacle that it does not meet";
    if (!same_length(length, found.length)) return "its length is " + std::to_string(length);
    const double cost = problem.cost(length, crossed);
    if (!same_length(cost, found.cost)) return "it costs " + std::to_string(cost);
    return "";
}

}  // namespace waybreaker

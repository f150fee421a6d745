#include "flight/best_cells.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace waybreaker {
namespace {

constexpr std::size_t most_pairs = 1 << 20;  // of cells of neighbouring stops

// Keeps, for each stop, the cells that a tour of this length could visit, were each its only stop.
std::vector<std::vector<Cell>> cells_in_reach(Point start, const Tour& tour, Point goal,
                                              std::span<const Target> targets, const Airspace& air) {
    const double length = tour_length(start, tour, goal, air) * (1 + least_gain);
    std::vector<std::vector<Cell>> cells;
    for (const Stop& stop : tour) {
        std::ranges::copy_if(targets[stop.target].cells, std::back_inserter(cells.emplace_back()),
                             [&](Cell c) { return air.length(start, c) + air.length(c, goal) <= length; });
    }
    return cells;
}

std::size_t pairs(const std::vector<std::vector<Cell>>& cells) {
    std::size_t pairs = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) pairs += cells[i - 1].size() * cells[i].size();
    return pairs;
}

struct Way {
    double length;     // from the start
    std::size_t from;  // the cell of the stop before
};

// The shortest way to a cell, over the cells of the stop before.
Way shortest_way(const std::vector<Way>& ways, const std::vector<Cell>& cells, Point to, const Airspace& air) {
    Way best{ways[0].length + air.length(cells[0], to), 0};
    for (std::size_t k = 1; k < cells.size(); ++k) {
        const double length = ways[k].length + air.length(cells[k], to);
        if (length < best.length) best = {length, k};
    }
    return best;
}

}  // namespace

bool choose_best_cells(Point start, Tour& tour, Point goal, std::span<const Target> targets, const Airspace& air) {
    if (tour.empty()) return false;
    const std::vector<std::vector<Cell>> cells = cells_in_reach(start, tour, goal, targets, air);
    if (pairs(cells) > most_pairs) return false;
    std::vector<std::vector<Way>> ways(tour.size());
    for (const Cell c : cells[0]) ways[0].push_back({air.length(start, c), 0});
    for (std::size_t i = 1; i < tour.size(); ++i) {
        for (const Cell c : cells[i]) ways[i].push_back(shortest_way(ways[i - 1], cells[i - 1], c, air));
    }
    const Way whole = shortest_way(ways.back(), cells.back(), goal, air);
    if (whole.length > tour_length(start, tour, goal, air) - least_gain) return false;
    std::size_t best = whole.from;
    for (std::size_t i = tour.size(); i-- > 0; best = ways[i][best].from) tour[i].at = cells[i][best];
    return true;
}

}  // namespace waybreaker

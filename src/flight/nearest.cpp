// The paper's flight for n > 1 (section 3): each obstacle where it is nearest to the segment start-goal.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "flight/target.hpp"

namespace waybreaker {
namespace {

std::int64_t dot(Cell a, Cell b) {
    return std::int64_t{a.x} * b.x + std::int64_t{a.y} * b.y;
}
std::int64_t cross(Cell a, Cell b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}
Cell minus(Cell a, Cell b) {
    return {a.x - b.x, a.y - b.y};
}
// In which it lies: all is counted in whole cells, so that it is exact.
Cell cell_at(Point p) {
    return {int(std::lround(p.x)), int(std::lround(p.y))};
}
std::int64_t squared_distance(Cell a, Cell b) {
    return dot(minus(a, b), minus(a, b));
}

// Squared distance of a cell from the segment start-goal, times the squared length of the segment (or times 1 where
// that is 0). Exact: map sides are below 2^15, so squared distances are below 2^31 and this is below 2^62.
std::int64_t squared_offset(Cell c, Cell start, Cell goal) {
    const Cell along = minus(goal, start);
    const Cell from_start = minus(c, start);
    const std::int64_t squared_length = std::max<std::int64_t>(dot(along, along), 1);
    const std::int64_t progress = dot(along, from_start);
    if (progress <= 0) return dot(from_start, from_start) * squared_length;
    if (progress >= squared_length) return squared_distance(c, goal) * squared_length;
    return cross(along, from_start) * cross(along, from_start);
}

Cell nearest_to_segment(const Target& target, Cell start, Cell goal) {
    const auto rank = [&](Cell c) { return std::pair(squared_offset(c, start, goal), squared_distance(c, start)); };
    return std::ranges::min(target.cells, {}, rank);
}

}  // namespace

Tour nearest_tour(Point start, Point goal, std::span<const Target> targets) {
    const Cell from = cell_at(start);
    const Cell to = cell_at(goal);
    Tour tour;
    for (std::size_t i = 0; i < targets.size(); ++i) tour.push_back({i, nearest_to_segment(targets[i], from, to)});
    std::ranges::stable_sort(tour, {}, [&](const Stop& stop) { return squared_distance(stop.at, from); });
    return tour;
}

Flight fly_nearest(const Map& map, Point start, Point goal, std::span<const ObstacleId> obstacles,
                   const Airspace& air) {
    const std::vector<Target> targets = targets_of(map, obstacles, air, start);
    return flight_of(start, nearest_tour(start, goal, targets), goal, targets, air);
}

}  // namespace waybreaker

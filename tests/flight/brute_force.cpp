#include "flight/brute_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace waybreaker {

std::vector<Cell> slow_boundary(const Map& map, ObstacleId id) {
    std::vector<Cell> cells;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (map.obstacle_at({x, y}) == id) continue;
            bool touches = false;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const Cell neighbour{x + dx, y + dy};
                    touches = touches || (map.grid().contains(neighbour) && map.obstacle_at(neighbour) == id);
                }
            }
            if (touches) cells.push_back({x, y});
        }
    }
    return cells;
}

namespace {

long double offset_from_segment(Cell c, Cell start, Cell goal) {
    const long double dx = goal.x - start.x;
    const long double dy = goal.y - start.y;
    const long double squared = dx * dx + dy * dy;
    long double t = squared > 0 ? ((c.x - start.x) * dx + (c.y - start.y) * dy) / squared : 0;
    t = std::clamp(t, 0.0L, 1.0L);
    return std::hypot(start.x + t * dx - c.x, start.y + t * dy - c.y);
}

// Whether a comes before b in the paper's choice of cell.
bool nearer(Cell a, Cell b, Cell start, Cell goal) {
    const long double difference = offset_from_segment(a, start, goal) - offset_from_segment(b, start, goal);
    if (std::abs(difference) > 1e-12L) return difference < 0;
    return distance(a, start) < distance(b, start);
}

double slow_length(Cell at, Cell goal, const std::vector<std::vector<Cell>>& boundaries, std::vector<bool>& visited) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
        if (visited[i]) continue;
        visited[i] = true;
        for (const Cell c : boundaries[i]) {
            least = std::min(least, distance(at, c) + slow_length(c, goal, boundaries, visited));
        }
        visited[i] = false;
    }
    const bool all_visited = std::ranges::find(visited, false) == visited.end();
    return all_visited ? distance(at, goal) : least;
}

}  // namespace

Flight slow_nearest(const Map& map, Cell start, Cell goal, std::vector<ObstacleId> ids) {
    Flight flight;
    for (const ObstacleId id : ids) {
        const std::vector<Cell> boundary = slow_boundary(map, id);
        Cell best = boundary.front();
        for (const Cell c : boundary) {
            if (nearer(c, best, start, goal)) best = c;
        }
        flight.breaches.push_back({id, best});
    }
    std::ranges::sort(flight.breaches, {}, [&](const BreachPoint& breach) {
        return std::tuple(distance(breach.at, start), breach.obstacle);
    });
    Cell at = start;
    for (const BreachPoint& breach : flight.breaches) {
        flight.length += distance(at, breach.at);
        at = breach.at;
    }
    flight.length += distance(at, goal);
    return flight;
}

double slow_optimal_length(const Map& map, Cell start, Cell goal, std::vector<ObstacleId> ids) {
    std::vector<std::vector<Cell>> boundaries;
    for (const ObstacleId id : ids) boundaries.push_back(slow_boundary(map, id));
    std::vector<bool> visited(ids.size(), false);
    return slow_length(start, goal, boundaries, visited);
}

void expect_valid(const Map& map, Cell start, Cell goal, const std::vector<ObstacleId>& ids, const Flight& flight) {
    std::vector<ObstacleId> breached;
    double length = 0;
    Cell at = start;
    for (const BreachPoint& breach : flight.breaches) {
        breached.push_back(breach.obstacle);
        const std::vector<Cell> boundary = slow_boundary(map, breach.obstacle);
        EXPECT_NE(std::ranges::find(boundary, breach.at), boundary.end());
        length += distance(at, breach.at);
        at = breach.at;
    }
    EXPECT_NEAR(flight.length, length + distance(at, goal), 1e-9);
    std::ranges::sort(breached);
    EXPECT_EQ(breached, ids);
}

rc::Gen<World> arbitrary_world(int width, int height, int obstacles, int side) {
    return rc::gen::exec([=]() -> World {
        std::vector<std::uint32_t> labels(std::size_t(width) * std::size_t(height), 0);
        const auto arbitrary_cell = [=] { return Cell{*uniform(0, width), *uniform(0, height)}; };
        for (int label = 1; label <= obstacles; ++label) {
            const Cell corner = arbitrary_cell();
            const int right = std::min(corner.x + *uniform(1, side + 1), width);
            const int bottom = std::min(corner.y + *uniform(1, side + 1), height);
            for (int y = corner.y; y < bottom; ++y) {
                for (int x = corner.x; x < right; ++x) labels[std::size_t(y * width + x)] = std::uint32_t(label);
            }
        }
        labels[0] = 0;
        World world{Map::from_labels(width, height, labels), arbitrary_cell(), arbitrary_cell(), {}};
        for (const Obstacle& obstacle : world.map.obstacles()) world.ids.push_back(obstacle.id);
        return world;
    });
}

}  // namespace waybreaker

// A unit alone: which walls does it break by itself, from where, and is that sooner than the way round?
#include <iostream>
#include <waybreaker/waybreaker.hpp>

namespace wb = waybreaker;

int main() {
    const wb::Map map = wb::Map::from_rows({
        "....A....B....",
        "....A....B....",
        "....A....B....",
        "....A....B....",
        ".........B....",
    });
    wb::Planner planner;  // kept: it keeps its memory
    for (const double strength : {4.0, 1.0, 0.25}) {
        // A unit that drives a cell a second and breaks so many cells of wall a second.
        const auto cost = [strength](const wb::Obstacle& wall) { return wall.cells / strength; };
        const wb::PathThrough way = planner.path_through(map, {1, 1}, {12, 1}, cost);
        if (way.status != wb::PlanStatus::solved) return 1;
        std::cout << "strength " << strength << ": there after " << way.cost << '\n';
        for (const wb::Broken& broken : way.broken) {
            std::cout << "  breaks wall " << broken.obstacle.value << " from (" << broken.at.x << ", " << broken.at.y
                      << ") in " << broken.cost << '\n';
        }
    }
}

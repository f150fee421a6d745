// Paths in time past one obstacle that opens late, against the best place to wait at, looked for along its whole front.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "crossing_case.hpp"

namespace waybreaker {
namespace {

// A wall from the upper edge to the lower one, with the start to the left of it and the goal to the right.
struct Wall {
    int width = 0;
    int height = 0;
    int first = 0;  // column
    int last = 0;
    Cell start;
    Cell goal;

    Map map() const {
        Grid grid(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = first; x <= last; ++x) grid.set_blocked({x, y}, true);
        }
        return Map(std::move(grid));
    }

    // The least cost of a point if the wall is gone after so many cells of driving, on hundredths of the front.
    double cost(double open) const {
        double least = std::numeric_limits<double>::infinity();
        for (int i = -50; i <= 100 * (height - 1) + 50; ++i) {
            const Point front{first - 0.5, i / 100.0};
            least = std::min(least, std::max(open, distance(start, front)) + distance(front, goal));
        }
        return least;
    }
};

rc::Gen<Wall> any_wall() {
    return rc::gen::exec([] {
        Wall wall;
        wall.width = *number(5, 16);
        wall.height = *number(2, 12);
        wall.first = *number(1, wall.width - 2);
        wall.last = *number(wall.first, wall.width - 2);
        wall.start = {*number(0, wall.first - 1), *number(0, wall.height - 1)};
        wall.goal = {*number(wall.last + 1, wall.width - 1), *number(0, wall.height - 1)};
        return wall;
    });
}

RC_GTEST_PROP(TimedCrossing, WaitsWhereTheRestOfTheWayIsShortest, ()) {
    const Wall wall = *any_wall();
    const double open = *number(0, 300) / 10.0;
    const Map map = wall.map();
    CrossingOptions options;
    options.body = point_body;
    options.crossings = 1;
    options.opened_after = [open](std::span<const ObstacleId> crossed) { return crossed.empty() ? 0 : open; };
    const CrossingResult found = CrossingSearcher().find(map, wall.start, wall.goal, options);
    RC_ASSERT(found.status == SearchStatus::found);
    const double best = wall.cost(open);
    RC_LOG() << wall.width << 'x' << wall.height << ' ' << open << ": " << found.best.cost << ' ' << best << '\n';
    RC_ASSERT(found.best.cost <= best + 1e-9);
    RC_ASSERT(found.best.cost >=
              best - 1);  // a gate stands for all places within half a cell, and is left so much earlier
}

}  // namespace
}  // namespace waybreaker

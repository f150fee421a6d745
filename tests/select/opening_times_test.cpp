// Opening times are lower limits of every flight, against all orders and all boundary cells.
#include "select/opening_times.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "flight/target.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

struct Times {
    double open = std::numeric_limits<double>::infinity();
    double home = std::numeric_limits<double>::infinity();
};

// When the last one is open, and when the aircraft is home, at the earliest: each for itself.
Times earliest(const Task& task, std::vector<Target> left, Cell at, double time) {
    if (left.empty()) return {time, time + distance(at, task.flyer.goal) / task.flyer.speed};
    Times best;
    for (std::size_t i = 0; i < left.size(); ++i) {
        std::vector<Target> others = left;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const double stay = task.rules.breach_time.of(task.map.obstacle(left[i].obstacle));
        for (const Cell c : left[i].cells) {
            const Times found = earliest(task, others, c, time + distance(at, c) / task.flyer.speed + stay);
            best = {std::min(best.open, found.open), std::min(best.home, found.home)};
        }
    }
    return best;
}

RC_GTEST_PROP(OpeningTimes, AreLowerLimitsOfAllFlights, ()) {
    const PlainMap plain = *random_map(9, 9);
    RC_PRE(!plain.free_cells().empty());
    const Map map(plain.grid());
    std::vector<ObstacleId> set = some_obstacles(map, 3);
    std::ranges::sort(set);
    set.erase(std::ranges::unique(set).begin(), set.end());
    Mission mission = ground_and_air({0, 0}, {0, 0});
    mission.rules.breach_time = {*rc::gen::element(0.0, 2.0), *rc::gen::element(0.0, 0.5)};
    for (Agent& agent : mission.agents) {
        agent.start = any_cell(plain);
        agent.goal = any_cell(plain);
        agent.speed = *rc::gen::element(1.0, 0.5, 3.0);
    }
    const Method method;
    const Limits limits;
    const Task task = task_of(map, mission, method, limits);
    const Times best = earliest(task, targets_of(map, set), task.flyer.start, 0);
    OpeningTimes times(task);
    const double driven = task.driver.speed;
    RC_LOG() << set.size() << " obstacles: " << best.open << ' ' << best.home << '\n';
    RC_ASSERT(set.empty() || times.cells(set) <= best.open * driven + 1e-9);
    RC_ASSERT(times.flight_cells(set) <= best.home * driven + 1e-9);
    // Alone, it is the flight itself.
    if (set.size() == 1) RC_ASSERT(times.cells(set) >= best.open * driven - 1e-9);
}

}  // namespace
}  // namespace waybreaker

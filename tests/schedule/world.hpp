// Random drives past obstacles that are all removed, and how good a schedule of one is.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "model/timeline.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/schedule.hpp"

namespace waybreaker {

struct World {
    Map map;
    std::vector<Point> street;
    std::vector<ObstacleId> removed;
    Agent driver = {};
    Agent flyer = {.kind = AgentKind::air};
    Rules rules = {};

    ScheduleTask task() const {
        return {.ground_path = street, .driver = driver, .flyer = flyer, .rules = rules, .removed = removed};
    }
};

// `obstacles` boxes of up to `side` cells a side, all removed, and any drive across them.
inline World any_world(int width, int height, int obstacles, int side) {
    std::vector<std::uint32_t> labels(std::size_t(width * height), 0);
    const auto any_place = [=] { return Cell{*number(0, width - 1), *number(0, height - 1)}; };
    for (int label = 1; label <= obstacles; ++label) {
        const Cell corner = any_place();
        const Cell end{std::min(corner.x + *number(1, side), width), std::min(corner.y + *number(1, side), height)};
        for (Cell c = corner; c.y < end.y; ++c.y) {
            for (c.x = corner.x; c.x < end.x; ++c.x) labels[std::size_t(c.y * width + c.x)] = std::uint32_t(label);
        }
    }
    labels[0] = 0;
    World world{Map::from_labels(width, height, labels), {}, {}};
    for (const Obstacle& obstacle : world.map.obstacles()) world.removed.push_back(obstacle.id);
    const int turns = *number(1, 4);
    for (int i = 0; i < turns; ++i) world.street.push_back(any_place());
    world.driver.speed = *rc::gen::element(0.5, 1.0, 1.0, 3.0);
    world.flyer.speed = *rc::gen::element(0.5, 1.0, 1.0, 3.0);
    world.driver.body.radius = *rc::gen::element(0.0, 0.5, 1.5);
    world.flyer.start =
        *rc::gen::arbitrary<bool>() ? any_place() : Cell{int(world.street.front().x), int(world.street.front().y)};
    world.flyer.goal =
        *rc::gen::arbitrary<bool>() ? any_place() : Cell{int(world.street.back().x), int(world.street.back().y)};
    world.rules.breach_time.per_obstacle = *rc::gen::element(0.0, 0.0, 1.0, 7.5);
    world.rules.breach_time.per_cell = *rc::gen::element(0.0, 0.0, 0.1, 2.0);
    world.rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    // Where it waits from the first moment on it touches nothing.
    const Point& first = world.street.front();
    const std::vector<Waypoint> waiting{{first.x, first.y, 0}, {first.x, first.y, 1}};
    for (const ObstacleId id : world.removed) RC_PRE(!first_touch(world.map, id, waiting, world.driver.body.reach()));
    return world;
}

using Pair = std::pair<double, double>;
inline Pair rank(Objective objective, double ground, double air) {
    const double makespan = std::max(ground, air);
    const double flowtime = ground + air;
    if (objective == Objective::ground_makespan) return {ground, flowtime};
    return objective == Objective::makespan ? Pair{makespan, flowtime} : Pair{flowtime, makespan};
}
inline Pair rank(Objective objective, const Schedule& schedule) {
    return rank(objective, schedule.ground.back().t, schedule.air.back().t);
}

}  // namespace waybreaker

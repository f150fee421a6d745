// Small random missions of one ground and one air agent, for RapidCheck.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "random_map.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

struct World {
    Map map;
    Mission mission;
};

inline bool is_plannable(const World& world) {
    try {
        validate(world.map, world.mission);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

inline constexpr std::uint32_t river = 4;

// Across the map, and bridged in a few places.
inline void add_river(std::vector<std::uint32_t>& labels, int width, int height) {
    const bool down = *rc::gen::arbitrary<bool>();
    const int at = *number(0, (down ? width : height) - 1);
    const int length = down ? height : width;
    const auto bridges = *rc::gen::container<std::vector<int>>(std::size_t(*number(0, 2)), number(0, length - 1));
    for (int i = 0; i < length; ++i) {
        if (std::ranges::find(bridges, i) != bridges.end()) continue;
        labels[std::size_t(down ? i * width + at : at * width + i)] = river;
    }
}

inline std::vector<Cell> free_cells(const Map& map) {
    std::vector<Cell> free;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (!map.grid().blocked(c)) free.push_back(c);
        }
    }
    return free;
}

inline Cell one_of(const std::vector<Cell>& cells) {
    return cells[std::size_t(*number(0, int(cells.size()) - 1))];
}

inline World any_world() {
    const int width = *number(2, 8);
    const int height = *number(2, 6);
    auto labels = *rc::gen::container<std::vector<std::uint32_t>>(
        std::size_t(width * height), rc::gen::weightedElement<std::uint32_t>({{5, 0}, {2, 1}, {1, 2}, {1, 3}}));
    if (*number(0, 2) == 0) add_river(labels, width, height);
    std::vector<ObstacleAttributes> attributes(river + 1);
    attributes[river].destructible = false;
    Map map = Map::from_labels(width, height, labels, attributes);
    const std::vector<Cell> free = free_cells(map);
    RC_PRE(!free.empty());
    const Cell start = one_of(free);  // drawn in this order by every compiler
    const Cell goal = one_of(free);
    World world{std::move(map), ground_and_air(start, goal)};
    Agent& air = world.mission.agents[1];
    if (*rc::gen::arbitrary<bool>()) air.start = {*number(0, width - 1), *number(0, height - 1)};
    if (*rc::gen::arbitrary<bool>()) air.goal = {*number(0, width - 1), *number(0, height - 1)};
    world.mission.agents[0].speed = *rc::gen::element(0.5, 1.0, 1.0, 2.0);
    air.speed = *rc::gen::element(0.5, 1.0, 1.0, 3.0);
    if (*number(0, 2) == 0) world.mission.agents[0].ready_at = *rc::gen::element(0.5, 2.0, 7.5);
    Rules& rules = world.mission.rules;
    rules.removals = *number(1, 2);
    if (!world.map.obstacles().empty() && *number(0, 2) == 0) rules.protect = {ObstacleId{1}};
    rules.objective = *rc::gen::element(Objective::makespan, Objective::flowtime, Objective::ground_makespan);
    rules.breach_time = {*rc::gen::element(0.0, 1.0, 4.5), *rc::gen::element(0.0, 0.0, 0.3)};
    return world;
}

}  // namespace waybreaker

// Map edits: a world that changes, whose obstacles keep their ids.
//
//     map = map.with({MapEdit::remove(breach.obstacle)});                  // a wall falls
//     map = map.with({MapEdit::add({{4, 2}, {5, 2}}, {.weight = 2}),       // one is built: its id is the next,
//                     MapEdit::free({{9, 9}})});                           // obstacles().size(); a cell is cleared
#pragma once

#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

struct MapEdit {
    enum class Kind { remove, add, extend, free };
    Kind kind = Kind::free;
    ObstacleId obstacle = {};
    std::vector<Cell> cells = {};
    ObstacleAttributes attributes = {};

    // All cells of the obstacle are free then, and it is gone.
    [[nodiscard]] static MapEdit remove(ObstacleId obstacle);
    // A new obstacle has these cells, at least one, whatever they were. Its id is the one after the last:
    // obstacles().size() of the map that comes out, if nothing is added after it.
    [[nodiscard]] static MapEdit add(std::vector<Cell> cells, const ObstacleAttributes& attributes = {});
    // The obstacle has these cells as well, whatever they were.
    [[nodiscard]] static MapEdit extend(ObstacleId obstacle, std::vector<Cell> cells);
    // These cells are free. An obstacle that has lost all its cells, in this way or to others, is gone.
    [[nodiscard]] static MapEdit free(std::vector<Cell> cells);
};

}  // namespace waybreaker

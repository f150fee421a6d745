// Plain maps for tests: one number a cell, every question answered the obvious way and without the code under test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

struct PlainMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> obstacles;  // row by row; 0 = free

    bool contains(Cell c) const { return c.x >= 0 && c.x < width && c.y >= 0 && c.y < height; }
    std::size_t index(Cell c) const { return std::size_t(c.y) * std::size_t(width) + std::size_t(c.x); }
    std::uint32_t at(Cell c) const { return obstacles[index(c)]; }
    bool blocked(Cell c) const { return !contains(c) || at(c) != 0; }

    std::vector<Cell> cells() const {
        std::vector<Cell> all;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) all.push_back({x, y});
        }
        return all;
    }
    std::vector<Cell> free_cells() const {
        std::vector<Cell> free;
        for (const Cell c : cells()) {
            if (!blocked(c)) free.push_back(c);
        }
        return free;
    }

    Grid grid() const {
        Grid result(width, height);
        for (const Cell c : cells()) result.set_blocked(c, blocked(c));
        return result;
    }

    // Shown by RapidCheck when a property fails.
    friend std::ostream& operator<<(std::ostream& out, const PlainMap& map) {
        out << map.width << " x " << map.height << '\n';
        for (const Cell c : map.cells()) out << (map.blocked(c) ? '#' : '.') << (c.x == map.width - 1 ? "\n" : "");
        return out;
    }
};

inline PlainMap plain(const Map& map, std::span<const ObstacleId> removed = {}) {
    PlainMap result{map.width(), map.height(), {map.labels().begin(), map.labels().end()}};
    for (std::uint32_t& obstacle : result.obstacles) {
        for (const ObstacleId id : removed) obstacle = obstacle == id.value ? 0 : obstacle;
    }
    return result;
}

}  // namespace waybreaker

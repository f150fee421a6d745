// Maps as pictures, for tests:
//
//     const std::string_view picture = R"(
//         S..aa
//         ...aa
//         .b..G)";
//     const Map map = map_from_ascii(picture);
//     const Cell start = mark_in_ascii(picture, 'S');
//     const ObstacleId b = map.obstacle_at(mark_in_ascii(picture, 'b'));
//
// `.` is free, and so are the marks `S` and `G`. `#` and the other letters are blocked: a picture with letters is a
// label map (one obstacle for each letter, and one for `#`), one with `#` alone is labelled by connectivity. White
// space at the ends of lines and empty lines do not count.
#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker {

// The rows of a picture, all of one length.
inline std::vector<std::string> ascii_rows(std::string_view picture) {
    std::vector<std::string> rows;
    std::istringstream words{std::string(picture)};
    for (std::string row; words >> row;) rows.push_back(row);
    if (rows.empty()) throw std::invalid_argument("an empty picture");
    for (const std::string& row : rows) {
        if (row.size() != rows.front().size()) throw std::invalid_argument("a picture with uneven rows: " + row);
    }
    return rows;
}

// The first cell, in scan order, that shows `mark`.
inline Cell mark_in_ascii(std::string_view picture, char mark) {
    const std::vector<std::string> rows = ascii_rows(picture);
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (const std::size_t x = rows[y].find(mark); x != std::string::npos) return {int(x), int(y)};
    }
    throw std::invalid_argument(std::string("no such mark in the picture: ") + mark);
}

inline Map map_from_ascii(std::string_view picture, Connectivity connectivity = Connectivity::four) {
    const std::vector<std::string> rows = ascii_rows(picture);
    Grid grid(int(rows.front().size()), int(rows.size()));
    std::vector<std::uint32_t> labels;
    bool has_letters = false;
    for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
            const char cell = rows[std::size_t(y)][std::size_t(x)];
            const bool letter = std::isalpha(static_cast<unsigned char>(cell)) && cell != 'S' && cell != 'G';
            if (!letter && std::string_view(".#SG").find(cell) == std::string_view::npos) {
                throw std::invalid_argument(std::string("a picture cannot show ") + cell);
            }
            const bool blocked = letter || cell == '#';
            has_letters = has_letters || letter;
            grid.set_blocked({x, y}, blocked);
            labels.push_back(blocked ? static_cast<unsigned char>(cell) : 0);
        }
    }
    if (has_letters) return Map::from_labels(grid.width(), grid.height(), std::move(labels));
    return Map(std::move(grid), connectivity);
}

}  // namespace waybreaker

// Random maps, ways of moving and places for RapidCheck; they shrink towards small and free maps.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <vector>

#include "plain_map.hpp"
#include "waybreaker/body.hpp"

namespace waybreaker {

// A number from first to last, all equally likely from the first case on.
inline rc::Gen<int> number(int first, int last) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last + 1));
}

// Some share of single blocked cells and some blocked rectangles, on 1 x 1 to max_width x max_height cells.
inline rc::Gen<PlainMap> random_map(int max_width, int max_height) {
    return rc::gen::exec([=] {
        PlainMap map{*number(1, max_width), *number(1, max_height), {}};
        const int percent = *rc::gen::element(0, 3, 10, 25, 40);
        const std::size_t cells = std::size_t(map.width) * std::size_t(map.height);
        const auto draws = *rc::gen::container<std::vector<int>>(cells, number(0, 99));
        for (const int draw : draws) map.obstacles.push_back(draw >= 100 - percent ? 1 : 0);
        const int rectangles = *number(0, 8);
        for (int i = 0; i < rectangles; ++i) {
            const Cell corner{*number(0, map.width - 1), *number(0, map.height - 1)};
            const Cell end{std::min(corner.x + *number(1, 1 + map.width / 4), map.width),
                           std::min(corner.y + *number(1, 1 + map.height / 4), map.height)};
            for (Cell c = corner; c.y < end.y; ++c.y) {
                for (c.x = corner.x; c.x < end.x; ++c.x) map.obstacles[map.index(c)] = 1;
            }
        }
        return map;
    });
}

// Any cell of the map, or any free one (the case is given up where there is none).
inline Cell any_cell(const PlainMap& map) {
    return {*number(0, map.width - 1), *number(0, map.height - 1)};
}
inline Cell any_free_cell(const PlainMap& map) {
    const std::vector<Cell> free = map.free_cells();
    RC_PRE(!free.empty());
    return free[std::size_t(*number(0, int(free.size()) - 1))];
}

// Up to `most` of the map's obstacles.
inline std::vector<ObstacleId> some_obstacles(const Map& map, int most) {
    std::vector<ObstacleId> chosen;
    if (map.obstacles().empty()) return chosen;
    const int count = *number(0, most);
    for (int i = 0; i < count; ++i) chosen.push_back({std::uint32_t(*number(1, int(map.obstacles().size())))});
    return chosen;
}

inline Corners any_corners() {
    return *rc::gen::element(Corners::none, Corners::cut, Corners::squeeze);
}

inline Body any_body() {
    return {.corners = any_corners()};
}
inline bool mostly() {
    return *number(0, 3) < 3;
}

}  // namespace waybreaker

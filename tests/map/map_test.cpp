#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// What the map says of its obstacles, recomputed cell by cell from its labels.
void check_obstacles(const Map& map) {
    const PlainMap labels = plain(map);
    std::map<std::uint32_t, std::vector<Cell>> cells_of;
    std::uint32_t last = 0;
    for (const Cell c : labels.cells()) {
        const std::uint32_t id = labels.at(c);
        RC_ASSERT(map.obstacle_at(c).value == id);
        RC_ASSERT(map.grid().blocked(c) == (id != 0));
        RC_ASSERT(map.transposed().blocked({c.y, c.x}) == (id != 0));
        if (id == 0) continue;
        RC_ASSERT(id <= last + 1);  // ids in scan order of the first cells
        last = std::max(last, id);
        cells_of[id].push_back(c);
    }
    RC_ASSERT(map.obstacles().size() == cells_of.size());
    for (const auto& [id, cells] : cells_of) {
        const Obstacle& obstacle = map.obstacle({id});
        RC_ASSERT(obstacle.id.value == id);
        RC_ASSERT(obstacle.cells == cells.size());
        Box bounds{cells.front(), cells.front()};
        for (const Cell c : cells) {
            bounds = {{std::min(bounds.min.x, c.x), std::min(bounds.min.y, c.y)},
                      {std::max(bounds.max.x, c.x), std::max(bounds.max.y, c.y)}};
        }
        RC_ASSERT(obstacle.bounds == bounds);

        std::vector<Cell> boundary;  // by definition
        for (const Cell c : labels.cells()) {
            const bool touches = std::any_of(cells.begin(), cells.end(), [c](Cell other) {
                return std::abs(c.x - other.x) <= 1 && std::abs(c.y - other.y) <= 1;
            });
            if (touches && labels.at(c) != id) boundary.push_back(c);
        }
        RC_ASSERT(map.boundary({id}) == boundary);
    }
}

RC_GTEST_PROP(Map, KnowsItsObstacles, ()) {
    const Connectivity connectivity = *rc::gen::element(Connectivity::four, Connectivity::eight);
    check_obstacles(Map((*random_map(16, 12)).grid(), connectivity));
}

RC_GTEST_PROP(Map, TakesAnyLabels, ()) {
    const int width = *number(1, 12);
    const int height = *number(1, 9);
    const auto cells = std::size_t(width * height);
    const auto labels = *rc::gen::container<std::vector<std::uint32_t>>(
        cells, rc::gen::element<std::uint32_t>(0, 0, 0, 1, 2, 3, 7, 4'000'000'000, 0xFFFFFFFF));
    std::vector<ObstacleAttributes> attributes(5);
    attributes[1] = {.destructible = false, .source_id = -11};
    attributes[3] = {.destructible = true, .source_id = 1'234'567'890'123};
    const Map map = Map::from_labels(width, height, labels, attributes);
    check_obstacles(map);
    // Numbered anew one to one, and described by their old label.
    std::map<std::uint32_t, std::uint32_t> id_of;
    for (std::size_t i = 0; i < cells; ++i) {
        const std::uint32_t id = map.labels()[i];
        RC_ASSERT((id == 0) == (labels[i] == 0));
        if (id == 0) continue;
        RC_ASSERT(id_of.try_emplace(labels[i], id).first->second == id);
        const bool described = labels[i] < attributes.size();
        RC_ASSERT(map.obstacle({id}).destructible == (!described || attributes[labels[i]].destructible));
        RC_ASSERT(map.obstacle({id}).source_id == (described ? attributes[labels[i]].source_id : 0));
    }
    RC_ASSERT(id_of.size() == map.obstacles().size());
}

TEST(Map, LetsObstaclesTouch) {
    const Map map = map_from_ascii(R"(
        aabb
        a..b
        c..a)");
    ASSERT_EQ(map.obstacles().size(), 3U);
    EXPECT_EQ(map.obstacle_at({3, 2}), map.obstacle_at({0, 0}));
    EXPECT_EQ(map.obstacle({1}).bounds, (Box{{0, 0}, {3, 2}}));
    EXPECT_EQ(map.boundary({3}), (std::vector<Cell>{{0, 1}, {1, 1}, {1, 2}}));
}

TEST(Map, RefusesWrongNumbersOfLabels) {
    EXPECT_THROW(static_cast<void>(Map::from_labels(3, 3, std::vector<std::uint32_t>(8))), InputError);
    EXPECT_THROW(static_cast<void>(Map::from_labels(3, 3, std::vector<std::uint32_t>(10))), InputError);
    EXPECT_THROW(static_cast<void>(Map::from_labels(0, 3, {})), InputError);
    EXPECT_THROW(static_cast<void>(Map::from_labels(max_side, max_side, {})), InputError);
}

TEST(Map, IsMadeOfRowsOfCharacters) {
    const Map map = Map::from_rows({"..#A..", "..#.A.", "A....."});
    EXPECT_EQ(map.width(), 6);
    EXPECT_EQ(map.height(), 3);
    ASSERT_EQ(map.obstacles().size(), 2U);
    EXPECT_EQ(map.obstacle({1}).source_id, '#');
    EXPECT_EQ(map.obstacle({1}).cells, 2U);
    EXPECT_EQ(map.obstacle({2}).source_id, 'A') << "whether its cells lie together or not";
    EXPECT_EQ(map.obstacle({2}).cells, 3U);
    EXPECT_TRUE(map.obstacle({2}).destructible);
    EXPECT_EQ(Map::from_rows({"\xff \n"}).obstacle({1}).source_id, 255);
    EXPECT_EQ(Map::from_rows({"\xff \n"}).obstacles().size(), 3U) << "any character but the point is blocked";
    EXPECT_TRUE(Map::from_rows({"...", "..."}).obstacles().empty());
}

TEST(Map, RefusesRowsThatMakeNoMap) {
    EXPECT_THROW(static_cast<void>(Map::from_rows({})), InputError);
    EXPECT_THROW(static_cast<void>(Map::from_rows({""})), InputError);
    EXPECT_EQ(input_error([] {
                  static_cast<void>(Map::from_rows({"...", "...."}));
              }),
              "row 1 of the map has 4 cells, and row 0 has 3");
    EXPECT_THROW(static_cast<void>(Map::from_rows({std::string(max_side + 1, '.')})), InputError);
}

TEST(Map, RefusesWeightsAndTimesOutOfRange) {
    const auto map_of = [](ObstacleAttributes attributes) {
        return Map::from_labels(2, 1, {0, 1}, std::vector{ObstacleAttributes{}, attributes});
    };
    EXPECT_EQ(map_of({.weight = 1e12, .breach_time = 1e9}).obstacle({1}).breach_time, 1e9);
    for (const double weight : {0.0, -1.0, 1e-320, 1e13, std::nan("")}) {
        EXPECT_THROW(map_of({.weight = weight}), InputError) << weight;
    }
    for (const double time : {-1.0, 1e10, HUGE_VAL, std::nan("")}) {
        EXPECT_THROW(map_of({.breach_time = time}), InputError) << time;
    }
}

TEST(Map, CanWeighObstaclesAnew) {
    const Map map = map_from_ascii("a.b.c");
    const Map heavy = map.with_weights(std::vector<double>{0, 2, 0.5, 1});
    EXPECT_EQ(heavy.obstacle({1}).weight, 2);
    EXPECT_EQ(heavy.obstacle({2}).weight, 0.5);
    EXPECT_EQ(map.obstacle({1}).weight, 1) << "the map it was made from stays as it is";
    EXPECT_EQ(heavy.identity(), map.identity()) << "the same cells";
    for (const std::vector<double>& wrong :
         {std::vector<double>{}, {0}, {0, 1, 1}, {0, 1, 1, 0}, {0, 1, 1, 1e13}, {0, 1, std::nan(""), 1}}) {
        EXPECT_THROW(static_cast<void>(map.with_weights(wrong)), InputError);
    }
}

}  // namespace
}  // namespace waybreaker

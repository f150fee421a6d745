// Edited maps are what a map made from scratch of the same labels is, and obstacles keep their ids.
#include "waybreaker/map_edit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "input_error.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

Map level() {
    return Map::from_rows({
        "..A..B..",
        "..A..B..",
        "..AA.BCC",
    });
}
constexpr ObstacleId wall_a{1};
constexpr ObstacleId wall_b{2};
constexpr ObstacleId wall_c{3};

TEST(MapEdit, AWallFallsAndTheOthersKeepTheirIds) {
    const Map before = level();
    const Map after = before.with({MapEdit::remove(wall_a)});
    EXPECT_FALSE(after.obstacle_at({2, 0}));
    EXPECT_FALSE(after.grid().blocked({3, 2}));
    EXPECT_FALSE(after.transposed().blocked({2, 3}));
    EXPECT_EQ(after.obstacle_at({5, 0}), wall_b);
    EXPECT_EQ(after.obstacle(wall_b).source_id, 'B');
    ASSERT_EQ(after.obstacles().size(), 3U);
    EXPECT_TRUE(after.obstacle(wall_a).gone());
    EXPECT_FALSE(after.obstacle(wall_a).destructible);
    EXPECT_EQ(after.obstacle(wall_a).source_id, 'A');
    EXPECT_TRUE(after.boundary(wall_a).empty());
    EXPECT_TRUE(after.obstacles_touch());
    EXPECT_FALSE(after.with({MapEdit::remove(wall_c)}).obstacles_touch());
    EXPECT_EQ(before.obstacle_at({2, 0}), wall_a) << "the map it was made from stays as it is";
    EXPECT_NE(after.identity(), before.identity());
}

TEST(MapEdit, AWallIsBuilt) {
    const Map map = level().with({MapEdit::add({{0, 0}, {0, 1}}, {.source_id = 7, .weight = 2, .breach_time = 3}),
                                  MapEdit::add({{7, 0}}, {.destructible = false})});
    ASSERT_EQ(map.obstacles().size(), 5U);
    EXPECT_EQ(map.obstacle_at({0, 1}), ObstacleId{4});
    EXPECT_EQ(map.obstacle({4}).cells, 2U);
    EXPECT_EQ(map.obstacle({4}).bounds, (Box{{0, 0}, {0, 1}}));
    EXPECT_EQ(map.obstacle({4}).source_id, 7);
    EXPECT_EQ(map.obstacle({4}).weight, 2);
    EXPECT_EQ(map.obstacle({4}).breach_time, 3);
    EXPECT_FALSE(map.obstacle({5}).destructible);
}

TEST(MapEdit, CellsChangeHands) {
    const Map map = level().with({MapEdit::extend(wall_c, {{5, 2}, {4, 2}}), MapEdit::free({{3, 2}, {0, 0}})});
    EXPECT_EQ(map.obstacle(wall_b).bounds, (Box{{5, 0}, {5, 1}}));
    EXPECT_EQ(map.obstacle(wall_b).cells, 2U);
    EXPECT_EQ(map.obstacle(wall_c).bounds, (Box{{4, 2}, {7, 2}}));
    EXPECT_EQ(map.obstacle(wall_c).cells, 4U);
    EXPECT_EQ(map.obstacle(wall_a).bounds, (Box{{2, 0}, {2, 2}}));
    EXPECT_TRUE(map.obstacles_touch());
    EXPECT_TRUE(level().with({MapEdit::extend(wall_a, {{5, 0}, {5, 1}, {5, 2}})}).obstacle(wall_b).gone());
}

TEST(MapEdit, RefusesWhatIsNotThere) {
    const auto refused = [](const MapEdit& edit) {
        return input_error([&] { static_cast<void>(level().with({MapEdit::remove(wall_b), edit})); });
    };
    EXPECT_EQ(refused(MapEdit::remove({4})), "there is no obstacle 4 to remove");
    EXPECT_EQ(refused(MapEdit::remove({0})), "there is no obstacle 0 to remove");
    EXPECT_EQ(refused(MapEdit::remove(wall_b)), "there is no obstacle 2 to remove");
    EXPECT_EQ(refused(MapEdit::extend(wall_b, {{0, 0}})), "there is no obstacle 2 to extend");
    EXPECT_NE(refused(MapEdit::free({{8, 0}})).find("8,0 is off the map"), std::string::npos);
    EXPECT_NE(refused(MapEdit::add({{0, -1}})).find("0,-1 is off the map"), std::string::npos);
    EXPECT_EQ(refused(MapEdit::add({})), "an obstacle that is added needs at least one cell");
    EXPECT_NE(refused(MapEdit::add({{0, 0}}, {.weight = 0})).find("the weight of an obstacle that is added"),
              std::string::npos);
    EXPECT_EQ(refused(MapEdit::free({})), "");
}

TEST(MapEdit, WeighsWhatStands) {
    const Map map = level().with({MapEdit::remove(wall_b)});
    EXPECT_EQ(map.with_weights(std::vector<double>{0, 3, 0, 4}).obstacle(wall_c).weight, 4);
}

MapEdit any_edit(const Map& map) {
    const auto any_cells = [&] {
        std::vector<Cell> cells;
        for (int i = *number(1, 6); i > 0; --i) {
            cells.push_back({*number(0, map.width() - 1), *number(0, map.height() - 1)});
        }
        return cells;
    };
    std::vector<ObstacleId> there;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (!obstacle.gone()) there.push_back(obstacle.id);
    }
    const int kind = *number(there.empty() ? 2 : 0, 3);
    if (kind == 3) return MapEdit::free(any_cells());
    if (kind == 2) return MapEdit::add(any_cells(), {.weight = double(*number(1, 9))});
    const ObstacleId id = there[std::size_t(*number(0, int(there.size()) - 1))];
    return kind == 1 ? MapEdit::extend(id, any_cells()) : MapEdit::remove(id);
}

RC_GTEST_PROP(MapEdit, MakesTheMapThatItsLabelsMake, ()) {
    const PlainMap blocks = *random_map(20, 20);
    const Map first(blocks.grid());
    Map map = first;
    for (int edits = *number(1, 6); edits > 0; --edits) {
        std::vector<MapEdit> batch;
        Map expected = map;
        for (int i = *number(1, 3); i > 0; --i) {
            batch.push_back(any_edit(expected));
            expected = expected.with({batch.back()});
        }
        map = map.with(batch);
        RC_ASSERT(std::ranges::equal(map.labels(), expected.labels()));
    }
    const Map fresh = Map::from_labels(map.width(), map.height(), {map.labels().begin(), map.labels().end()});
    RC_ASSERT(map.grid() == fresh.grid());
    RC_ASSERT(map.transposed() == fresh.transposed());
    RC_ASSERT(map.obstacles_touch() == fresh.obstacles_touch());
    std::size_t standing = 0;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.gone()) {
            RC_ASSERT(std::ranges::find(map.labels(), obstacle.id.value) == map.labels().end());
            continue;
        }
        ++standing;
        const auto at = std::size_t(std::ranges::find(map.labels(), obstacle.id.value) - map.labels().begin());
        const Obstacle& same = fresh.obstacle(ObstacleId{fresh.labels()[at]});
        RC_ASSERT(obstacle.cells == same.cells);
        RC_ASSERT(obstacle.bounds == same.bounds);
        RC_ASSERT(map.boundary(obstacle.id) == fresh.boundary(same.id));
    }
    RC_ASSERT(standing == fresh.obstacles().size());
    for (int y = 0; y < map.height(); ++y) {
        RC_ASSERT(std::ranges::equal(map.labels(y),
                                     map.labels().subspan(std::size_t(y * map.width()), std::size_t(map.width()))));
    }
    RC_ASSERT(std::ranges::equal(first.labels(), Map(blocks.grid()).labels()));
}

}  // namespace
}  // namespace waybreaker

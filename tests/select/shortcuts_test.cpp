// What is guessed to be worth removing.
#include "select/shortcuts.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {
namespace {

std::vector<Point> shortest(const Map& map, Cell start, Cell goal, std::span<const ObstacleId> removed = {}) {
    return CrossingSearcher().find(map, start, goal, {.removed = removed}).best.path;
}

double length(const std::vector<Point>& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += distance(path[i - 1], path[i]);
    return sum;
}

constexpr std::string_view two_walls = R"(
    ..............
    ...a....b.....
    ...a....b.....
    S..a....b....G
    ...a....b.....
    ...a....b.....
    ...a..........
    ...a..........
    ..............)";

// Each obstacle weighs 3.
std::vector<ObstacleId> chosen(std::string_view picture, const Rules& rules) {
    const Map light = map_from_ascii(picture);
    const Map map = light.with_weights(std::vector<double>(light.obstacles().size() + 1, 3));
    Mission mission = ground_and_air(mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'));
    mission.rules = rules;
    const Method method;
    const Limits limits;
    const Task task = task_of(map, mission, method, limits);
    return chosen_by_shortcuts(task, shortest(map, task.driver.start, task.driver.goal));
}

TEST(Shortcuts, TakeWhatSavesMost) {
    const std::string_view picture = R"(
        .............
        ......b......
        ...a..b......
        S..a..b.....G
        ...a..b......
        ......b......
        .............)";
    const ObstacleId b = map_from_ascii(picture).obstacle_at(mark_in_ascii(picture, 'b'));
    EXPECT_EQ(chosen(picture, {.removals = 1}), std::vector<ObstacleId>{b});
}

TEST(Shortcuts, TakeAllThatStandsInTheWay) {
    EXPECT_EQ(chosen(two_walls, {.removals = 2}).size(), 2U);
    EXPECT_EQ(chosen(two_walls, {.removals = 9}).size(), 2U);
}

TEST(Shortcuts, LeaveWhatIsProtectedOrTooHeavy) {
    EXPECT_TRUE(chosen(two_walls, {.removals = 2, .protect = {{1}, {2}}}).empty());
    EXPECT_EQ(chosen(two_walls, {.removals = 2, .budget = 5}).size(), 1U);
    EXPECT_EQ(chosen(two_walls, {.removals = 2, .budget = 6}).size(), 2U);
}

RC_GTEST_PROP(Shortcuts, OpenAShorterPath, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid());
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    mission.rules.removals = *number(0, 3);
    const Method method;
    const Limits limits;
    const Task task = task_of(map, mission, method, limits);
    const std::vector<Point> closed = shortest(map, task.driver.start, task.driver.goal);
    const std::vector<ObstacleId> removed = chosen_by_shortcuts(task, closed);
    RC_ASSERT(int(removed.size()) <= mission.rules.removals);
    if (removed.empty()) return;
    RC_ASSERT(std::adjacent_find(removed.begin(), removed.end()) == removed.end());
    RC_ASSERT(length(shortest(map, task.driver.start, task.driver.goal, removed)) < length(closed));
}

}  // namespace
}  // namespace waybreaker

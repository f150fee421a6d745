// Maps of the C interface: what they are made from, and what can be read of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "capi/owned.hpp"
#include "io/sha256.hpp"

namespace waybreaker::capi {
namespace {

constexpr std::string_view yard = "type octile\nheight 3\nwidth 4\nmap\n.@..\n..@.\n@...\n";
constexpr std::array<std::uint8_t, 12> yard_cells{0, 1, 0, 0, 0, 0, 255, 0, 7, 0, 0, 0};

std::vector<std::uint32_t> labels_of(const OwnedMap& map) {
    const std::uint32_t* const labels = waybreaker_map_labels(map.get());
    return {labels, labels + waybreaker_map_width(map.get()) * waybreaker_map_height(map.get())};
}

struct Sides {
    std::int32_t width = 4;
    std::int32_t height = 3;
};

OwnedMap from_grid(const std::uint8_t* blocked, Sides sides = {}, int connectivity = 4, double cell_size = 0,
                   Answer* why = nullptr) {
    return map_by(
        [&](auto** map, auto** error) {
            return waybreaker_map_from_grid("yard.map", blocked, sides.width, sides.height, connectivity, cell_size,
                                            map, error);
        },
        why);
}

OwnedMap from_labels(const std::vector<std::uint32_t>& labels, Sides sides,
                     const std::vector<waybreaker_attributes>& attributes = {}, Answer* why = nullptr) {
    return map_by(
        [&](auto** map, auto** error) {
            return waybreaker_map_from_labels(nullptr, labels.data(), sides.width, sides.height, attributes.data(),
                                              attributes.size(), 0, map, error);
        },
        why);
}

TEST(CMap, SaysWhatItIs) {
    const OwnedMap map = from_movingai(yard);
    ASSERT_TRUE(map);
    EXPECT_EQ(waybreaker_map_width(map.get()), 4);
    EXPECT_EQ(waybreaker_map_height(map.get()), 3);
    EXPECT_EQ(waybreaker_map_obstacle_count(map.get()), 3U);
    EXPECT_EQ(labels_of(map), (std::vector<std::uint32_t>{0, 1, 0, 0, 0, 0, 2, 0, 3, 0, 0, 0}));
    EXPECT_EQ(waybreaker_map_digest(map.get()), io::sha256_digest(yard)) << "as of the file";
    waybreaker_obstacle second{};
    ASSERT_TRUE(waybreaker_map_obstacle(map.get(), 2, &second));
    EXPECT_EQ(second.id, 2U);
    EXPECT_EQ(second.cells, 1U);
    EXPECT_EQ(second.min_x, 2);
    EXPECT_EQ(second.min_y, 1);
    EXPECT_EQ(second.max_x, 2);
    EXPECT_EQ(second.max_y, 1);
    EXPECT_EQ(second.attributes.source_id, 0);
    EXPECT_EQ(second.attributes.weight, 1);
    EXPECT_EQ(second.attributes.breach_time, 0);
    EXPECT_TRUE(second.attributes.destructible);
    for (const std::uint32_t id : {0U, 4U, UINT32_MAX}) EXPECT_FALSE(waybreaker_map_obstacle(map.get(), id, &second));
    EXPECT_EQ(second.id, 2U) << "nothing is written";
}

TEST(CMap, JoinsCellsByConnectivity) {
    EXPECT_EQ(waybreaker_map_obstacle_count(from_movingai(yard, "yard.map", 8).get()), 2U);
    EXPECT_EQ(waybreaker_map_obstacle_count(from_grid(yard_cells.data(), {}, 8).get()), 2U);
}

TEST(CMap, OfAGridIsThatOfTheMapFile) {
    const OwnedMap file = from_movingai(yard);
    const OwnedMap grid = from_grid(yard_cells.data());
    EXPECT_EQ(labels_of(grid), labels_of(file));
    EXPECT_STREQ(waybreaker_map_digest(grid.get()), waybreaker_map_digest(file.get()));
}

TEST(CMap, NumbersLabelsAnewAndKeepsTheirAttributes) {
    std::vector<waybreaker_attributes> attributes(8, {0, 1, 0, true});
    attributes[7] = {-4711, 2.5, 30, false};
    const OwnedMap map = from_labels({7, 0, 9000, 0, 7, 7}, {3, 2}, attributes);
    ASSERT_TRUE(map);
    EXPECT_EQ(labels_of(map), (std::vector<std::uint32_t>{1, 0, 2, 0, 1, 1}));
    waybreaker_obstacle first{};
    ASSERT_TRUE(waybreaker_map_obstacle(map.get(), 1, &first));
    EXPECT_EQ(first.cells, 3U);
    EXPECT_EQ(first.max_x, 2);
    EXPECT_EQ(first.attributes.source_id, -4711);
    EXPECT_EQ(first.attributes.weight, 2.5);
    EXPECT_EQ(first.attributes.breach_time, 30);
    EXPECT_FALSE(first.attributes.destructible);
    waybreaker_obstacle second{};
    ASSERT_TRUE(waybreaker_map_obstacle(map.get(), 2, &second));
    EXPECT_TRUE(second.attributes.destructible) << "a label without attributes has the usual ones";
}

// docs/c.md says of what bytes.
TEST(CMap, OfLabelsHasTheDigestOfAllThatDecidesAPlan) {
    using namespace std::string_literals;
    const auto digest = [](const OwnedMap& map) { return std::string(waybreaker_map_digest(map.get())); };
    const OwnedMap map = from_labels({5, 5, 0, 6}, {2, 2});
    const std::string runs =
        "\x01\0\0\0\x02\0\0\0"s
        "\0\0\0\0\x01\0\0\0"s
        "\x02\0\0\0\x01\0\0\0"s;
    const std::string obstacle = "\0\0\0\0\0\0\0\0"s + "\0\0\0\0\0\0\xF0\x3F"s + "\0\0\0\0\0\0\0\0"s + "\x01";
    EXPECT_EQ(digest(map),
              io::sha256_digest("waybreaker-labels/1\n\x02\0\0\0\x02\0\0\0"s + runs + obstacle + obstacle));
    EXPECT_EQ(digest(from_labels({1, 1, 0, 2}, {2, 2})), digest(map)) << "obstacles count, not how they are numbered";
    EXPECT_NE(digest(from_labels({1, 1, 0, 1}, {2, 2})), digest(map));
    EXPECT_NE(digest(from_labels({5, 5, 0, 6}, {4, 1})), digest(map));
    std::vector<waybreaker_attributes> attributes(6, {0, 1, 0, true});
    EXPECT_EQ(digest(from_labels({5, 5, 0, 6}, {2, 2}, attributes)), digest(map));
    for (const waybreaker_attributes& other :
         {waybreaker_attributes{1, 1, 0, true}, waybreaker_attributes{0, 2, 0, true},
          waybreaker_attributes{0, 1, 1, true}, waybreaker_attributes{0, 1, 0, false}}) {
        attributes[5] = other;
        EXPECT_NE(digest(from_labels({5, 5, 0, 6}, {2, 2}, attributes)), digest(map));
    }
}

OwnedMap with(const OwnedMap& map, const std::vector<waybreaker_edit>& edits, Answer* why = nullptr) {
    return map_by(
        [&](auto** edited, auto** error) {
            return waybreaker_map_with(map.get(), edits.data(), edits.size(), edited, error);
        },
        why);
}

waybreaker_edit remove_edit(std::uint32_t obstacle) {
    return {WAYBREAKER_EDIT_REMOVE, obstacle, nullptr, 0, {}};
}

waybreaker_edit edit_of(std::int32_t kind, std::uint32_t obstacle, const std::vector<waybreaker_cell>& cells) {
    return {kind, obstacle, cells.data(), cells.size(), {0, 1, 0, true}};
}

TEST(CMap, ChangesByEditsAndIdsStay) {
    const OwnedMap map = from_movingai(yard);
    const std::vector<waybreaker_cell> built{{0, 0}, {1, 0}};
    const std::vector<waybreaker_cell> longer{{3, 1}};
    const std::vector<waybreaker_cell> cleared{{0, 2}};
    waybreaker_edit wall = edit_of(WAYBREAKER_EDIT_ADD, 0, built);
    wall.attributes = {4711, 2.5, 3, true};
    const OwnedMap edited = with(map, {remove_edit(1), wall, edit_of(WAYBREAKER_EDIT_EXTEND, 2, longer),
                                       edit_of(WAYBREAKER_EDIT_FREE, 0, cleared)});
    ASSERT_TRUE(edited);
    EXPECT_EQ(labels_of(edited), (std::vector<std::uint32_t>{4, 4, 0, 0, 0, 0, 2, 2, 0, 0, 0, 0}));
    EXPECT_EQ(labels_of(map), labels_of(from_movingai(yard))) << "the map stays as it is";
    EXPECT_EQ(waybreaker_map_obstacle_count(edited.get()), 4U);
    waybreaker_obstacle obstacle{};
    ASSERT_TRUE(waybreaker_map_obstacle(edited.get(), 4, &obstacle));
    EXPECT_EQ(obstacle.attributes.source_id, 4711);
    EXPECT_EQ(obstacle.attributes.weight, 2.5);
    ASSERT_TRUE(waybreaker_map_obstacle(edited.get(), 1, &obstacle));
    EXPECT_EQ(obstacle.cells, 0U);
    EXPECT_GT(obstacle.min_x, obstacle.max_x);
}

// docs/c.md says of what bytes.
TEST(CMap, HasTheDigestOfTheMapBeforeAndOfItsEdits) {
    using namespace std::string_literals;
    const auto digest = [](const OwnedMap& map) { return std::string(waybreaker_map_digest(map.get())); };
    const OwnedMap map = from_movingai(yard);
    const std::vector<waybreaker_cell> cells{{1, 2}};
    const waybreaker_edit wall = edit_of(WAYBREAKER_EDIT_ADD, 99, cells);
    const OwnedMap edited = with(map, {wall});
    const std::string added = "\x01\0\0\0"s + "\0\0\0\0"s + "\x01\0\0\0"s + "\x01\0\0\0\x02\0\0\0"s;
    const std::string attributes = "\0\0\0\0\0\0\0\0"s + "\0\0\0\0\0\0\xF0\x3F"s + "\0\0\0\0\0\0\0\0"s + "\x01";
    EXPECT_EQ(digest(edited), io::sha256_digest("waybreaker-edit/1\n" + digest(map) + "\n" + added + attributes));
    EXPECT_EQ(digest(with(map, {})), digest(map));
    EXPECT_EQ(digest(with(edited, {remove_edit(1)})), digest(with(map, {wall, remove_edit(1)})));
    EXPECT_NE(digest(with(map, {remove_edit(1)})), digest(with(map, {remove_edit(2)})));
}

TEST(CMap, RefusesEditsThatDoNotFit) {
    const OwnedMap map = from_movingai(yard);
    const auto why = [&](const waybreaker_edit& edit) {
        Answer answer;
        EXPECT_FALSE(with(map, {edit}, &answer));
        EXPECT_EQ(answer.status, WAYBREAKER_INPUT_ERROR);
        return answer.error;
    };
    const std::vector<waybreaker_cell> outside{{4, 0}};
    EXPECT_EQ(why(remove_edit(0)), "there is no obstacle 0 to remove");
    EXPECT_EQ(why(remove_edit(4)), "there is no obstacle 4 to remove");
    EXPECT_EQ(why(edit_of(WAYBREAKER_EDIT_EXTEND, 9, outside)), "there is no obstacle 9 to extend");
    EXPECT_NE(why(edit_of(WAYBREAKER_EDIT_FREE, 0, outside)).find("4,0"), std::string::npos);
    EXPECT_EQ(why(edit_of(WAYBREAKER_EDIT_ADD, 0, {})), "an obstacle that is added needs at least one cell");
    EXPECT_EQ(why(edit_of(4, 0, {})), "there is no kind of edit 4");
    EXPECT_EQ(why({WAYBREAKER_EDIT_FREE, 0, nullptr, 1, {}}), "the array of an edit's cells is NULL");
    EXPECT_NE(why({WAYBREAKER_EDIT_ADD, 0, outside.data(), 1, {0, -1, 0, true}}).find("weight"), std::string::npos);
    waybreaker_map* edited = nullptr;
    EXPECT_EQ(waybreaker_map_with(nullptr, nullptr, 0, &edited, nullptr), WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(waybreaker_map_with(map.get(), nullptr, 1, &edited, nullptr), WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(edited, nullptr);
}

// What is refused, and how.
TEST(CMap, RefusesBadInput) {
    const auto why_grid = [](Sides sides, int connectivity = 4, double cell_size = 0) {
        Answer why;
        EXPECT_FALSE(from_grid(yard_cells.data(), sides, connectivity, cell_size, &why));
        EXPECT_EQ(why.status, WAYBREAKER_INPUT_ERROR);
        return why.error;
    };
    EXPECT_EQ(why_grid({0, 0}),
              "a map of 0 x 0 cells is out of range: sides go from 1 to 32768, with at most 268435456 cells in all");
    for (const Sides sides : {Sides{-1, 3}, Sides{4, -3}, Sides{32769, 1}, Sides{32768, 32768},
                              Sides{INT32_MAX, INT32_MAX}, Sides{INT32_MIN, INT32_MIN}}) {
        EXPECT_NE(why_grid(sides).find("is out of range"), std::string::npos);
        Answer why;
        EXPECT_FALSE(from_labels({1}, sides, {}, &why));
        EXPECT_EQ(why.status, WAYBREAKER_INPUT_ERROR);
        EXPECT_NE(why.error.find("is out of range"), std::string::npos);
    }
    EXPECT_EQ(why_grid({4, 3}, 6), "the connectivity must be 4 or 8, not 6");
    for (const double cell_size : {-1.0, 1e-9, 1e9, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_NE(why_grid({4, 3}, 4, cell_size).find("the side of a cell, in metres, must be from"),
                  std::string::npos);
    }
    Answer why;
    EXPECT_FALSE(from_labels({0, 1}, {2, 1}, {{}, {0, -1, 0, true}}, &why));
    EXPECT_NE(why.error.find("weight"), std::string::npos) << why.error;
    EXPECT_FALSE(from_movingai("type octile\nheight 3\nwidth 4\nmap\n....\n", "m.map", 4, 0, &why));
    EXPECT_EQ(why.status, WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(why.error.substr(0, 6), "m.map:") << why.error;
}

TEST(CMap, TakesNullForAnArrayAsAnError) {
    Answer why;
    EXPECT_FALSE(from_grid(nullptr, {}, 4, 0, &why));
    EXPECT_EQ(why.error, "the array of blocked cells is NULL");
    const auto call = [&](const std::uint32_t* labels, std::size_t attribute_count, waybreaker_map** map) {
        waybreaker_text* error = nullptr;
        const waybreaker_status status =
            waybreaker_map_from_labels(nullptr, labels, 1, 1, nullptr, attribute_count, 0, map, &error);
        return Answer{status, "", taken(error)};
    };
    waybreaker_map* map = nullptr;
    const std::uint32_t label = 1;
    EXPECT_EQ(call(nullptr, 0, &map).error, "the array of labels is NULL");
    EXPECT_EQ(call(&label, 1, &map).error, "the array of attributes is NULL");
    EXPECT_EQ(call(&label, 0, nullptr).error, "there is no place for the result: its address is NULL");
    EXPECT_EQ(waybreaker_map_from_movingai("m", nullptr, 5, 4, 0, &map, nullptr), WAYBREAKER_INPUT_ERROR);
    EXPECT_EQ(map, nullptr);
}

TEST(CMap, OfNullIsNothing) {
    waybreaker_map_free(nullptr);
    EXPECT_EQ(waybreaker_map_width(nullptr), 0);
    EXPECT_EQ(waybreaker_map_height(nullptr), 0);
    EXPECT_EQ(waybreaker_map_obstacle_count(nullptr), 0U);
    EXPECT_EQ(waybreaker_map_labels(nullptr), nullptr);
    EXPECT_EQ(waybreaker_map_digest(nullptr), nullptr);
    waybreaker_obstacle obstacle{};
    EXPECT_FALSE(waybreaker_map_obstacle(nullptr, 1, &obstacle));
    EXPECT_FALSE(waybreaker_map_obstacle(from_movingai(yard).get(), 1, nullptr));
}

}  // namespace
}  // namespace waybreaker::capi

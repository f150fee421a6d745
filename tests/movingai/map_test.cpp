// MovingAI maps: what is written is read back, what is not a map is refused by name and line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "input_error.hpp"
#include "project_folder.hpp"
#include "shared_data.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

using namespace std::string_literals;

Grid grid_in(std::string_view text) {
    return read_movingai_map(text, "a.map");
}

std::string text_of(const Grid& grid, const std::string& line_end) {
    std::string text = "type octile" + line_end + "height " + std::to_string(grid.height()) + line_end + "width " +
                       std::to_string(grid.width()) + line_end + "map" + line_end;
    for (Cell c; c.y < grid.height(); ++c.y) {
        for (c.x = 0; c.x < grid.width(); ++c.x) text += grid.blocked(c) ? '@' : '.';
        text += line_end;
    }
    return text;
}

RC_GTEST_PROP(MovingaiMap, IsReadAsItWasWritten, ()) {
    Grid grid(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 20));
    const auto blocked = *rc::gen::container<std::vector<bool>>(grid.cell_count(), rc::gen::arbitrary<bool>());
    for (std::size_t i = 0; i < blocked.size(); ++i) {
        const auto width = std::size_t(grid.width());
        grid.set_blocked({int(i % width), int(i / width)}, blocked[i]);
    }
    const std::string text = text_of(grid, *rc::gen::element("\n"s, "\r\n"s));
    RC_ASSERT(grid_in(text) == grid);
    std::istringstream stream(text);
    RC_ASSERT(read_movingai_map(stream, "a.map") == grid);
}

// Wherever a map is cut off before its last cell, it is no map.
RC_GTEST_PROP(MovingaiMap, IsRefusedWhenCutOff, ()) {
    const std::string text = text_of(Grid(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9)), "\n");
    const auto size = *rc::gen::inRange<std::size_t>(0, text.size() - 1);
    RC_ASSERT(!input_error([&] { grid_in(text.substr(0, size)); }).empty());
}

// Any bytes at all are read or refused.
RC_GTEST_PROP(MovingaiMap, IsReadOrRefused, (const std::string& junk)) {
    input_error([&] { grid_in(junk); });
    input_error([&] { grid_in("type octile\nheight 2\nwidth 2\nmap\n" + junk); });
}

TEST(MovingaiMap, ReadsTerrain) {
    const Grid grid = grid_in("type octile\nheight 1\nwidth 11\nmap\n.GSE@OTW# \xff\n");
    for (int x = 0; x < 11; ++x) EXPECT_EQ(grid.blocked({x, 0}), x > 3) << "cell " << x;
}

TEST(MovingaiMap, MayStateItsSizeInEitherOrder) {
    const Grid grid = grid_in("type octile\nwidth 3\nheight 2\nmap\n..@\n...\n");
    EXPECT_EQ(grid.width(), 3);
    EXPECT_EQ(grid.height(), 2);
    EXPECT_TRUE(grid.blocked({2, 0}));
}

TEST(MovingaiMap, MayLackTheLastLineEndOrHaveEmptyLinesAfterIt) {
    const std::string map = "type octile\nheight 1\nwidth 2\nmap\n.@";
    EXPECT_EQ(grid_in(map), grid_in(map + "\n"));
    EXPECT_EQ(grid_in(map), grid_in(map + "\r\n\r\n  \n"));
}

// Within its width a blank is a blocked cell, beyond it nothing.
TEST(MovingaiMap, MayHaveBlanksAtLineEnds) {
    const Grid grid = grid_in("type octile \nheight 3\t\nwidth 3 \nmap \n..@ \n.. \t \r\n.. \n");
    EXPECT_EQ(grid, grid_in("type octile\nheight 3\nwidth 3\nmap\n..@\n..@\n..@\n"));
    EXPECT_NE(input_error([] { grid_in("type octile\nheight 1\nwidth 3\nmap\n... .\n"); }).find("has 5 cells"),
              std::string::npos);
}

TEST(MovingaiMap, MayBeOneCellWideOrAllBlocked) {
    EXPECT_EQ(grid_in("type octile\nheight 3\nwidth 1\nmap\n.\n@\n.\n").height(), 3);
    EXPECT_EQ(grid_in("type octile\nheight 1\nwidth 3\nmap\n.@.\n").width(), 3);
    EXPECT_TRUE(grid_in("type octile\nheight 1\nwidth 1\nmap\n@\n").blocked({0, 0}));
}

struct BadMap {
    std::string text;
    std::string message;
};

TEST(MovingaiMap, IsRefusedWithFileLineAndRemedy) {
    const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";
    const std::vector<BadMap> table{
        {"", "a.map: not a MovingAI map: a MovingAI map begins with"},
        {"\x89PNG\r\n\x1a\n\0\0"s, "a.map:1: not a MovingAI map"},
        {"type tile\n", "a.map:1: not a MovingAI map"},
        {"type octile\n", "a.map:1: the file ends within its header"},
        {"type octile\nheight 2\nmap\n", "a.map:3: no width is given"},
        {"type octile\nwidth 2\nmap\n", "a.map:3: no height is given"},
        {"type octile\nheight two\n", "a.map:2: the height is 'two', but must be a number from 1 to 32768"},
        {"type octile\nheight 0\n", "a.map:2: the height is '0'"},
        {"type octile\nheight -5\n", "a.map:2: the height is '-5'"},
        {"type octile\nwidth 99999999999999999999\n", "a.map:2: the width is '99999999999999999999'"},
        {"type octile\nwidth 3x\n", "a.map:2: the width is '3x'"},
        {"type octile\nwidth 2\nwidth 2\n", "a.map:3: the width is given twice"},
        {"type octile\nheight 2\nwidth 3\n...\n...\n", "a.map:4: unexpected header line '...'"},
        {"type octile\nheight 2\n\x01\x02\n", "a.map:3: unexpected header line '\?\?'"},
        {"type octile\nheight 32768\nwidth 32768\nmap\n", "a.map:4: a map of 32768 x 32768 cells is too large"},
        {"type octile\nheight 16384\nwidth 16384\nmap\n", "a.map:4: the map ends after 0 of 16384 rows"},
        {header + "...\n", "a.map:5: the map ends after 1 of 2 rows: is the file cut off"},
        {header + "...\n..\n", "a.map:6: this row has 2 cells, but the width is 3"},
        {header + "....\n...\n", "a.map:5: this row has 4 cells, but the width is 3"},
        {header + "\n...\n...\n", "a.map:5: this row has 0 cells"},
        {header + "...\n...\n\n...\n", "a.map:8: more lines follow the 2 rows"},
    };
    for (const BadMap& bad : table) {
        EXPECT_EQ(input_error([&] { grid_in(bad.text); }).substr(0, bad.message.size()), bad.message) << bad.text;
    }
}

TEST(MovingaiMap, IsRefusedWhenTheStreamCannotBeRead) {
    std::ifstream absent("there/is/no/such.map");
    EXPECT_EQ(input_error([&] { read_movingai_map(absent, "such.map"); }),
              "such.map: cannot be read: check that it is a file and that you may read it");
    std::ifstream folder(project_folder());
    EXPECT_NE(input_error([&] { read_movingai_map(folder, "folder"); }), "");
}

TEST(MovingaiMap, ReadsEveryBenchmarkMap) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    for (const char* folder : {"data/cities", "data/benchmarks"}) {
        for (const auto& path : files_of(*shared / folder, ".map")) {
            std::ifstream in(path, std::ios::binary);
            const Grid grid = read_movingai_map(in, path.string());
            std::ifstream again(path, std::ios::binary);
            std::string type, octile, height, width;
            int rows = 0, columns = 0;
            again >> type >> octile >> height >> rows >> width >> columns;
            EXPECT_EQ(grid.height(), rows) << path;
            EXPECT_EQ(grid.width(), columns) << path;
            std::string map, row;
            again >> map;
            for (int y = 0; y < rows; ++y) {
                again >> row;
                for (int x = 0; x < columns; ++x) {
                    const char cell = row[std::size_t(x)];
                    ASSERT_EQ(grid.blocked({x, y}), cell != '.' && cell != 'G' && cell != 'S') << path << x << "," << y;
                }
            }
        }
    }
}

}  // namespace
}  // namespace waybreaker

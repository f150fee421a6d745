// The authors' XML task files.
#include "authors/authors_xml.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>

#include "input_error.hpp"

namespace waybreaker::authors {
namespace {

using namespace std::string_literals;

AuthorsXml read(std::string_view text) {
    return parse_authors_xml(text, "a.xml");
}

// A task whose lines are: 1 root, 2 map, 3 and 4 size, 5 grid, 6 and 7 rows, 8 `in_map`, 9 `algorithm`.
std::string task(const std::string& in_map = "", const std::string& algorithm = "") {
    return "<root>\n<map>\n<width>3</width>\n<height>2</height>\n<grid>\n<row>0 0 1</row>\n<row>0 1 0 </row></grid>\n" +
           in_map + "</map>\n" + algorithm + "</root>\n";
}

SearchOptions search(const std::string& algorithm) {
    return read(task("", "<algorithm>" + algorithm + "</algorithm>")).task.search;
}

TEST(AuthorsXml, HoldsGridStartGoalAndTitle) {
    const AuthorsXml xml =
        read(task("<title> Moscow &amp; more </title><cellsize>5</cellsize>"
                  "<startx number=\"7\">0</startx><starty>1</starty><finishx>2</finishx><finishy>1</finishy>"));
    EXPECT_EQ(xml.grid.width(), 3);
    EXPECT_EQ(xml.grid.height(), 2);
    for (const Cell c : {Cell{0, 0}, {1, 0}, {0, 1}, {2, 1}}) EXPECT_FALSE(xml.grid.blocked(c));
    for (const Cell c : {Cell{2, 0}, {1, 1}}) EXPECT_TRUE(xml.grid.blocked(c));
    EXPECT_EQ(xml.title, "Moscow & more");
    EXPECT_EQ(xml.cell_size, 5);
    EXPECT_EQ(xml.task.start, (Cell{0, 1}));
    EXPECT_EQ(xml.task.goal, (Cell{2, 1}));
}

TEST(AuthorsXml, NeedsNothingButItsGrid) {
    const AuthorsXml xml = read(task());
    EXPECT_EQ(xml.cell_size, 1);
    const io::MapTask& plain = xml.task;
    EXPECT_FALSE(plain.start || plain.goal);
    EXPECT_EQ(plain.search.planner, Algorithm::theta);
    EXPECT_EQ(plain.search.heuristic, std::nullopt);
    EXPECT_EQ(plain.search.weight, 1);
    EXPECT_EQ(plain.search.tie_break, TieBreak::g_max);
    EXPECT_EQ(plain.search.body.corners, Corners::none);
    EXPECT_TRUE(plain.search.diagonal);
}

TEST(AuthorsXml, SaysHowToSearch) {
    EXPECT_EQ(search("<searchtype>bfs</searchtype>").planner, Algorithm::bfs);
    EXPECT_EQ(search("<searchtype>dijkstra</searchtype>").planner, Algorithm::dijkstra);
    EXPECT_EQ(search("<searchtype>AStar</searchtype>").planner, Algorithm::astar);
    EXPECT_EQ(search("<searchType> jp_search </searchType>").planner, Algorithm::jps);
    EXPECT_EQ(search("<searchtype>theta</searchtype>").planner, Algorithm::theta);
    EXPECT_EQ(search("<searchtype>lian</searchtype>").planner, Algorithm::theta);
    EXPECT_EQ(search("<metrictype>diagonal</metrictype>").heuristic, Heuristic::octile);
    EXPECT_EQ(search("<metrictype>manhattan</metrictype>").heuristic, Heuristic::manhattan);
    EXPECT_EQ(search("<metrictype>euclid</metrictype>").heuristic, Heuristic::euclidean);
    EXPECT_EQ(search("<metrictype>chebyshev</metrictype>").heuristic, Heuristic::chebyshev);
    EXPECT_EQ(search("<metrictype>what</metrictype>").heuristic, std::nullopt);
    EXPECT_EQ(search("<hweight>1.5</hweight>").weight, 1.5);
    EXPECT_EQ(search("<breakingties>g-min</breakingties>").tie_break, TieBreak::g_min);
    EXPECT_EQ(search("<breakingties>none</breakingties>").tie_break, TieBreak::g_max);
    EXPECT_FALSE(search("<allowdiagonal>0</allowdiagonal>").diagonal);
}

// Theta* needs none, and the authors' program does none then.
TEST(AuthorsXml, SaysWhetherPathsAreToBeSmoothed) {
    const auto smoothing = [](const std::string& algorithm) {
        return read(task("", "<algorithm>" + algorithm + "</algorithm>")).task.smoothing;
    };
    EXPECT_TRUE(smoothing("<searchtype>astar</searchtype><postsmoothing>true</postsmoothing>"));
    EXPECT_TRUE(smoothing("<searchtype>bfs</searchtype><postsmoothing>1</postsmoothing>"));
    EXPECT_FALSE(smoothing("<searchtype>astar</searchtype><postsmoothing>false</postsmoothing>"));
    EXPECT_FALSE(smoothing("<searchtype>astar</searchtype>"));
    EXPECT_FALSE(smoothing("<searchtype>theta</searchtype><postsmoothing>true</postsmoothing>"));
}

TEST(AuthorsXml, CountsTheWiderPermissionOnlyWithTheNarrower) {
    const auto corners = [](const std::string& diagonal, const std::string& cut, const std::string& squeeze) {
        return search("<allowdiagonal>" + diagonal + "</allowdiagonal><cutcorners>" + cut +
                      "</cutcorners><allowsqueeze>" + squeeze + "</allowsqueeze>")
            .body.corners;
    };
    EXPECT_EQ(corners("1", "0", "0"), Corners::none);
    EXPECT_EQ(corners("1", "0", "1"), Corners::none);
    EXPECT_EQ(corners("1", "1", "0"), Corners::cut);
    EXPECT_EQ(corners("true", "true", "true"), Corners::squeeze);
    EXPECT_EQ(corners("0", "1", "1"), Corners::none);
}

RC_GTEST_PROP(AuthorsXml, IsReadAsItWasWritten, ()) {
    Grid grid(*rc::gen::inRange(1, 80), *rc::gen::inRange(1, 20));
    const std::string line_end = *rc::gen::element("\n"s, "\r\n"s, ""s);
    const std::string separator = *rc::gen::element(" "s, ""s, "\t"s);
    std::string text = "<root><map><grid>" + line_end;
    for (Cell c; c.y < grid.height(); ++c.y) {
        text += "<row>";
        for (c.x = 0; c.x < grid.width(); ++c.x) {
            const bool blocked = *rc::gen::arbitrary<bool>();
            grid.set_blocked(c, blocked);
            text += separator + (blocked ? "1" : "0");
        }
        text += "</row>" + line_end;
    }
    text += "</grid><width>" + std::to_string(grid.width()) + "</width><height>" + std::to_string(grid.height()) +
            "</height></map></root>";
    RC_ASSERT(read(text).grid == grid);
}

RC_GTEST_PROP(AuthorsXml, IsReadOrRefused, (const std::string& junk)) {
    input_error([&] { read(junk); });
    input_error([&] { read("<root><map><width>1</width><height>1</height>" + junk + "</map></root>"); });
}

TEST(AuthorsXml, IsRefusedWithFileLineAndReason) {
    const auto sized = [](const std::string& width, const std::string& height) {
        return "<root>\n<map>\n<width>" + width + "</width>\n<height>" + height + "</height>\n</map></root>";
    };
    const std::vector<std::pair<std::string, std::string>> table{
        {"", "a.xml:1: not well-formed XML: "},
        {"<root>\n<map>\n", "a.xml:2: not well-formed XML: "},
        {"<root>\n<map></root>\n", "a.xml:2: not well-formed XML: "},
        {"<<<\0\1\2>"s, "a.xml:1: not well-formed XML: "},
        {"\n<html></html>", "a.xml:2: <map> is missing in 'html'"},
        {"<root>\n<map></map>\n<map></map></root>", "a.xml:3: <map> is given twice"},
        {"<root>\n<map>\n</map></root>", "a.xml:2: <width> is missing in 'map'"},
        {sized("3", ""), "a.xml:4: height is '', but must be a number from 1 to 32768"},
        {sized("0", "2"), "a.xml:3: width is '0'"},
        {sized("99999999999999999999", "2"), "a.xml:3: width is '99999999999999999999'"},
        {sized("3\n4", "2"), "a.xml:3: width is '3?4'"},
        {sized("32768", "32768"), "a.xml:2: a map of 32768 x 32768 cells is too large"},
        {sized("16384", "16384"), "a.xml:2: <grid> is missing"},
        {task("<grid></grid>"), "a.xml:8: <grid> is given twice"},
        {task("<width>3</width>"), "a.xml:8: <width> is given twice"},
        {task("<startx>1</startx>"), "a.xml:2: <starty> is missing"},
        {task("<startx>3</startx><starty>0</starty>"), "a.xml:8: startx is '3', but must be a number from 0 to 2"},
        {task("<finishx>0</finishx><finishy>-1</finishy>"), "a.xml:8: finishy is '-1'"},
        {task("<cellsize>0</cellsize>"), "a.xml:8: cellsize is '0', but must be a number over 0"},
        {task("<cellsize>nan</cellsize>"), "a.xml:8: cellsize is 'nan'"},
        {task("", "<algorithm>\n<hweight>0.5</hweight></algorithm>"),
         "a.xml:10: hweight is '0.5', but must be at least 1"},
        {task("", "<algorithm><cutcorners>2</cutcorners></algorithm>"),
         "a.xml:9: cutcorners is '2', but must be 0 or 1"},
    };
    for (const auto& [text, message] : table) {
        EXPECT_EQ(input_error([&, bytes = std::string_view(text)] { read(bytes); }).substr(0, message.size()), message);
    }
}

TEST(AuthorsXml, IsRefusedWithoutParsingWhenItIsAllTags) {
    std::string tags;
    for (int i = 0; i < 200'000; ++i) tags += "<a/>";
    EXPECT_EQ(input_error([&] { read(tags); }), "a.xml: has over 131072 tags and attributes: is it a map?");
}

TEST(AuthorsXml, IsRefusedWithWrongRows) {
    const auto with = [](std::string from, std::string to) {
        std::string text = task();
        return text.replace(text.find(from), from.size(), to);
    };
    const auto message = [](const std::string& text) { return input_error([&] { read(text); }); };
    EXPECT_EQ(message(with("<row>0 0 1</row>", "")), "a.xml:5: <grid> has 1 rows, but <height> is 2");
    EXPECT_EQ(message(with("<height>2", "<height>16384")), "a.xml:5: <grid> has 2 rows, but <height> is 16384");
    EXPECT_EQ(message(with("0 0 1", "0 0")), "a.xml:6: this row has 2 cells, but <width> is 3");
    EXPECT_EQ(message(with("0 1 0 ", "0 1 0 1")), "a.xml:7: this row has 4 cells, but <width> is 3");
    EXPECT_EQ(message(with("0 1 0 ", "0 2 0")), "a.xml:7: a cell of this row is neither 0 (free) nor 1 (blocked)");
}

}  // namespace
}  // namespace waybreaker::authors

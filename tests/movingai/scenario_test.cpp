// MovingAI scenarios.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "input_error.hpp"
#include "shared_data.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker {
namespace {

using namespace std::string_literals;

std::vector<Scenario> scenarios_in(std::string_view text) {
    return read_movingai_scenarios(text, "a.scen");
}

TEST(MovingaiScenarios, HaveNineColumns) {
    const std::vector<Scenario> scenarios =
        scenarios_in("version 1\n16\tden312d.map\t65\t81\t61\t40\t8\t14\t66.69848480\n");
    ASSERT_EQ(scenarios.size(), 1U);
    const Scenario& scenario = scenarios[0];
    EXPECT_EQ(scenario.bucket, 16);
    EXPECT_EQ(scenario.map, "den312d.map");
    EXPECT_EQ(scenario.width, 65);
    EXPECT_EQ(scenario.height, 81);
    EXPECT_EQ(scenario.start, (Cell{61, 40}));
    EXPECT_EQ(scenario.goal, (Cell{8, 14}));
    EXPECT_DOUBLE_EQ(scenario.optimal_length, 66.6984848);
}

TEST(MovingaiScenarios, MayVaryInVersionLineSeparatorsAndLineEnds) {
    for (const std::string version :
         {"", "version 1\n", "version 1.0\r\n", "\nversion\t1\n", "\xEF\xBB\xBFversion 1\n"}) {
        for (const std::string separator : {" ", "\t", " \t "}) {
            for (const std::string end : {"\n", "\r\n", "", "\n\n"}) {
                std::string line = "3";
                for (const char* column : {"m.map", "9", "8", "7", "6", "5", "4", "2.5"}) line += separator + column;
                const std::vector<Scenario> scenarios = scenarios_in(version + line + end);
                ASSERT_EQ(scenarios.size(), 1U);
                EXPECT_EQ(scenarios[0].goal, (Cell{5, 4}));
                EXPECT_EQ(scenarios[0].optimal_length, 2.5);
            }
        }
    }
    EXPECT_TRUE(scenarios_in("version 1\n").empty());
    EXPECT_TRUE(scenarios_in("").empty());
}

TEST(MovingaiScenarios, MayHaveBlanksInTheMapsNameBetweenTabs) {
    const std::vector<Scenario> scenarios =
        scenarios_in("version 1\n0\tmy old map.map\t4\t3\t0\t1\t3\t2\t3.8\r\n0 \t a b \t4\t3\t0\t1\t3\t2\t 3.8 \n");
    ASSERT_EQ(scenarios.size(), 2U);
    EXPECT_EQ(scenarios[0].map, "my old map.map");
    EXPECT_EQ(scenarios[1].map, "a b");
    for (const Scenario& scenario : scenarios) {
        EXPECT_EQ(scenario.start, (Cell{0, 1}));
        EXPECT_EQ(scenario.optimal_length, 3.8);
    }
    // Not all columns are between tabs: a blank ends one.
    EXPECT_TRUE(input_error([] {
                    scenarios_in("0\tmy map.map\t4\t3\t0 1\t3\t2\t3.8\n");
                }).starts_with("a.scen:1: a scenario has 9 columns"));
}

RC_GTEST_PROP(MovingaiScenarios, AreReadOrRefused, (const std::string& junk)) {
    input_error([&] { scenarios_in(junk); });
    input_error([&] { scenarios_in("version 1\n0\tm\t" + junk); });
}

TEST(MovingaiScenarios, AreRefusedWithFileLineAndReason) {
    const std::vector<std::pair<std::string, std::string>> table{
        {"version 2\n", "a.scen:1: scenarios of version '2' cannot be read"},
        {"\x7f\x45\x4c\x46\0\0"s, "a.scen:1: a scenario has 9 columns"},
        {"version 1\n0 m 9 9 1 1 2 2\n", "a.scen:2: a scenario has 9 columns"},
        {"version 1\n0 m 9 9 1 1 2 2 1.4 x\n", "a.scen:2: a scenario has 9 columns"},
        {std::string(1 << 20, ' ') + std::string(100, 'x') + "\n", "a.scen:1: a scenario has 9 columns"},
        {"x m 9 9 1 1 2 2 1.4\n", "a.scen:1: the bucket is 'x'"},
        {"0 m 0 9 1 1 2 2 1.4\n", "a.scen:1: the width is '0'"},
        {"0 m 9 99999 1 1 2 2 1.4\n", "a.scen:1: the height is '99999'"},
        {"\n0 m 9 9 9 1 2 2 1.4\n", "a.scen:2: the cell '9', '1' does not lie on a map of 9 x 9 cells"},
        {"0 m 9 9 1 1 2 -2 1.4\n", "a.scen:1: the cell '2', '-2'"},
        {"0 m 9 9 1.5 1 2 2 1.4\n", "a.scen:1: the cell '1.5', '1'"},
        {"0 m 9 9 1 1 2 2 nan\n", "a.scen:1: the length is 'nan'"},
        {"0 m 9 9 1 1 2 2 -1\n", "a.scen:1: the length is '-1'"},
        {"0 m 9 9 1 1 2 2 1e999\n", "a.scen:1: the length is '1e999'"},
        {"0 m 9 9 1 1 2 2 1.4\nversion 1\n", "a.scen:2: a scenario has 9 columns"},
    };
    for (const auto& [text, message] : table) {
        EXPECT_EQ(input_error([&, bytes = std::string_view(text)] { scenarios_in(bytes); }).substr(0, message.size()),
                  message);
    }
}

TEST(MovingaiScenarios, AreReadFromEveryBenchmarkFile) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    for (const char* folder : {"data/cities", "data/benchmarks"}) {
        for (const auto& path : files_of(*shared / folder, ".scen")) {
            std::ifstream in(path, std::ios::binary);
            const std::vector<Scenario> scenarios = read_movingai_scenarios(in, path.string());
            std::ifstream again(path, std::ios::binary);
            std::size_t lines = 0;
            for (std::string line; std::getline(again, line);) lines += line.find('\t') != std::string::npos;
            EXPECT_EQ(scenarios.size(), lines) << path;
            EXPECT_GT(lines, 0U) << path;
        }
    }
}

}  // namespace
}  // namespace waybreaker

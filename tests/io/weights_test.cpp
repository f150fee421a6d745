// What a file of weights says of a map's obstacles, and what it may not say.
#include "io/weights.hpp"

#include <gtest/gtest.h>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::io {
namespace {

class Weights : public TemporaryFolder {
  protected:
    std::vector<double> read(std::string_view text) { return read_weights(put("w.txt", text), map_); }
    std::string refusal(std::string_view text) {
        return input_error([&] { read(text); });
    }

    const Map map_ = map_from_ascii("a.b .c.");
};

TEST_F(Weights, AreOneWhereTheFileSaysNothing) {
    EXPECT_EQ(read("# the mill\r\n\n 3\t2.5 # and more\n1 1e-3"), (std::vector<double>{1, 1e-3, 1, 2.5}));
    EXPECT_EQ(read(""), (std::vector<double>{1, 1, 1, 1}));
}

TEST_F(Weights, AreRefusedByFileAndLine) {
    const std::string file = path("w.txt");
    EXPECT_EQ(refusal("1 2\n4 1\n"), file + ":2: there is no obstacle 4; the map has 3");
    for (const std::string_view line : {"1", "1 2 3", "x 2", "1 x", "1 2x", "-1 2", "\xff \xff"}) {
        EXPECT_EQ(refusal(line), file + ":1: expected an obstacle and its weight, such as \"17 2.5\"") << line;
    }
    for (const std::string_view line : {"1 0", "1 -2", "1 nan", "1 inf"}) {
        EXPECT_EQ(refusal(line), file + ":1: a weight must be a number from 1e-09 to 1e+12") << line;
    }
    EXPECT_EQ(refusal("1 2\n1 2\n"), file + ":2: obstacle 1 has a weight already");
}

TEST_F(Weights, AreAreasWhereTheMapHasMetres) {
    MapFile file{.map = map_from_ascii("aab"), .source = "town.tif", .cell_size = 0.5};
    EXPECT_EQ(area_weights(file), (std::vector<double>{0, 0.5, 0.25}));
    file.cell_size = 1;
    EXPECT_EQ(input_error([&] { area_weights(file); }),
              "town.tif: a budget in square metres needs the size of a cell, which the map does not say");
    file.cell_size_given = true;
    EXPECT_EQ(area_weights(file), (std::vector<double>{0, 2, 1}));
}

}  // namespace
}  // namespace waybreaker::io

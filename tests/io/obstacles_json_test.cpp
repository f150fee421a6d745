// The obstacles and cells of a map as the service and the page's viewer get them.
#include "io/obstacles_json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "ascii_map.hpp"
#include "random_map.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::json;

TEST(ObstaclesJson, TellsWhoTheyAre) {
    MapFile file{.map = map_from_ascii(".#...\n.#..#\n....."), .names = {"", "", "Dom \"A\""}};
    const Json json = Json::parse(obstacles_json(file));
    EXPECT_EQ(json["width"], 5);
    EXPECT_EQ(json["height"], 3);
    ASSERT_EQ(json["obstacles"].size(), 2U);
    EXPECT_EQ(json["obstacles"][0]["name"], "");
    EXPECT_EQ(json["obstacles"][0]["cells"], 2);
    EXPECT_EQ(json["obstacles"][0]["bounds"], Json({1, 0, 1, 1}));
    EXPECT_EQ(json["obstacles"][1]["id"], 2);
    EXPECT_EQ(json["obstacles"][1]["name"], "Dom \"A\"");
    EXPECT_EQ(json["runs"], Json({0, 1, 1, 1, 0, 4, 1, 1, 0, 2, 2, 1, 0, 5}));
}

RC_GTEST_PROP(ObstaclesJson, RunsAreTheLabelsOfAllCells, ()) {
    const PlainMap plain = *random_map(20, 16);
    const MapFile file{.map = Map(plain.grid())};
    const Json runs = Json::parse(obstacles_json(file))["runs"];
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < runs.size(); i += 2) labels.insert(labels.end(), runs[i + 1], runs[i]);
    RC_ASSERT(std::ranges::equal(labels, file.map.labels()));
}

}  // namespace
}  // namespace waybreaker::io

// The obstacles and cells of a map as the service and the page's viewer get them.
#include "io/obstacles_json.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "ascii_map.hpp"
#include "random_map.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

TEST(ObstaclesJson, DescribesEachObstacle) {
    MapFile file{.map = map_from_ascii(".#...\n.#..#\n....."), .annotations = {.names = {"", "", "Dom \"A\""}}};
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

TEST(ObstaclesJson, SaysWhatTheSourceSays) {
    using enum site::ObstacleKind;
    MapFile file{.map = map_from_ascii("#.#.#"), .annotations = {.kinds = {unknown, building, water, barrier}}};
    file.annotations.tags = {{"amenity=school", {{1}}}, {"barrier=wall", {{3}}}, {"building=yes", {{1}}}};
    file.annotations.sections.structures = {{building, 17, "Schule"}, {barrier, 0, ""}};
    file.annotations.sections.parts = {{}, {0, 1}, {}, {}};
    const Json obstacles = Json::parse(obstacles_json(file))["obstacles"];
    EXPECT_EQ(obstacles[0]["kind"], "building");
    EXPECT_EQ(obstacles[0]["tags"], Json({"amenity=school", "building=yes"}));
    EXPECT_EQ(obstacles[0]["structures"],
              Json::parse(R"([{"kind": "building", "source_id": 17, "name": "Schule"}, {"kind": "barrier"}])"));
    EXPECT_EQ(obstacles[1]["kind"], "water");
    EXPECT_FALSE(obstacles[1].contains("tags"));
    EXPECT_FALSE(obstacles[1].contains("structures"));
    EXPECT_EQ(obstacles[2]["tags"], Json({"barrier=wall"}));
}

TEST(ObstaclesJson, SaysNothingThatTheMapDoesNotKnow) {
    const MapFile file{.map = map_from_ascii("#.#")};
    const Json json = Json::parse(obstacles_json(file));
    for (const Json& obstacle : json["obstacles"]) {
        for (const char* member : {"kind", "tags", "structures"}) EXPECT_FALSE(obstacle.contains(member));
    }
}

RC_GTEST_PROP(ObstaclesJson, RunsAreTheLabelsOfAllCells, ()) {
    const PlainMap plain = *random_map(20, 16);
    const MapFile file{.map = Map(plain.grid())};
    const Json runs = Json::parse(obstacles_json(file))["runs"];
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < runs.size(); i += 2) labels.insert(labels.end(), runs[i + 1], runs[i]);
    RC_ASSERT(std::ranges::equal(labels, file.map.labels()));
}

RC_GTEST_PROP(ObstaclesJson, PartsMakeTheWhole, ()) {
    const PlainMap plain = *random_map(20, 16);
    const MapFile file{.map = Map(plain.grid())};
    const auto limit = *rc::gen::inRange<std::size_t>(1, 5);
    Json joined{{"obstacles", Json::array()}, {"runs", Json::array()}};
    std::size_t after = 0;
    while (true) {
        const ObstaclesPart part = obstacles_part(file, after, limit);
        const Json json = Json::parse(part.json);
        RC_ASSERT(json["obstacles"].size() <= limit && json["runs"].size() <= 2 * 10 * limit);
        for (const char* list : {"obstacles", "runs"}) {
            joined[list].insert(joined[list].end(), json[list].begin(), json[list].end());
        }
        RC_ASSERT(json["next"] == (part.next ? Json(*part.next) : Json()));
        if (!part.next) break;
        RC_ASSERT(*part.next > after);
        after = *part.next;
    }
    const Json whole = Json::parse(obstacles_json(file));
    RC_ASSERT(whole["next"].is_null());
    RC_ASSERT(joined["obstacles"] == whole["obstacles"]);
    RC_ASSERT(joined["runs"] == whole["runs"]);
}

TEST(ObstaclesJson, NothingIsBehindTheLastCell) {
    const MapFile file{.map = map_from_ascii(".#")};
    const Json json = Json::parse(obstacles_part(file, 99, 1).json);
    EXPECT_TRUE(json["obstacles"].empty() && json["runs"].empty() && json["next"].is_null());
}

}  // namespace
}  // namespace waybreaker::io

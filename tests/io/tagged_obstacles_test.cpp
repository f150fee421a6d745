// Which obstacles a tag or a name means.
#include "io/tagged_obstacles.hpp"

#include <gtest/gtest.h>

#include "ascii_map.hpp"
#include "input_error.hpp"

namespace waybreaker::io {
namespace {

// A church; a section of a school and a shop; a section of the shop alone; a wall without a name.
MapFile town() {
    MapFile map{.map = map_from_ascii("aa.bb.c.d"), .source = "town.tif"};
    map.annotations.names = {"", "St. Mary", "Upper School, Corner Shop", "Corner Shop", ""};
    map.annotations.tags = {{"amenity=place_of_worship", {{1}}},
                            {"amenity=school", {{2}}},
                            {"building=church", {{1}}},
                            {"building=yes", {{2}, {3}}}};
    map.annotations.sections = {{{.name = "Upper School"}, {.name = "Corner Shop"}}, {{}, {}, {0, 1}, {1}, {}}};
    return map;
}

std::vector<std::uint32_t> meant(const std::string& text) {
    std::vector<ObstacleId> ids{{4}};
    add_tagged(town(), site::parse_tag_filters(text), "protect", ids);
    std::vector<std::uint32_t> values;
    for (const ObstacleId id : ids) values.push_back(id.value);
    return values;
}

TEST(TaggedObstacles, AreThoseThatHaveTheTag) {
    EXPECT_EQ(meant("amenity=school"), (std::vector<std::uint32_t>{2, 4}));
    EXPECT_EQ(meant("amenity"), (std::vector<std::uint32_t>{1, 2, 4}));
    EXPECT_EQ(meant("building=ch*,yes"), (std::vector<std::uint32_t>{1, 2, 3, 4}));
    EXPECT_EQ(meant("building=church,amenity=school"), (std::vector<std::uint32_t>{1, 2, 4}));
    EXPECT_EQ(meant("*"), (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(TaggedObstacles, AreCalledByWhatTheyArePartsOf) {
    EXPECT_EQ(meant("name=Corner Shop"), (std::vector<std::uint32_t>{2, 3, 4}));
    EXPECT_EQ(meant("name=*School"), (std::vector<std::uint32_t>{2, 4}));
    EXPECT_EQ(meant("name=St. M*"), (std::vector<std::uint32_t>{1, 4}));
    EXPECT_EQ(meant("name"), (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(TaggedObstacles, ThatAreNoneAreRefused) {
    const auto refusal = [](const std::string& text, const MapFile& map = town()) {
        std::vector<ObstacleId> ids;
        return input_error([&] { add_tagged(map, site::parse_tag_filters(text), "protect", ids); });
    };
    EXPECT_EQ(refusal("amenity=school,building=chapel"),
              "nothing to protect: no obstacle of town.tif has the tag 'building=chapel'; of building it has yes, "
              "church");
    EXPECT_EQ(refusal("shop"),
              "nothing to protect: no obstacle of town.tif has the tag 'shop'; maps keep amenity, barrier, building, "
              "heritage, historic and tourism, and names");
    EXPECT_EQ(refusal("name=Corner"),
              "nothing to protect: no obstacle of town.tif is called 'Corner'; a * stands for any text");
    EXPECT_EQ(refusal("amenity", {.map = map_from_ascii("#."), .source = "x.map"}),
              "nothing to protect: no obstacle of x.map has tags such as 'amenity': maps that waybreaker import makes "
              "for a rover, truck or walker keep them");
}

}  // namespace
}  // namespace waybreaker::io

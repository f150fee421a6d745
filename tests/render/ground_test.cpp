// Streets, water and green beneath a plan.
#include "render/ground.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

using Kind = site::Background::Kind;
using Shape = site::Background::Shape;

// Ten pixels a cell, the upper-left corner at 100, 50.
Layout layout() {
    return {.width = 1000,
            .height = 1000,
            .unit = 1,
            .cell = 10,
            .sample_step = 1,
            .window = {100, 50, 400, 300},
            .map = {100, 50, 400, 300}};
}

std::string drawn(const site::Background::Feature& feature) {
    return ground({{feature}}, layout());
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Ground, LiesWhereTheCellsAre) {
    const std::string street = drawn({Kind::street, "primary", "", Shape::line, {{{0, 0}, {9.5, 2}}}});
    EXPECT_TRUE(has(street, "d=\"M105.0 55.0L200.0 75.0\" fill=\"none\"")) << street;
    EXPECT_TRUE(has(street, colour::road.data())) << street;
    const std::string lake =
        drawn({Kind::water, "water", "", Shape::area, {{{0, 0}, {0, 9}, {9, 9}}, {{1, 4}, {4, 8}, {1, 8}}}});
    EXPECT_TRUE(has(lake, "d=\"M105.0 55.0L105.0 145.0L195.0 145.0zM115.0 95.0L145.0 135.0L115.0 135.0z\"")) << lake;
    EXPECT_TRUE(has(lake, "fill-rule=\"evenodd\"")) << lake;
}

TEST(Ground, StaysOnTheMap) {
    const std::string street = drawn({Kind::street, "primary", "", Shape::line, {{{-90, 0}, {900, 2}}}});
    EXPECT_TRUE(has(street, R"(<clipPath id="map"><rect x="100" y="50" width="400" height="300"/></clipPath>)"));
    EXPECT_TRUE(has(street, "<g clip-path=\"url(#map)\">"));
}

TEST(Ground, HasLargeStreetsAboveSmallOnesAndGreenBelow) {
    const std::string all = ground({{{Kind::street, "primary", "", Shape::line, {{{0, 0}, {1, 0}}}},
                                     {Kind::street, "footway", "", Shape::line, {{{0, 0}, {2, 0}}}},
                                     {Kind::green, "park", "", Shape::area, {{{0, 0}, {0, 9}, {9, 9}}}}}},
                                   layout());
    const std::size_t primary = all.rfind("M105.0 55.0L115.0 55.0");
    const std::size_t footway = all.find("M105.0 55.0L125.0 55.0");
    const std::size_t park = all.find("M105.0 55.0L105.0 145.0");
    EXPECT_LT(park, footway);
    EXPECT_LT(footway, primary);
    EXPECT_NE(primary, std::string::npos);
}

TEST(Ground, IsNothingWhereNothingCanBeSeen) {
    EXPECT_EQ(ground({}, layout()), "");
    EXPECT_EQ(drawn({Kind::place, "square", "Market", Shape::point, {{{3, 4}}}}), "");
    EXPECT_EQ(drawn({Kind::street, "primary", "", Shape::line, {{{3, 4}, {3.05, 4}}}}), "");
}

}  // namespace
}  // namespace waybreaker::render

// Areas and lines across 180 degrees are cut there: nothing of them is lost, and no part crosses it.
#include "io/antimeridian.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/lon_lat_json.hpp"

namespace waybreaker::io {
namespace {

double turned(double longitude) {
    return longitude < 0 ? longitude + 360 : longitude;
}

// Positive if it runs counterclockwise.
double area(const std::vector<LonLat>& ring) {
    double twice = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        twice += turned(ring[i - 1][0]) * ring[i][1] - turned(ring[i][0]) * ring[i - 1][1];
    }
    return twice / 2;
}

double area(const std::vector<LonLatPolygon>& polygons) {
    double sum = 0;
    for (const LonLatPolygon& polygon : polygons) {
        for (const auto& ring : polygon) {
            // -180 is a place of the east; as such it is the other end of the circle.
            std::vector<LonLat> shifted = ring;
            const bool east = std::ranges::any_of(ring, [](const LonLat& place) { return place[0] < 0; });
            for (LonLat& place : shifted) place[0] = east ? place[0] + 360 : place[0];
            sum += area(shifted);
        }
    }
    return sum;
}

void expect_on_one_side(const std::vector<LonLatPolygon>& polygons) {
    for (const LonLatPolygon& polygon : polygons) {
        for (const auto& ring : polygon) {
            EXPECT_EQ(ring.front(), ring.back());
            for (std::size_t i = 1; i < ring.size(); ++i) EXPECT_LT(std::abs(ring[i][0] - ring[i - 1][0]), 90);
        }
    }
}

TEST(Antimeridian, CutsALineWhereAndWhenItCrosses) {
    const auto parts = cut_line({{{179, 10}, {-179, 12}, {-178, 12}, {179, 9}}, {0, 8, 9, 12}});
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].places, (std::vector<LonLat>{{179, 10}, {180, 11}}));
    EXPECT_EQ(parts[0].times, (std::vector<double>{0, 4}));
    EXPECT_EQ(parts[1].places, (std::vector<LonLat>{{-180, 11}, {-179, 12}, {-178, 12}, {-180, 10}}));
    EXPECT_EQ(parts[1].times, (std::vector<double>{4, 8, 9, 11}));
    EXPECT_EQ(parts[2].places, (std::vector<LonLat>{{180, 10}, {179, 9}}));
    EXPECT_EQ(parts[2].times, (std::vector<double>{11, 12}));
}

TEST(Antimeridian, LeavesTheRestOfTheWorldAlone) {
    const TimedLine line{{{-10, 1}, {170, 2}}, {0, 1}};  // a half turn is none across it
    ASSERT_EQ(cut_line(line).size(), 1U);
    EXPECT_EQ(cut_line(line)[0].places, line.places);
    const LonLatPolygon square{{{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}}};
    EXPECT_EQ(cut_polygon(square), std::vector<LonLatPolygon>{square});
}

TEST(Antimeridian, CutsASquareInTwo) {
    const auto parts = cut_polygon({{{179, 1}, {-178, 1}, {-178, 2}, {179, 2}, {179, 1}}});
    ASSERT_EQ(parts.size(), 2U);
    expect_on_one_side(parts);
    EXPECT_DOUBLE_EQ(area(std::vector<LonLatPolygon>{parts[0]}), 1);
    EXPECT_DOUBLE_EQ(area(std::vector<LonLatPolygon>{parts[1]}), 2);
}

// A comb whose teeth reach over the line, with a hole in its back and one across the line.
TEST(Antimeridian, CutsWhatIsCrossedOften) {
    const LonLatPolygon comb{
        {{178, 0}, {-179, 0}, {-179, 1}, {179, 1}, {179, 2}, {-179, 2}, {-179, 5}, {178, 5}, {178, 0}},
        {{178.2, 1}, {178.2, 2}, {178.6, 2}, {178.6, 1}, {178.2, 1}},
        {{179.5, 3}, {179.5, 4}, {-179.5, 4}, {-179.5, 3}, {179.5, 3}}};
    const auto parts = cut_polygon(comb);
    expect_on_one_side(parts);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].size(), 2U);  // the back keeps its hole
    EXPECT_EQ(parts[1].size(), 1U);
    EXPECT_NEAR(area(parts), 3 * 5 - 2 - 0.4 - 1, 1e-9);
    for (const LonLatPolygon& part : parts) {
        for (std::size_t i = 0; i < part.size(); ++i)
            EXPECT_EQ(area(std::vector<LonLatPolygon>{LonLatPolygon{part[i]}}) > 0, i == 0);
    }
}

TEST(Antimeridian, InGeoJsonIsWhereLinesAndAreasHaveSeveralParts) {
    const site::ToLonLat along_the_equator = [](Point p) {
        return std::array<double, 2>{p.x > 2 ? p.x - 182 : 178 + p.x, -p.y};
    };
    const LineJson line = line_json(along_the_equator, {{1, 1, 0}, {3, 1, 2}});
    EXPECT_EQ(
        line.geometry.dump(),
        R"({"type":"MultiLineString","coordinates":[[[179.0,-1.0],[180.0,-1.0]],[[-180.0,-1.0],[-179.0,-1.0]]]})");
    EXPECT_EQ(line.times.dump(), "[0.0,1.0,1.0,2.0]");
    EXPECT_EQ(line_json(along_the_equator, {{1, 1, 0}}).geometry.dump(),
              R"({"type":"LineString","coordinates":[[179.0,-1.0],[179.0,-1.0]]})");
    const site::Polygon square{{{1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 0}}};
    const auto areas = polygons_json(along_the_equator, {square});
    EXPECT_EQ(areas["type"], "MultiPolygon");
    EXPECT_EQ(areas["coordinates"].size(), 2U);
}

}  // namespace
}  // namespace waybreaker::io

// A map's background and names as metadata, and reading them back: whole, cut, and through GDAL's
// tools.
#include "site/background.hpp"

#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "geotiff/background_item.hpp"
#include "geotiff/label_tiff.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

using FeatureKind = site::Background::Kind;
using Shape = site::Background::Shape;

site::Georeference utm_place(int zone = 33, double cell = 2.4) {
    OGRSpatialReference utm;
    utm.importFromEPSG(32600 + zone);
    char* text = nullptr;
    utm.exportToWkt(&text);
    site::Georeference place{text, {390000.25, cell, 0, 5820000.75, 0, -cell}};
    CPLFree(text);
    return place;
}

// One feature of each shape, on a map of 40 x 30 cells.
site::Background scene() {
    return {{{FeatureKind::street,
              "primary",
              "Friedrichstraße",
              Shape::line,
              {{{0, 3}, {39, 4.5}}, {{2, 2}, {2, 28}, {5, 30}}}},
             {FeatureKind::green,
              "park",
              "",
              Shape::area,
              {{{1, 9}, {9, 9}, {9, 1}, {1, 1}}, {{3, 3}, {5, 3}, {5, 5}}, {{20, 9}, {29, 9}, {29, 1}}}},
             {FeatureKind::place, "square", "Platz der Stille", Shape::point, {{{12, 13}}}}}};
}

void expect_same(const site::Background& a, const site::Background& b, double tolerance) {
    ASSERT_EQ(a.features.size(), b.features.size());
    for (std::size_t i = 0; i < a.features.size(); ++i) {
        const site::Background::Feature& one = a.features[i];
        const site::Background::Feature& other = b.features[i];
        EXPECT_EQ(one.kind, other.kind);
        EXPECT_EQ(one.type, other.type);
        EXPECT_EQ(one.name, other.name);
        EXPECT_EQ(one.shape, other.shape);
        ASSERT_EQ(one.parts.size(), other.parts.size());
        for (std::size_t j = 0; j < one.parts.size(); ++j) {
            ASSERT_EQ(one.parts[j].size(), other.parts[j].size());
            for (std::size_t k = 0; k < one.parts[j].size(); ++k) {
                EXPECT_LE(distance(one.parts[j][k], other.parts[j][k]), tolerance);
            }
        }
    }
}

constexpr double decimetre = 0.1 / 2.4;

TEST(Background, is_a_table_that_gis_can_open) {
    const std::string text = background_text(scene(), utm_place());
    EXPECT_TRUE(text.starts_with("WKT;kind;class;name\nMULTILINESTRING((13.3")) << text;
    EXPECT_NE(text.find("));street;primary;Friedrichstraße\nMULTIPOLYGON((("), std::string::npos) << text;
    EXPECT_NE(text.find(")));green;park;\nMULTIPOINT((13.3"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("));place;square;Platz der Stille")) << text;
    EXPECT_EQ(text.find('"'), std::string::npos);
}

TEST(Background, comes_back) {
    const std::string text = background_text(scene(), utm_place());
    const site::Background read = parse_background(text, utm_place(), 40, 30, "city.tif");
    expect_same(read, scene(), decimetre);
    EXPECT_EQ(background_text(read, utm_place()), text);
}

TEST(Background, comes_back_out_of_a_map_file) {
    const LabelTiff written{.map = Map::from_labels(40, 30, std::vector<std::uint32_t>(1200, 0)),
                            .cell_size = 2.4,
                            .georeference = utm_place(),
                            .annotations = {.background = scene()}};
    const std::string bytes = label_tiff_bytes(written);
    const LabelTiff read = read_label_tiff(bytes, "city.tif");
    expect_same(read.annotations.background, scene(), decimetre);
    EXPECT_EQ(label_tiff_bytes(read), bytes);
}

TEST(Background, keeps_what_reaches_into_a_piece_at_its_place) {
    site::Georeference piece = utm_place();
    piece.transform[0] += 9 * 2.4;  // nine cells to the east
    const site::Background read = parse_background(background_text(scene(), utm_place()), piece, 12, 30, "city.tif");
    const site::Background expected{
        {{FeatureKind::street, "primary", "Friedrichstraße", Shape::line, {{{-9, 3}, {30, 4.5}}}},
         {FeatureKind::green,
          "park",
          "",
          Shape::area,
          {{{-8, 9}, {0, 9}, {0, 1}, {-8, 1}}, {{11, 9}, {20, 9}, {20, 1}}}},
         {FeatureKind::place, "square", "Platz der Stille", Shape::point, {{{3, 13}}}}}};
    expect_same(read, expected, decimetre);
}

TEST(Background, stays_a_table_whatever_names_hold) {
    const site::Background read = parse_background(
        background_text({{{FeatureKind::rail, "tram;train", " \"A\"; B\n\x07", Shape::point, {{{1, 1}}}}}},
                        utm_place()),
        utm_place(), 40, 30, "city.tif");
    ASSERT_EQ(read.features.size(), 1U);
    EXPECT_EQ(read.features[0].type, "tram,train");
    EXPECT_EQ(read.features[0].name, "'A', B");
}

TEST(Background, of_nothing_is_nothing) {
    EXPECT_EQ(background_text({}, utm_place()), "");
    const std::string heading = "WKT;kind;class;name";
    EXPECT_EQ(parse_background(heading, utm_place(), 40, 30, "city.tif"), site::Background{});
    EXPECT_EQ(parse_background(heading + "\nMULTIPOLYGON EMPTY;green;park;", utm_place(), 40, 30, "city.tif"),
              site::Background{});
}

TEST(Background, refuses_what_is_no_such_table_and_says_why) {
    const std::string good = "WKT;kind;class;name\nPOINT(13.38 52.52);place;square;X\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"rubbish", "does not begin with WKT;kind;class;name"},
        {"WKT;kind", "does not begin with"},
        {good + "POINT(13.38 52.52);castle;x;y", "line 3 of its metadata item WAYBREAKER_BACKGROUND is no feature"},
        {good + "POINT(13.38);place;x;y", "line 3"},
        {good + "CIRCULARSTRING(0 0,1 1,2 0);street;x;y", "line 3"},
        {good + "GEOMETRYCOLLECTION(POINT(1 2));street;x;y", "line 3"},
        {good + "\n", "line 3"},
        {good + "POINT(13.38 52.52)", "line 3"},
        {std::string(max_background_bytes + 1, ' '), "has more than 8388608 bytes"}};
    for (const auto& [text, words] : cases) {
        try {
            parse_background(text, utm_place(), 40, 30, "city.tif");
            ADD_FAILURE() << "accepted: " << text.substr(0, 80);
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with("city.tif: ")) << message;
            EXPECT_NE(message.find(words), std::string::npos) << message;
            EXPECT_NE(message.find("gdal_edit.py -mo WAYBREAKER_BACKGROUND="), std::string::npos) << message;
        }
    }
}

TEST(Background, leaves_out_what_has_no_place_on_the_map) {
    const std::string heading = "WKT;kind;class;name\n";
    for (const char* shape : {"POINT(-120 40)", "POINT(1e300 1e300)", "LINESTRING(13.38 52.52,500 900)",
                              "LINESTRING(13.38 52.52)", "POLYGON((13.3 52.5,13.4 52.5))"}) {
        EXPECT_EQ(parse_background(heading + shape + ";street;x;y", utm_place(), 40, 30, "city.tif"),
                  site::Background{})
            << shape;
    }
}

RC_GTEST_PROP(Background, survives_any_change_of_a_byte, ()) {
    std::string text = background_text(scene(), utm_place());
    text[*rc::gen::inRange(std::size_t{0}, text.size())] = char(*rc::gen::inRange(-128, 128));
    try {
        for (const site::Background::Feature& feature :
             parse_background(text, utm_place(), 40, 30, "city.tif").features) {
            for (const auto& part : feature.parts) {
                for (const Point& point : part) RC_ASSERT(std::isfinite(point.x) && std::isfinite(point.y));
            }
        }
    } catch (const InputError&) {
    }
}

// An affine map to degrees is off by the bend of the meridians, which grows with the square of the map's size.
TEST(AffineToLonLat, is_good_to_a_cell_or_not_there) {
    for (const int zone : {33, 40}) {
        const site::Georeference place = utm_place(zone);
        const auto affine = affine_to_lon_lat(place, 501, 333);
        ASSERT_TRUE(affine);
        const auto [a, b, c, d, e, f] = *affine;
        const FromLonLat to_cells(place);
        for (const Point& cell : {Point{0, 0}, Point{500, 0}, Point{0, 332}, Point{500, 332}, Point{120.5, 7.25}}) {
            const std::vector<Point> back = to_cells({{a * cell.x + b * cell.y + c, d * cell.x + e * cell.y + f}});
            EXPECT_LE(distance(back.front(), cell), 0.05);
        }
    }
    EXPECT_TRUE(affine_to_lon_lat(utm_place(), 1, 1));
    EXPECT_FALSE(affine_to_lon_lat(utm_place(33, 30), 16384, 16384));
    EXPECT_FALSE(affine_to_lon_lat({"LOCAL_CS[\"hall\",UNIT[\"metre\",1]]"}, 501, 501));
}

TEST(FromLonLat, is_the_way_back) {
    const site::Georeference place = utm_place();
    const auto [longitude, latitude] = ToLonLat(place)(17.25, -3);
    const std::vector<Point> back = FromLonLat(place)({{longitude, latitude}, {longitude, 95}});
    EXPECT_LE(distance(back[0], Point{17.25, -3}), 1e-6);
    EXPECT_FALSE(std::isfinite(back[1].x));
}

}  // namespace
}  // namespace waybreaker::geotiff

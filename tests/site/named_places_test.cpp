// Streets, squares and obstacles are found by the names that people type.
#include "site/named_places.hpp"

#include <gtest/gtest.h>

#include "ascii_map.hpp"

namespace waybreaker::site {
namespace {

using Kind = Background::Kind;
using Shape = Background::Shape;
using How = PlacesFound::How;

struct Quarter {
    Map map = map_from_ascii(R"(
        aa...b
        aa...b
        ......)");
    Annotations known;
    Quarter() {
        known.names = {"", "Dom", "Hauptstraße"};
        known.background.features = {
            {Kind::street, "primary", "Hauptstraße", Shape::line, {{{0, 2}, {1, 2}}, {{1, 2}, {5, 2}}}},
            {Kind::street, "residential", "Am Dom", Shape::line, {{{0, 0}, {0, 1}}}},
            {Kind::street, "residential", "Žižkova", Shape::line, {{{-9, 1}, {1, 1}}}},
            {Kind::place, "city_block", "Domplatz", Shape::point, {{{3, 1}}}},
            {Kind::green, "park", "Domgarten", Shape::area, {{{2, 0}, {4, 0}, {4, 1}, {2, 1}}}}};
    }
    PlacesFound find(std::string_view text) const { return places_called(text, map, known); }
    std::vector<std::string> names(std::string_view text) const {
        std::vector<std::string> names;
        for (const NamedPlace& place : find(text).places) names.push_back(place.name);
        return names;
    }
};

TEST(NamedPlaces, WithThatVeryNameComeAlone) {
    const PlacesFound found = Quarter().find("DOM");
    EXPECT_EQ(found.how, How::exactly);
    ASSERT_EQ(found.places.size(), 1U);
    EXPECT_EQ(found.places[0].what, "obstacle 1");
    EXPECT_EQ(found.places[0].at, Point(0.5, 0.5));
}

TEST(NamedPlaces, BeginSoBeforeTheyHaveItInThem) {
    EXPECT_EQ(Quarter().find("domp").how, How::begins);
    EXPECT_EQ(Quarter().names("domp"), std::vector<std::string>{"Domplatz"});
    EXPECT_EQ(Quarter().names("do"), (std::vector<std::string>{"Dom", "Domgarten", "Domplatz"}));
    EXPECT_EQ(Quarter().find("garten").how, How::contains);
    EXPECT_EQ(Quarter().names("garten"), std::vector<std::string>{"Domgarten"});
    EXPECT_TRUE(Quarter().names("bahnhof").empty());
}

TEST(NamedPlaces, OfAStreetLieHalfWayAlongItsLongestPart) {
    const NamedPlace street = Quarter().find("hauptstrasse").places.at(0);
    EXPECT_EQ(street.what, "street");  // before the house that is called so
    EXPECT_EQ(street.at, Point(3, 2));
    EXPECT_EQ(Quarter().find("domgarten").places.at(0).at, Point(3, 0.5));
    EXPECT_EQ(Quarter().find("domplatz").places.at(0).what, "city block");
    EXPECT_EQ(Quarter().find("zizkova").places.at(0).at, Point(0, 1));  // on the map
}

TEST(NamedPlaces, AreFoundByTheBuildingsOfASection) {
    Quarter town;
    town.known.names = {"", "Mill, Barn", ""};
    town.known.sections = {{{ObstacleKind::building, 7, "Mill"}, {ObstacleKind::building, 8, "Barn"}},
                           {{}, {0, 1}, {}}};
    EXPECT_EQ(town.find("barn").places.at(0).what, "obstacle 1");
}

TEST(NamedPlaces, MindNeitherCapitalsNorAccents) {
    EXPECT_EQ(plain_text("Café Élan, Straße"), "cafe elan, strasse");
    EXPECT_EQ(plain_text("ŽIŽKOV Łódź Ærø"), "zizkov lodz aero");
    EXPECT_EQ(plain_text("e\xCC\x81lan"), "elan");  // the accent is a character of its own
    EXPECT_EQ(plain_text("Площадь Ёлки Αθήνα 東京"), "площадь ёлки αθήνα 東京");
    EXPECT_EQ(plain_text("\xC5"), "a");  // cut short: Latin-1, perhaps
}

}  // namespace
}  // namespace waybreaker::site

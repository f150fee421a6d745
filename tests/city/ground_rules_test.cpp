// What single features are to a profile.
#include "city/ground_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace waybreaker::city {
namespace {

using Shape = site::Background::Shape;
using enum Profile;

// "key=value|key=value"
TagSet tags(const std::string& text) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t equals = text.find('=', begin);
        const std::size_t end = std::min(text.find('|', begin), text.size());
        pairs.emplace_back(text.substr(begin, equals - begin), text.substr(equals + 1, end - equals - 1));
        begin = end + 1;
    }
    return TagSet(std::move(pairs));
}

// The layers of a feature: s(ide of a bridge), w(ater), o(ver water), f(orbidden), c(losed), b(arrier), g(ate),
// u(nderpass), W(ay), - shut, r(oad).
std::string layers(const std::string& text, Shape shape = Shape::line, Profile profile = rover) {
    std::string result;
    for (const GroundUse& use : ground_uses(tags(text), shape, profile)) {
        result += std::string("swofcbguW-r")[std::size_t(use.layer)];
    }
    return result;
}

double width(const std::string& text) {
    return ground_uses(tags(text), Shape::line, rover).at(0).width;
}

TEST(GroundRules, KnowWhoMayGoWhere) {
    EXPECT_EQ(layers("highway=residential"), "rW");
    EXPECT_EQ(layers("highway=construction"), "");
    EXPECT_EQ(layers("highway=motorway_link"), "f");
    EXPECT_EQ(layers("highway=motorway_link", Shape::line, truck), "rW");
    EXPECT_EQ(layers("highway=motorway|tunnel=yes"), "");
    EXPECT_EQ(layers("highway=footway", Shape::line, truck), "");
    EXPECT_EQ(layers("highway=steps"), "w");
    EXPECT_EQ(layers("highway=steps", Shape::line, walker), "rW");
    EXPECT_EQ(layers("highway=residential", Shape::line, paper), "");
}

TEST(GroundRules, HeedTheKeyOfTheVehicleBeforeTheGeneralOne) {
    EXPECT_EQ(layers("highway=service|access=private"), "f");
    EXPECT_EQ(layers("highway=service|access=private|foot=yes"), "rW");
    EXPECT_EQ(layers("highway=service|access=private|foot=yes", Shape::line, truck), "f");
    EXPECT_EQ(layers("highway=service|access=destination"), "rW");
    EXPECT_EQ(layers("highway=service|foot=no"), "");
    EXPECT_EQ(layers("highway=service|foot=no", Shape::line, truck), "rW");
    EXPECT_EQ(layers("highway=service|hgv=no", Shape::line, truck), "");
    EXPECT_EQ(layers("highway=service|tunnel=building_passage|access=private"), "");
}

TEST(GroundRules, TellBridgesFromTunnels) {
    EXPECT_EQ(layers("highway=path|bridge=yes"), "sorW");
    EXPECT_EQ(layers("highway=path|bridge=boardwalk"), "orW");
    EXPECT_EQ(layers("highway=path|bridge=no"), "rW");
    EXPECT_EQ(layers("highway=path|ford=yes"), "orW");
    EXPECT_EQ(layers("highway=path|bridge=yes|layer=-1"), "u");
    EXPECT_EQ(layers("highway=path|tunnel=yes"), "u");
    EXPECT_EQ(layers("highway=path|tunnel=building_passage|layer=-1"), "rW");
    EXPECT_EQ(layers("highway=path|indoor=yes"), "");
    EXPECT_EQ(layers("man_made=pier"), "orW");
    EXPECT_EQ(layers("man_made=pier", Shape::area), "or");
    EXPECT_EQ(layers("highway=pedestrian|bridge=yes", Shape::area), "or");
}

TEST(GroundRules, KnowWhatBlocks) {
    EXPECT_EQ(layers("natural=water", Shape::area), "w");
    EXPECT_EQ(layers("leisure=swimming_pool|location=indoor", Shape::area), "");
    EXPECT_EQ(layers("waterway=river|tunnel=culvert"), "");
    EXPECT_EQ(layers("waterway=stream"), "");
    EXPECT_EQ(layers("railway=rail"), "f");
    EXPECT_EQ(layers("railway=tram"), "");
    EXPECT_EQ(layers("railway=disused"), "");
    EXPECT_EQ(layers("leisure=garden|access=private", Shape::area), "f");
    EXPECT_EQ(layers("building=house|access=private", Shape::area), "");
    EXPECT_EQ(layers("natural=water|access=private", Shape::area), "w");
    EXPECT_EQ(layers("military=barracks", Shape::area), "c");
    EXPECT_EQ(layers("barrier=hedge"), "b");
    EXPECT_EQ(layers("barrier=kerb"), "");
    EXPECT_EQ(layers("barrier=retaining_wall"), "w");
}

TEST(GroundRules, OpenGatesThatAreNotLocked) {
    EXPECT_EQ(layers("barrier=gate", Shape::point), "g");
    EXPECT_EQ(layers("barrier=gate|access=private", Shape::point), "b-");
    EXPECT_EQ(layers("barrier=gate|locked=yes", Shape::point), "b-");
    EXPECT_EQ(layers("barrier=stile", Shape::point), "b-");
    EXPECT_EQ(layers("barrier=stile", Shape::point, walker), "g");
}

TEST(GroundRules, BelieveWidthsThatCanBe) {
    EXPECT_EQ(width("highway=trunk"), 8);
    EXPECT_EQ(width("highway=trunk|lanes=4"), 13);
    EXPECT_EQ(width("highway=trunk|lanes=4|width=15.5 m"), 15.5);
    EXPECT_EQ(width("highway=trunk|width=229"), 8);
    EXPECT_EQ(width("waterway=river|width=60"), 60);
    EXPECT_EQ(width("waterway=river"), 12);
}

TEST(GroundRules, KnowWhatStandsInTheWay) {
    EXPECT_TRUE(stands_in_the_way(tags("building=yes")));
    EXPECT_TRUE(stands_in_the_way(tags("building=yes|layer=1")));
    EXPECT_FALSE(stands_in_the_way(tags("building=roof")));
    EXPECT_FALSE(stands_in_the_way(tags("building=yes|layer=-1")));
    EXPECT_FALSE(stands_in_the_way(tags("building=yes|location=underground")));
}

}  // namespace
}  // namespace waybreaker::city

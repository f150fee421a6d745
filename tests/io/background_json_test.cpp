// The background as the service returns it.
#include "io/background_json.hpp"

#include <gtest/gtest.h>

namespace waybreaker::io {
namespace {

using Kind = site::Background::Kind;
using Shape = site::Background::Shape;

TEST(BackgroundJson, has_a_list_of_points_for_each_part) {
    const site::Background background{
        {{Kind::street, "primary", "\"A\" & Straße", Shape::line, {{{0, -0.001}, {1.254, 2}}, {{3, 4}, {5, 6}}}},
         {Kind::water, "river", "", Shape::area, {{{0, 0}, {0, 9}, {9, 9}}}},
         {Kind::place, "square", "Platz", Shape::point, {{{7, 8.5}}}}}};
    EXPECT_EQ(background_json(background),
              R"({"features":[)"
              R"({"kind":"street","class":"primary","name":"\"A\" & Straße","shape":"line",)"
              R"("points":[[[0.0,0.0],[1.25,2.0]],[[3.0,4.0],[5.0,6.0]]]},)"
              R"({"kind":"water","class":"river","name":"","shape":"area","points":[[[0.0,0.0],[0.0,9.0],[9.0,9.0]]]},)"
              R"({"kind":"place","class":"square","name":"Platz","shape":"point","points":[[[7.0,8.5]]]}]})");
    EXPECT_EQ(background_json({}), R"({"features":[]})");
}

}  // namespace
}  // namespace waybreaker::io

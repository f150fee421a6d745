#include "render/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <string>

namespace waybreaker::render {
namespace {

Histogram two_series() {
    return {.title = "t",
            .x_label = "x",
            .y_label = "y",
            .series = {{.name = "ours", .values = {1, 1, 2, 3}, .mark = 1, .mark_name = "planned"},
                       {.name = "theirs", .values = {2, 5}, .mark = {}, .mark_name = {}}}};
}

// Of all rectangles of that fill, in the picture.
double height_of(const std::string& svg, const char* fill) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    double sum = 0;
    for (const pugi::xml_node rect : document.child("svg").children("rect")) {
        if (std::string(rect.attribute("fill").value()) == fill && rect.attribute("stroke-width"))
            sum += rect.attribute("height").as_double();
    }
    return sum;
}

TEST(Histogram, EachSeriesHasBarsOfAHundredPercent) {
    const std::string svg = histogram_svg(two_series());
    const double first = height_of(svg, "#0072b2");
    EXPECT_GT(first, 0);
    EXPECT_NEAR(first, height_of(svg, "url(#second)"), 0.1);
    EXPECT_NE(svg.find("dashed line: planned"), std::string::npos);
}

TEST(Histogram, TakesAnything) {
    EXPECT_EQ(histogram_svg(two_series()), histogram_svg(two_series()));
    Histogram none{.title = "<&>", .x_label = "", .y_label = "", .series = {{.name = "nobody", .values = {}}}};
    EXPECT_EQ(height_of(histogram_svg(none), "#0072b2"), 0);
    none.series[0].values = {7, 7};
    EXPECT_GT(height_of(histogram_svg(none), "#0072b2"), 0);
}

}  // namespace
}  // namespace waybreaker::render

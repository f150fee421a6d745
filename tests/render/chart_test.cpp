#include "render/chart.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "raster/png.hpp"
#include "render/chart_axis.hpp"

namespace waybreaker::render {
namespace {

Chart chart_of(const std::vector<double>& values, bool logarithmic) {
    Chart chart{
        .title = "t", .x_label = "x", .y_label = "y", .categories = {}, .series = {{.name = "s", .points = {}}}};
    for (const double value : values) {
        chart.categories.push_back("c");
        chart.series[0].points.push_back(ChartPoint{value, value, value});
    }
    chart.logarithmic = logarithmic;
    return chart;
}

std::vector<std::string> labels(const std::vector<double>& values, bool logarithmic = false, bool from_zero = false) {
    Chart chart = chart_of(values, logarithmic);
    chart.from_zero = from_zero;
    std::vector<std::string> labels;
    const ChartAxis axis(chart, 100, 0);
    for (const ChartAxis::Tick& tick : axis.ticks()) labels.push_back(tick.label);
    return labels;
}

using Labels = std::vector<std::string>;

TEST(ChartAxis, MarksRoundNumbersAroundTheValues) {
    EXPECT_EQ(labels({412, 547}), (Labels{"400", "450", "500", "550"}));
    EXPECT_EQ(labels({412, 547}, false, true), (Labels{"0", "100", "200", "300", "400", "500", "600"}));
    EXPECT_EQ(labels({0.11, 0.32}), (Labels{"0.1", "0.15", "0.2", "0.25", "0.3", "0.35"}));
    EXPECT_EQ(labels({-3, 3}), (Labels{"-3", "-2", "-1", "0", "1", "2", "3"}));
    EXPECT_EQ(labels({3, 40}, true), (Labels{"1", "2", "5", "10", "20", "50", "100"}));
    EXPECT_GE(labels({7}).size(), 2U);
    EXPECT_GE(labels({}).size(), 2U);
}

RC_GTEST_PROP(ChartAxis, KeepsTheOrderOfAllValuesWithinItsEnds, (std::vector<double> values, bool logarithmic)) {
    for (double& value : values) value = std::clamp(std::isfinite(value) ? value : 0.0, -1e12, 1e12);
    const ChartAxis axis(chart_of(values, logarithmic), 100, 0);
    for (const double a : values) {
        if (!axis.shows(a)) continue;
        RC_ASSERT(axis.at(a) > -1e-6);
        RC_ASSERT(axis.at(a) < 100 + 1e-6);
        for (const double b : values) {
            RC_ASSERT(!axis.shows(b) || a >= b || axis.at(a) >= axis.at(b));
        }
    }
    for (const ChartAxis::Tick& tick : axis.ticks()) {
        RC_ASSERT(axis.at(tick.value) > -1e-6);
        RC_ASSERT(axis.at(tick.value) < 100 + 1e-6);
    }
}

TEST(ChartSvg, ShowsWhatThereIsAndEscapesIt) {
    Chart chart = chart_of({1, 2, 3}, false);
    chart.title = "a < b & c";
    chart.series[0].name = "\"quoted\" \x01 <s>";
    chart.series[0].points[1] = std::nullopt;
    chart.series.push_back({.name = "empty", .points = {std::nullopt}});
    const std::string svg = chart_svg(chart);
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_EQ(svg.find("<s>"), std::string::npos);
    EXPECT_EQ(svg.find(">empty<"), std::string::npos) << "what has no point has no name";
    EXPECT_EQ(svg, chart_svg(chart));
    EXPECT_TRUE(raster::png_of(svg).starts_with("\x89PNG")) << "librsvg can read it";
}

TEST(ChartSvg, DrawsIntervalsOnlyWhereThereAreSome) {
    Chart without = chart_of({1, 2}, false);
    Chart with = without;
    with.series[0].points[0] = ChartPoint{1, 0.5, 1.5};
    const auto lines = [](const std::string& svg) {
        int count = 0;
        for (std::size_t at = svg.find("stroke-width=\"1.4\""); at != std::string::npos;
             at = svg.find("stroke-width=\"1.4\"", at + 1)) {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(lines(chart_svg(without)), 0);
    EXPECT_EQ(lines(chart_svg(with)), 3);
    // One that reaches 0 goes down to a logarithmic axis, and has no lower end to mark.
    with.logarithmic = true;
    EXPECT_EQ(lines(chart_svg(with)), 3);
    for (const double low : {0.0, -4.0}) {
        with.series[0].points[0]->low = low;
        EXPECT_EQ(lines(chart_svg(with)), 2);
    }
    const std::string svg = chart_svg(with);
    const std::size_t interval = svg.rfind("<line", svg.find("stroke-width=\"1.4\""));
    EXPECT_LT(svg.find("y1=\"372.0\"", interval), svg.find("/>", interval)) << "it begins at the axis";
}

TEST(ChartSvg, DrawsItsTitleUnlessItStandsAbove) {
    Chart chart = chart_of({1, 2}, false);
    chart.title = "Makespan";
    EXPECT_NE(chart_svg(chart).find(">Makespan</text>"), std::string::npos);
    chart.headed = false;
    EXPECT_EQ(chart_svg(chart).find(">Makespan</text>"), std::string::npos);
    EXPECT_NE(chart_svg(chart).find("<title>Makespan</title>"), std::string::npos) << "for who cannot see it";
}

}  // namespace
}  // namespace waybreaker::render

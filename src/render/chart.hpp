// Chart: a line chart of a few series over a few categories, with intervals; what a paper's figure is.
//
//     save("makespan.svg", render::chart_svg({.title = "Makespan", .y_label = "cells", .categories = {"1", "2"},
//     ...}));
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace waybreaker::render {

struct ChartPoint {
    double y = 0;
    double low = 0;  // of the interval; low = high = y draws none
    double high = 0;
};

struct ChartSeries {
    std::string name;
    std::vector<std::optional<ChartPoint>> points;  // by category; empty where there is none
    bool dashed = false;
    int colour = 0;  // series of one colour belong together; 0 to chart_colours - 1
};

inline constexpr int chart_colours = 6;  // safe for colour-blind readers (Okabe, Ito 2008)

struct Chart {
    std::string title;
    std::string x_label;
    std::string y_label;  // with the unit
    std::vector<std::string> categories;
    std::vector<ChartSeries> series;
    bool logarithmic = false;  // then values of 0 or less are not drawn, intervals from the axis on
    bool from_zero = false;    // of a linear axis
    bool lines = true;         // between the categories, where these are in order
    bool headed = true;        // draw the title; false where it stands above the chart already
};

// An SVG document of its own: axes with units and ticks, a marker shape for each colour, every series named at its end.
// Same input, same bytes. Any text may be given.
std::string chart_svg(const Chart& chart);

}  // namespace waybreaker::render

// Histogram: how often values are how large, of one series or of two side by side, with a mark at a value of each.
//
//     save("makespan.svg", render::histogram_svg({.title = "Makespan", .x_label = "time (s)", .y_label = "runs (%)",
//     ...}));
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace waybreaker::render {

struct HistogramSeries {
    std::string name;
    std::vector<double> values;       // in any order; none is infinite
    std::optional<double> mark = {};  // a line there
    std::string mark_name = {};
};

inline constexpr std::size_t histogram_series = 2;  // as many can be told apart

struct Histogram {
    std::string title;
    std::string x_label;  // with the unit
    std::string y_label;
    std::vector<HistogramSeries> series;  // at most histogram_series
};

// An SVG document of its own; heights are percent of the values of a series. Colours are safe for colour-blind readers,
// and the second series is hatched. Same input, same bytes. Any text may be given.
std::string histogram_svg(const Histogram& histogram);

}  // namespace waybreaker::render

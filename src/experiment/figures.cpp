#include "experiment/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace waybreaker::experiment {
namespace {

using render::Chart;
using render::ChartPoint;
using render::ChartSeries;

std::vector<std::string> categories(const SetSummary& summary) {
    std::vector<std::string> names{"before"};
    const std::size_t most = summary.series.empty() ? 0 : summary.series.front().at.size() - 1;
    for (std::size_t n = 1; n <= most; ++n) names.push_back(std::to_string(n));
    return names;
}

std::optional<ChartPoint> point(const std::optional<Estimate>& estimate) {
    return estimate ? std::optional(ChartPoint{estimate->mean, estimate->low, estimate->high}) : std::nullopt;
}

ChartSeries series_of(const Series& series, Measure measure, std::size_t index) {
    ChartSeries drawn{series.name, {}, false, int(index % render::chart_colours)};
    for (std::size_t n = 0; n < series.at.size(); ++n) drawn.points.push_back(point(series.of(measure, n)));
    return drawn;
}

bool is_empty(const ChartSeries& series) {
    return std::ranges::none_of(series.points, [](const auto& one) { return one.has_value(); });
}

Chart chart(const SetSummary& summary, std::string title, std::string y_label, Measure measure) {
    Chart chart{.title = std::move(title),
                .x_label = "removed obstacles",
                .y_label = std::move(y_label),
                .categories = categories(summary),
                .series = {}};
    for (std::size_t i = 0; i < summary.series.size(); ++i) {
        ChartSeries drawn = series_of(summary.series[i], measure, i);
        if (!is_empty(drawn)) chart.series.push_back(std::move(drawn));
    }
    return chart;
}

// "paper, w = 1: 3 removals are best, 1234 becomes 1100, -10.9 %"
std::vector<std::string> best_changes(const SetSummary& summary, Measure measure) {
    std::vector<std::string> sentences;
    for (const Series& series : summary.series) {
        const auto& before = series.of(measure, 0);
        std::size_t best = 0;
        for (std::size_t n = 1; n < series.at.size(); ++n) {
            const auto& here = series.of(measure, n);
            if (here && (best == 0 || here->mean < series.of(measure, best)->mean)) best = n;
        }
        if (!before || best == 0) continue;
        const double after = series.of(measure, best)->mean;
        sentences.push_back(fmt::format("{}: least with {} removed, {} becomes {} ({:+.1f} %)", series.name, best,
                                        four_digits(before->mean), four_digits(after),
                                        100 * (after / before->mean - 1)));
    }
    return sentences;
}

Figure nodes(const SetSummary& summary) {
    Figure figure{
        "figure-3-nodes",
        chart(summary, "Nodes: how many the ground search expanded (figure 3)", "nodes", Measure::nodes),
        "Removing obstacles saves up to 30 % of the nodes for w = 1 and up to 65 % for w = 2.",
        best_changes(summary, Measure::nodes),
        "Logarithmic. Theta* expands cells; the exact method expands corners, each with the obstacles crossed so "
        "far: its numbers are of another kind. With removals they are those of the choice as well."};
    figure.chart.logarithmic = true;
    return figure;
}

Figure runtime(const SetSummary& summary) {
    Figure figure{
        "figure-4-runtime",
        chart(summary, "Runtime of the ground search (figure 4)", "milliseconds", Measure::search_ms),
        "Removing obstacles saves up to 29.8 % of the runtime for w = 1 and up to 71 % for w = 2.",
        best_changes(summary, Measure::search_ms),
        "Logarithmic. As in the paper the search on the opened map alone, without the first one; for the exact method "
        "the search that also chooses."};
    figure.chart.logarithmic = true;
    return figure;
}

Figure whole_runtime(const SetSummary& summary) {
    Figure figure{
        "figure-4b-whole-mission",
        chart(summary, "Runtime of the whole mission", "milliseconds", Measure::total_ms),
        "Not in the paper.",
        {},
        "Logarithmic. Everything from the mission to the plan: both searches, choice, flight and times; for the exact "
        "method the proof too."};
    for (const Series& series : summary.series) {
        std::string times;
        for (std::size_t n = 0; n < series.at.size(); ++n) {
            const auto& total = series.of(Measure::total_ms, n);
            if (total)
                times +=
                    fmt::format("{} {} ms with {} removed", times.empty() ? ":" : ",", four_digits(total->mean), n);
        }
        figure.measured.push_back(series.name + times);
    }
    figure.chart.logarithmic = true;
    return figure;
}

Figure lengths(const SetSummary& summary) {
    Figure figure{"figure-5-lengths",
                  {.title = "Path lengths of both agents (figure 5)",
                   .x_label = "removed obstacles",
                   .y_label = "cells",
                   .categories = categories(summary),
                   .series = {}},
                  "Breach shortens the path of the ground agent (A) and lengthens that of the air agent (B).",
                  {},
                  "The vertical axis does not begin at 0. Empty markers and dashes: path B."};
    for (std::size_t i = 0; i < summary.series.size(); ++i) {
        for (const Measure measure : {Measure::path_a, Measure::path_b}) {
            ChartSeries drawn = series_of(summary.series[i], measure, i);
            drawn.name += measure == Measure::path_a ? ", A" : ", B";
            drawn.dashed = measure == Measure::path_b;
            figure.chart.series.push_back(std::move(drawn));
        }
        const Series& series = summary.series[i];
        const std::size_t last = series.at.size() - 1;
        const auto& a = series.of(Measure::path_a, last);
        const auto& b = series.of(Measure::path_b, last);
        if (last == 0 || !a || !b) continue;
        const auto change = [&](Measure measure, double after) {
            return 100 * (after / series.of(measure, 0)->mean - 1);
        };
        figure.measured.push_back(fmt::format("{}: with {} removed, A {:+.1f} % and B {:+.1f} %", series.name, last,
                                              change(Measure::path_a, a->mean), change(Measure::path_b, b->mean)));
    }
    return figure;
}

Figure flowtime(const SetSummary& summary) {
    return {"figure-6-flowtime",
            chart(summary, "Flowtime, the sum of both paths (figure 6)", "cells", Measure::flowtime),
            "2 to 3 removed obstacles are best; the gain is 3 to 5 %.", best_changes(summary, Measure::flowtime),
            "The vertical axis does not begin at 0."};
}

Figure makespan(const SetSummary& summary) {
    Figure figure{
        "figure-7-makespan",
        chart(summary, "Makespan, the longer path (figure 7)", "percent of the straight line", Measure::makespan),
        "3 to 4 removed obstacles are best, 5 with w = 2; the gain is 9 to 12 %.",
        best_changes(summary, Measure::makespan),
        "The vertical axis does not begin at 0. The bound is proven by the exact method: no plan with so many removals "
        "can be below it."};
    for (std::size_t i = 0; i < summary.series.size(); ++i) {
        if (summary.series[i].configuration.method != Method::exact) continue;
        ChartSeries bound = series_of(summary.series[i], Measure::bound, i);
        bound.name = "proven bound";
        bound.dashed = true;
        if (!is_empty(bound)) figure.chart.series.push_back(std::move(bound));
        break;
    }
    return figure;
}

}  // namespace

std::string four_digits(double value) {
    const double rounded = std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
    return std::abs(rounded) >= 1000 ? fmt::format("{:.0f}", rounded) : fmt::format("{:.4g}", rounded);
}

std::vector<Figure> paper_figures(const SetSummary& summary) {
    return {nodes(summary),   runtime(summary),  whole_runtime(summary),
            lengths(summary), flowtime(summary), makespan(summary)};
}

Figure conjecture_figure(const std::vector<SetSummary>& sets) {
    Figure figure{
        "conjecture",
        {.title = "Least flowtime, by kind of map (the paper's conjecture)",
         .x_label = "missions",
         .y_label = "percent of the flowtime before",
         .categories = {},
         .series = {},
         .lines = false},
        "\"For other environments, e.g. maze-like environments or the ones with spiral-shaped obstacles, the reduction "
        "might be more notable.\"",
        {},
        "For each method the number of removals with the least mean flowtime. Intervals are those of the mean after "
        "removal."};
    for (const SetSummary& set : sets) figure.chart.categories.push_back(set.name);
    for (std::size_t s = 0; s < sets.front().series.size(); ++s) {
        ChartSeries drawn{sets.front().series[s].name, {}, false, int(s % render::chart_colours)};
        for (const SetSummary& set : sets) {
            const Series& series = set.series[s];
            auto& at = drawn.points.emplace_back();
            for (std::size_t n = 1; n < series.at.size(); ++n) {
                const auto& before = series.of(Measure::flowtime, 0);
                const auto& after = series.of(Measure::flowtime, n);
                if (!before || !after || (at && at->y <= 100 * after->mean / before->mean)) continue;
                const double unit = 100 / before->mean;
                at = ChartPoint{after->mean * unit, after->low * unit, after->high * unit};
            }
        }
        figure.chart.series.push_back(std::move(drawn));
    }
    for (const SetSummary& set : sets) {
        const auto changes = [&](Measure measure, const char* what) {
            for (const std::string& sentence : best_changes(set, measure)) {
                figure.measured.push_back(fmt::format("{}, {}, {}", set.name, what, sentence));
            }
        };
        changes(Measure::flowtime, "flowtime");
        changes(Measure::makespan, "makespan");
    }
    return figure;
}

}  // namespace waybreaker::experiment

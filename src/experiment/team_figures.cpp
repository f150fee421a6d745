#include "experiment/team_figures.hpp"

#include <fmt/format.h>

namespace waybreaker::experiment {
namespace {

using render::ChartPoint;
using render::ChartSeries;

// An interval that reaches below 0 says only that there are too few maps for one, and shares of all have none.
ChartPoint point(const Estimate& estimate, TeamMeasure measure) {
    const bool known = estimate.low >= 0 && measure != TeamMeasure::solved;
    return {estimate.mean, known ? estimate.low : estimate.mean, known ? estimate.high : estimate.mean};
}

Figure team_figure(const TeamSummary& summary, TeamMeasure measure, const std::string& file, const std::string& title,
                   const std::string& y_label, const std::string& note) {
    Figure figure{file,
                  {.title = title,
                   .x_label = "vehicles + aircraft",
                   .y_label = y_label,
                   .categories = summary.sizes,
                   .series = {}},
                  "Not in the paper.",
                  {},
                  note};
    for (std::size_t s = 0; s < summary.series.size(); ++s) {
        const TeamSeries& series = summary.series[s];
        ChartSeries drawn{series.name, {}, false, int(s % render::chart_colours)};
        std::string figures;
        for (std::size_t i = 0; i < summary.sizes.size(); ++i) {
            const auto& here = series.of(measure, i);
            drawn.points.push_back(here ? std::optional(point(*here, measure)) : std::nullopt);
            if (!here) continue;
            figures +=
                fmt::format("{} {} for {}", figures.empty() ? ":" : ",", four_digits(here->mean), summary.sizes[i]);
        }
        if (figures.empty()) continue;
        figure.measured.push_back(series.name + figures);
        figure.chart.series.push_back(std::move(drawn));
    }
    return figure;
}

}  // namespace

std::vector<Figure> team_figures(const TeamSummary& summary) {
    if (summary.sizes.empty()) return {};
    Figure gap =
        team_figure(summary, TeamMeasure::gap, "team-gap", "Proven gap, by size of the team", "percent",
                    "How far the objective can be above the best: its value over the proven bound, less 1. Where "
                    "the missions' objective is flowtime, it is flowtime over its lower bound.");
    Figure time = team_figure(summary, TeamMeasure::seconds, "team-time", "Time of planning, by size of the team",
                              "seconds", "Logarithmic. From the mission to the plan with its bound, on one core.");
    Figure solved =
        team_figure(summary, TeamMeasure::solved, "team-success", "Missions with a plan, by size of the team",
                    "percent", "Of all missions, within the time limit.");
    Figure flowtime =
        team_figure(summary, TeamMeasure::flowtime, "team-flowtime", "Flowtime, by size of the team",
                    "percent of that of all alone, without removal",
                    "The vertical axis does not begin at 0. Below 100 removals gain more than agents lose on "
                    "each other. Of missions where every vehicle has a way without removal.");
    gap.chart.from_zero = true;
    time.chart.logarithmic = true;
    solved.chart.from_zero = true;
    return {std::move(gap), std::move(time), std::move(solved), std::move(flowtime)};
}

}  // namespace waybreaker::experiment

#include "experiment/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "experiment/figures.hpp"
#include "experiment/team_figures.hpp"
#include "raster/png.hpp"
#include "render/chart.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::experiment {
namespace {

constexpr double png_scale = 2;

constexpr std::string_view style =
    "body{font:16px/1.5 'DejaVu "
    "Sans',Helvetica,Arial,sans-serif;color:#26231f;background:#fff;max-width:900px;margin:2em "
    "auto;padding:0 1em}h1{font-size:1.6em}h2{font-size:1.2em;margin-top:2.5em}svg{max-width:100%;height:auto}"
    "table{border-collapse:collapse;font-size:14px;font-variant-numeric:tabular-nums}th,td{padding:.25em .8em;"
    "text-align:right;border-bottom:1px solid #e3ded6}th:first-child,td:first-child{text-align:left}"
    "dl{display:grid;grid-template-columns:max-content 1fr;gap:.2em 1em}dt{color:#6a635a}dd{margin:0}"
    "dd "
    "p{margin:0}.note{color:#6a635a;font-size:14px}.ci{color:#6a635a}.wide{overflow-x:auto}code{overflow-wrap:"
    "anywhere}";

std::string escaped(const std::string& text) {
    return render::xml_text(text, 10'000);
}

std::string cell(const std::optional<render::ChartPoint>& point) {
    if (!point) return "<td></td>";
    const double half = (point->high - point->low) / 2;
    return fmt::format("<td>{}{}</td>", four_digits(point->y),
                       half > 0 ? " <span class=\"ci\">&#177; " + four_digits(half) + "</span>" : "");
}

// What is drawn, in numbers.
std::string table(const render::Chart& chart) {
    std::string html = "<div class=\"wide\"><table><tr><th>" + escaped(chart.x_label) + "</th>";
    for (const std::string& category : chart.categories) html += "<th>" + escaped(category) + "</th>";
    html += "</tr>\n";
    for (const render::ChartSeries& series : chart.series) {
        html += "<tr><td>" + escaped(series.name) + "</td>";
        for (const auto& point : series.points) html += cell(point);
        html += "</tr>\n";
    }
    return html + "</table></div>\n";
}

std::string section(const Figure& figure) {
    render::Chart chart = figure.chart;
    chart.headed = false;
    std::string html =
        fmt::format("<h2 id=\"{}\">{}</h2>\n{}", figure.file, escaped(chart.title), render::chart_svg(chart));
    if (!figure.note.empty()) html += "<p class=\"note\">" + escaped(figure.note) + "</p>\n";
    html += "<dl><dt>The paper</dt><dd>" + escaped(figure.says) + "</dd>\n<dt>Measured</dt><dd>";
    for (const std::string& sentence : figure.measured) html += "<p>" + escaped(sentence) + "</p>\n";
    return html + "</dd></dl>\n" + table(figure.chart);
}

std::string opening(const Summary& summary) {
    const std::string title = summary.name.empty() ? "Experiment" : summary.name;
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\"><title>{0}</title>"
        "<style>{1}</style></head>\n<body><h1>{0}</h1>\n",
        escaped(title), style);
    const SetSummary& all = summary.all;
    html += "<p>";
    if (all.missions > 0) {
        html += fmt::format(
            "{} missions{}; every mean is over the {} of them, on {} maps{}, that all methods solved and that have a "
            "way "
            "without removal. ",
            all.missions, summary.teams.missions > 0 ? " of one vehicle and one aircraft" : "", all.compared, all.maps,
            all.places == all.maps ? ""
            : all.places == 1      ? " of one place"
                                   : fmt::format(" of {} places", all.places));
    }
    if (const TeamSummary& teams = summary.teams; teams.missions > 0) {
        html += fmt::format(
            "By size of the team: {} missions; means are over the {} of them that all configurations solved. ",
            teams.missions, teams.compared);
    }
    html +=
        "&#177; is half of a 95 % confidence interval, which allows for missions of one map, or of one place that the "
        "spec names, being alike.</p>\n";
    if (const Shard& shard = summary.shard; shard.count > 1)
        html += fmt::format("<p>These are the missions of shard {} of {} only.</p>\n", shard.index, shard.count);
    html += "<p>Results:";
    for (const auto& [status, count] : summary.statuses) html += fmt::format(" {} {};", count, escaped(status));
    html += fmt::format(" {} missing. waybreaker {}, experiment <code>{}</code>.</p>\n", summary.missing,
                        escaped(summary.version), escaped(summary.digest));
    if (all.missions == 0) return html;
    html +=
        "<p>Compared with the figures of A. Andreychuk, K. Yakovlev: Path Finding for the Coalition of Co-operative "
        "Agents "
        "Acting in the Environment with Destructible Obstacles, ICR 2018, arXiv 1807.00771. There are no numbers in "
        "the "
        "paper but those quoted.</p>\n";
    return html;
}

}  // namespace

std::vector<ReportFile> report(const Summary& summary) {
    std::vector<Figure> figures = team_figures(summary.teams);
    if (summary.all.missions > 0) std::ranges::move(paper_figures(summary.all), std::back_inserter(figures));
    if (summary.all.missions > 0 && summary.sets.size() > 1) figures.push_back(conjecture_figure(summary.sets));
    std::string page = opening(summary);
    std::vector<ReportFile> files;
    for (const Figure& figure : figures) {
        const std::string svg = render::chart_svg(figure.chart);
        page += section(figure);
        files.push_back({figure.file + ".svg", svg});
        files.push_back({figure.file + ".png", raster::png_of(svg, png_scale)});
    }
    files.push_back({"index.html", page + "</body></html>\n"});
    return files;
}

}  // namespace waybreaker::experiment

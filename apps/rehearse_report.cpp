#include "rehearse_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "io/csv_field.hpp"
#include "render/histogram.hpp"
#include "table.hpp"

namespace waybreaker::apps {
namespace {

using Json = nlohmann::ordered_json;

int count_of(const Rehearsal& rehearsal, Ending ending) {
    return int(std::ranges::count(rehearsal.runs, ending, &Rehearsed::ending));
}

double mean(const std::vector<double>& values) {
    return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

// Of all runs, those that arrived no later than planned.
double share_in_time(const Rehearsal& rehearsal) {
    const double limit = rehearsal.planned * (1 + 1e-9);
    const auto in_time = [&](const Rehearsed& run) { return run.ending == Ending::arrived && run.makespan <= limit; };
    return double(std::ranges::count_if(rehearsal.runs, in_time)) / double(rehearsal.runs.size());
}

std::string percent(double share) {
    return fmt::format("{:.1f} %", 100 * share);
}

std::string settings(const RehearsalReport& report) {
    const RehearsalOptions& options = report.options;
    std::string text = fmt::format("{} runs, seed {}", options.runs, options.seed);
    if (options.fail > 0) text += fmt::format("; breaches fail: {:.3g} %", 100 * options.fail);
    if (options.delay.mean > 0)
        text += fmt::format("; delays: {}, {:.6g}{}", to_string(options.delay.kind), options.delay.mean,
                            report.time_unit.empty() ? "" : " " + report.time_unit);
    if (options.blocked > 0) text += fmt::format("; blocked streets: {:.3g} %", 100 * options.blocked);
    if (options.lost > 0) text += fmt::format("; aircraft lost: {:.3g} %", 100 * options.lost);
    return text + "\n";
}

Row spread_row(const std::string& name, double planned, const Spread& spread, bool any) {
    Row row{name, fmt::format("{:.1f}", planned)};
    for (const double value : {spread.mean, spread.median, spread.p95, spread.worst})
        row.push_back(any ? fmt::format("{:.1f}", value) : nothing);
    return row;
}

std::string counts(const RehearsalReport& report, const RehearsedPlan& plan) {
    const Rehearsal& rehearsal = plan.rehearsal;
    const auto runs = double(rehearsal.runs.size());
    std::string text = fmt::format("{:<22} {} of {} ({})\n", plan.may_leave ? "played to the end" : "all vehicles home",
                                   rehearsal.arrived, rehearsal.runs.size(), percent(rehearsal.arrived / runs));
    if (plan.may_leave && rehearsal.arrived > 0)
        text += fmt::format("not reached in time    {:.2f} vehicles a run, {} as planned\n", rehearsal.unreached,
                            rehearsal.unreached_planned);
    const auto other = [&](Ending ending, const char* what) {
        if (const int count = count_of(rehearsal, ending); count > 0)
            text += fmt::format("  {:<20} {} ({})\n", what, count, percent(count / runs));
    };
    other(Ending::no_way, "no way left");
    other(Ending::not_found, "no plan found");
    other(Ending::broken, "could not stop");
    other(Ending::stuck, "stuck");
    if (rehearsal.on_reserve > 0)
        text += fmt::format("landed on reserve      in {} runs ({})\n", rehearsal.on_reserve,
                            percent(rehearsal.on_reserve / runs));
    if (rehearsal.emptied > 0)
        text += fmt::format("battery empty          in {} runs ({})\n", rehearsal.emptied,
                            percent(rehearsal.emptied / runs));
    if (rehearsal.caught > 0)
        text +=
            fmt::format("caught in a zone       in {} runs ({})\n", rehearsal.caught, percent(rehearsal.caught / runs));
    text += fmt::format("as early as planned    {}\n", percent(share_in_time(rehearsal)));
    text += fmt::format("revisions              {:.2f} a run", rehearsal.revisions);
    if (report.timing && !rehearsal.revise_ms.empty())
        text += fmt::format(", {:.1f} ms each, 99 % within {:.1f} ms", mean(rehearsal.revise_ms),
                            quantile(rehearsal.revise_ms, 0.99));
    return text + fmt::format("\nillegal                {}\n", rehearsal.illegal);
}

// Of the runs in which both arrived, how often the first did so before the second, and after it.
std::string comparison(const RehearsalReport& report) {
    const auto& first = report.plans[0].rehearsal.runs;
    const auto& second = report.plans[1].rehearsal.runs;
    int both = 0;
    int earlier = 0;
    int later = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i].ending != Ending::arrived || second[i].ending != Ending::arrived) continue;
        ++both;
        const double hair = 1e-9 * second[i].makespan;
        if (first[i].makespan < second[i].makespan - hair) ++earlier;
        if (first[i].makespan > second[i].makespan + hair) ++later;
    }
    if (both == 0) return "\nin no run did both arrive\n";
    return fmt::format("\nof {} runs in which both arrived the first plan was earlier in {}, later in {}\n", both,
                       percent(double(earlier) / both), percent(double(later) / both));
}

Json spread_json(double planned, const Spread& spread) {
    return {{"planned", planned},
            {"mean", spread.mean},
            {"median", spread.median},
            {"p95", spread.p95},
            {"worst", spread.worst}};
}

void add_figures(const RehearsedPlan& plan, bool timing, Json& json) {
    const Rehearsal& rehearsal = plan.rehearsal;
    json["runs"] = rehearsal.runs.size();
    json["arrived"] = rehearsal.arrived;
    json["illegal"] = rehearsal.illegal;
    json["on_reserve"] = rehearsal.on_reserve;
    json["emptied"] = rehearsal.emptied;
    json["caught"] = rehearsal.caught;
    json["makespan"] = spread_json(rehearsal.planned, rehearsal.makespan);
    json["ground_makespan"] = spread_json(rehearsal.ground_planned, rehearsal.ground_makespan);
    json["flowtime"] = spread_json(rehearsal.flowtime_planned, rehearsal.flowtime);
    if (plan.may_leave) json["unreached"] = {{"planned", rehearsal.unreached_planned}, {"mean", rehearsal.unreached}};
    json["as_planned"] = share_in_time(rehearsal);
    json["revisions"] = {{"mean", rehearsal.revisions}};
    if (timing) {
        json["revise_ms"] = {{"mean", mean(rehearsal.revise_ms)}, {"p99", quantile(rehearsal.revise_ms, 0.99)}};
    }
    json["endings"] = Json::object();
    for (const std::string_view word : waybreaker::words_of<Ending>) json["endings"][std::string(word)] = 0;
    for (const Rehearsed& run : rehearsal.runs) {
        Json& count = json["endings"][std::string(to_string(run.ending))];
        count = count.get<int>() + 1;
    }
    json["plan"] = plan.name;
}

}  // namespace

std::string rehearsal_table(const RehearsalReport& report, bool bold) {
    std::string text = settings(report);
    for (const RehearsedPlan& plan : report.plans) {
        const Rehearsal& rehearsal = plan.rehearsal;
        const bool any = rehearsal.arrived > 0;
        text += "\n";
        if (report.plans.size() > 1) text += shortened(plan.name) + "\n";
        const std::string unit = report.time_unit.empty() ? "time" : fmt::format("time ({})", report.time_unit);
        std::vector<Row> rows{{unit, "planned", "mean", "median", "95 %", "worst"},
                              spread_row("makespan", rehearsal.planned, rehearsal.makespan, any),
                              spread_row("ground makespan", rehearsal.ground_planned, rehearsal.ground_makespan, any)};
        if (plan.objective == Objective::flowtime)
            rows.push_back(spread_row("flowtime", rehearsal.flowtime_planned, rehearsal.flowtime, any));
        text += aligned(rows, bold);
        text += "\n" + counts(report, plan);
    }
    if (report.plans.size() > 1) text += comparison(report);
    return text;
}

std::string rehearsal_json(const RehearsalReport& report) {
    const RehearsalOptions& options = report.options;
    Json json{{"format", "waybreaker-rehearsal/1"}};
    add_figures(report.plans.front(), report.timing, json);
    json["seed"] = options.seed;
    json["settings"] = {{"fail", options.fail},
                        {"delay", {{"kind", to_string(options.delay.kind)}, {"mean", options.delay.mean}}},
                        {"blocked", options.blocked},
                        {"sight", options.sight},
                        {"lost", options.lost}};
    if (report.plans.size() > 1) add_figures(report.plans[1], report.timing, json["compared"]);
    return json.dump(2) + "\n";
}

std::string rehearsal_csv(const RehearsalReport& report) {
    std::string text =
        "plan,run,ending,makespan,ground_makespan,revisions,failed,blocked,lost,illegal,on_reserve,emptied,"
        "flowtime,unreached,caught\n";
    for (const RehearsedPlan& plan : report.plans) {
        for (std::size_t i = 0; i < plan.rehearsal.runs.size(); ++i) {
            const Rehearsed& run = plan.rehearsal.runs[i];
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", io::csv_field(plan.name), i,
                                to_string(run.ending), run.makespan, run.ground_makespan, run.revisions, run.failed,
                                run.blocked, run.lost, run.illegal, run.on_reserve, run.emptied, run.flowtime,
                                run.unreached, run.caught);
        }
    }
    return text;
}

std::string rehearsal_svg(const RehearsalReport& report) {
    render::Histogram histogram{
        .title = "How long the mission takes",
        .x_label = report.time_unit.empty() ? "makespan" : fmt::format("makespan ({})", report.time_unit),
        .y_label = "runs that arrived (%)",
        .series = {}};
    for (const RehearsedPlan& plan : report.plans) {
        render::HistogramSeries& series = histogram.series.emplace_back();
        series.name = report.plans.size() > 1 ? shortened(plan.name) : "rehearsed";
        series.mark = plan.rehearsal.planned;
        series.mark_name = fmt::format("as planned, {:.1f}", plan.rehearsal.planned);
        for (const Rehearsed& run : plan.rehearsal.runs) {
            if (run.ending == Ending::arrived) series.values.push_back(run.makespan);
        }
    }
    return render::histogram_svg(histogram);
}

}  // namespace waybreaker::apps

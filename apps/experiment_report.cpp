// `waybreaker experiment report`: results as a page with the paper's figures.
#include <fmt/format.h>

#include <filesystem>

#include "experiment.hpp"
#include "experiment/report.hpp"
#include "experiment/results.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "option.hpp"
#include "progress.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct ExperimentReportOptions {
    std::string results;
    std::string folder;
};

experiment::Summary summary_of(const std::string& path) {
    const Progress progress("reading " + path);
    experiment::Results results(path);
    return experiment::summarise(results);
}

void run(const ExperimentReportOptions& options) {
    const experiment::Summary summary = summary_of(options.results);
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error) throw InputError("cannot make the folder " + options.folder + ": " + error.message());
    for (const experiment::ReportFile& file : experiment::report(summary)) {
        io::write_whole((std::filesystem::path(options.folder) / file.name).string(), file.bytes);
    }
    const bool teams = summary.teams.missions > 0;
    const std::size_t compared = teams ? summary.teams.compared : summary.all.compared;
    const std::size_t missions = teams ? summary.teams.missions : summary.all.missions;
    const experiment::Shard& shard = summary.shard;
    io::write_whole("-",
                    fmt::format("{}: {} of {} missions compared{}{}\n",
                                (std::filesystem::path(options.folder) / "index.html").string(), compared, missions,
                                shard.count == 1 ? "" : fmt::format(", of shard {}/{} only", shard.index, shard.count),
                                summary.missing == 0 ? "" : fmt::format("; {} results are missing", summary.missing)));
}

}  // namespace

void setup_experiment_report(CLI::App& experiment, Run& run_chosen) {
    auto options = std::make_shared<ExperimentReportOptions>();
    CLI::App* command = experiment.add_subcommand(
        "report",
        "Draw the paper's figures from results\n\n"
        "Writes a page, index.html, that needs nothing beside it, and each figure as SVG and PNG: nodes, runtime, path "
        "lengths, flowtime and makespan by number of removals, with 95 % confidence intervals and what the paper says. "
        "Means are over the missions that all methods solved. Several scenario files are also compared with each "
        "other. Of teams: gap, time, success and flowtime against the size of the team.");
    add_file(*command, "RESULTS", options->results, "Results of an experiment")->required();
    add_file(*command, "-o,--output", options->folder, "The folder to write to")->required()->type_name("FOLDER");
    set_examples(*command, {"waybreaker experiment report results.db -o report"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

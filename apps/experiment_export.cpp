// `waybreaker experiment export`: results as CSV.
#include "experiment.hpp"
#include "experiment/results.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "named_files.hpp"
#include "option.hpp"

namespace waybreaker::apps {
namespace {

struct ExperimentExportOptions {
    std::string results;
    std::string output;
    bool no_timing = false;
};

void run(const ExperimentExportOptions& options) {
    require_ending("--output", options.output, {".csv"});
    io::write_whole(options.output, experiment::Results(options.results).csv(!options.no_timing));
}

}  // namespace

void setup_experiment_export(CLI::App& experiment, Run& run_chosen) {
    auto options = std::make_shared<ExperimentExportOptions>();
    CLI::App* command = experiment.add_subcommand(
        "export",
        "Write results as CSV\n\n"
        "One line a result, with the mission, the map and its digest, the method and its options, and the version.");
    add_file(*command, "RESULTS", options->results, "Results of an experiment")->required();
    add_file(*command, "-o,--output", options->output, "The CSV file to write; - is standard output")->required();
    command->add_flag("--no-timing", options->no_timing, "Leave out measured times: equal runs give equal bytes");
    set_examples(*command, {"waybreaker experiment export results.db -o results.csv",
                            "waybreaker experiment export results.db --no-timing -o - | sha256sum"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

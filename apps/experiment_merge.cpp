// `waybreaker experiment merge`: one file of results from all shards.
#include <fmt/format.h>

#include "experiment.hpp"
#include "experiment/merge.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "progress.hpp"

namespace waybreaker::apps {
namespace {

struct ExperimentMergeOptions {
    std::vector<std::string> shards;
    std::string output;
};

void run(const ExperimentMergeOptions& options) {
    require_ending("--output", options.output, {".db"}, "; waybreaker experiment export writes CSV");
    {
        const Progress progress(fmt::format("merging {} files", options.shards.size()));
        experiment::merge(options.shards, options.output);
    }
    io::write_whole("-", fmt::format("{}: complete, from {} shards\n", options.output, options.shards.size()));
}

}  // namespace

void setup_experiment_merge(CLI::App& experiment, Run& run_chosen) {
    auto options = std::make_shared<ExperimentMergeOptions>();
    CLI::App* command = experiment.add_subcommand(
        "merge",
        "Put the shards of an experiment together\n\n"
        "All shards must be there, complete, of the same experiment and version; else nothing "
        "is written, and what is missing is said. What comes out is what one run without "
        "shards would have stored.");
    add_files(*command, "SHARD", options->shards, "Results of `experiment run --shard`");
    add_file(*command, "-o,--output", options->output, "The file to write; it must not exist")->required();
    set_examples(*command, {"waybreaker experiment merge shard-*.db -o results.db"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

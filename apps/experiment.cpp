// `waybreaker experiment`: many missions, planned in many ways, from a spec to figures.
#include "experiment.hpp"

#include "commands.hpp"
#include "help.hpp"

namespace waybreaker::apps {

void setup_experiment(CLI::App& root, Run& run_chosen) {
    CLI::App* experiment = root.add_subcommand("experiment", "Run many missions and compare methods");
    experiment->require_subcommand(1);
    set_examples(*experiment, {"waybreaker experiment run paper.toml -o results.db",
                               "waybreaker experiment report results.db -o report"});
    setup_experiment_run(*experiment, run_chosen);
    setup_experiment_merge(*experiment, run_chosen);
    setup_experiment_export(*experiment, run_chosen);
    setup_experiment_report(*experiment, run_chosen);
}

}  // namespace waybreaker::apps

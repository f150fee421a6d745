// The commands below `waybreaker experiment`.
#pragma once

#include "commands.hpp"

namespace waybreaker::apps {

void setup_experiment_run(CLI::App& experiment, Run& run);
void setup_experiment_merge(CLI::App& experiment, Run& run);
void setup_experiment_export(CLI::App& experiment, Run& run);
void setup_experiment_report(CLI::App& experiment, Run& run);

}  // namespace waybreaker::apps

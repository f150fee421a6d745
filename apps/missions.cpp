// `waybreaker missions`: files that ask for plans, each kind a command of its own (missions_generate.cpp, ...).
#include "commands.hpp"
#include "help.hpp"

namespace waybreaker::apps {

void setup_missions(CLI::App& root, Run& run_chosen) {
    CLI::App* missions = root.add_subcommand("missions", "Make missions for experiments, and with many places");
    missions->require_subcommand(1);
    set_examples(*missions,
                 {"waybreaker missions generate data/berlin-mitte.tif -o berlin.scen",
                  "waybreaker missions access data/berlin-mitte.tif --from "
                  "data/berlin-mitte-hospital.geojson --to data/berlin-mitte-places.geojson -o access.json"});
    setup_missions_generate(*missions, run_chosen);
    setup_missions_access(*missions, run_chosen);
}

}  // namespace waybreaker::apps

// `waybreaker map`: what can be done with map files, each a command of its own (map_info.cpp, ...).
#include "commands.hpp"
#include "help.hpp"

namespace waybreaker::apps {

void setup_map(CLI::App& root, Run& run_chosen) {
    CLI::App* map = root.add_subcommand("map", "Inspect and convert map files");
    map->require_subcommand(1);
    set_examples(*map, {"waybreaker map info data/turin.tif", "waybreaker map convert data/turin.tif turin.map"});
    setup_map_info(*map, run_chosen);
    setup_map_convert(*map, run_chosen);
    setup_map_split(*map, run_chosen);
    setup_map_overlay(*map, run_chosen);
    setup_map_generate(*map, run_chosen);
}

}  // namespace waybreaker::apps

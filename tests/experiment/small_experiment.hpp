// A small experiment in a folder of its own: two maps, a few missions, all methods.
#pragma once

#include <string>

#include "experiment/experiment.hpp"
#include "experiment/results.hpp"
#include "experiment/run.hpp"
#include "experiment/store.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::experiment {

class SmallExperiment : public TemporaryFolder {
  protected:
    SmallExperiment() {
        put("street.map",
            "type octile\nheight 7\nwidth 12\nmap\n"
            "............\n"
            "...@@...@@..\n"
            "...@@...@@..\n"
            "...@@...@@..\n"
            "...@@...@@..\n"
            "...@@.......\n"
            "............\n");
        put("yard.map",
            "type octile\nheight 5\nwidth 7\nmap\n"
            ".......\n"
            "..@@@..\n"
            "..@.@..\n"
            "..@@@..\n"
            ".......\n");
        put("cities.scen",
            "version 1\n"
            "3\tstreet.map\t12\t7\t1\t3\t11\t3\t13\n"
            "3\tstreet.map\t12\t7\t0\t2\t6\t3\t9\n"
            "1\tyard.map\t7\t5\t0\t2\t6\t2\t8\n"
            "1\tyard.map\t7\t5\t0\t2\t3\t2\t3\n"  // no way without a removal
            "1\tyard.map\t7\t5\t0\t2\t4\t2\t3\n"  // ends in a wall
            "3\tstreet.map\t12\t7\t6\t1\t2\t2\t9\n");
        put("small.toml", spec);
        experiment = read_experiment(path("small.toml"));
    }

    static constexpr const char* spec =
        "name = 'small'\n"
        "missions = 'cities.scen'\n"
        "[[run]]\n"
        "methods = ['paper', 'none']\n"
        "weights = [1, 2]\n"
        "removals = [1, 2]\n"
        "[[run]]\n"
        "methods = ['exact', 'greedy']\n"
        "removals = [0, 1, 2]\n";

    RunProgress run_into(const std::string& name, RunOptions options = {}, Shard shard = {}) {
        Store store(path(name), experiment, shard, "1.2.3");
        return run(experiment, store, options);
    }
    std::string csv_of(const std::string& name) { return Results(path(name)).csv(false); }

    Experiment experiment;
};

}  // namespace waybreaker::experiment

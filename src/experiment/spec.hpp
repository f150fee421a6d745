// Spec: the content of an experiment's TOML file, before its scenario files are read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiment/experiment.hpp"

namespace waybreaker::experiment {

struct Spec {
    std::string name;
    std::vector<std::string> missions;  // files as written
    double time_limit = 60;
    std::vector<std::string> places;            // patterns of map names
    std::vector<Configuration> configurations;  // in the order of the file, each once
};

// Throws InputError with name and line: on what is no TOML, unknown keys, values out of range, and configurations that
// contradict themselves or stand there twice.
Spec parse_spec(std::string_view text, const std::string& name);

}  // namespace waybreaker::experiment

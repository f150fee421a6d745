// The commands of waybreaker: one file each, named as the command (`waybreaker map info` is map_info.cpp).
//
// A command's file holds an options struct, what to do with it, and setup_NAME(), which adds the command to the tree of
// options. Parsing only chooses what to run; main() runs it. Help, completion and manual pages are made from the tree.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>

namespace waybreaker::apps {

using Run = std::function<void()>;

void setup_plan(CLI::App& root, Run& run);
void setup_check(CLI::App& root, Run& run);
void setup_revise(CLI::App& root, Run& run);
void setup_rehearse(CLI::App& root, Run& run);
void setup_export(CLI::App& root, Run& run);
void setup_import(CLI::App& root, Run& run);
void setup_map(CLI::App& root, Run& run);
void setup_map_info(CLI::App& map, Run& run);
void setup_map_convert(CLI::App& map, Run& run);
void setup_map_split(CLI::App& map, Run& run);
void setup_map_overlay(CLI::App& map, Run& run);
void setup_map_generate(CLI::App& map, Run& run);
void setup_missions(CLI::App& root, Run& run);
void setup_missions_access(CLI::App& missions, Run& run);
void setup_missions_generate(CLI::App& missions, Run& run);
void setup_experiment(CLI::App& root, Run& run);
void setup_serve(CLI::App& root, Run& run);
void setup_site(CLI::App& root, Run& run);
void setup_help(CLI::App& root, Run& run);
void setup_completion(CLI::App& root, Run& run);
void setup_manual(CLI::App& root, Run& run);

// The input is valid, but there is no plan. Thrown when all output is written; what() is one line for a person.
class NoPlan : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The same, but there may be a plan: none was found.
class NoPlanFound : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// There is a plan, but it is not valid. Thrown when all output is written; what() is one line for a person.
class InvalidPlan : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// In a rehearsal something happened that no execution may have. Thrown when all output is written; what() is one line
// for a person.
class IllegalRun : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace waybreaker::apps

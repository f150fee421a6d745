// The planner that a page carries: of `waybreaker site`, and of --html with --steerable.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace waybreaker::apps {

// The WebAssembly of that file; without one, what is built in. Throws InputError where there is neither.
std::string page_planner(const std::string& file);

// Of commands with --html.
struct SteerableOptions {
    bool asked = false;
    std::string wasm = {};
};

// By gzip, as pages carry it.
std::string packed_page_planner(const SteerableOptions& options);

// --steerable and --wasm
void add_steerable(CLI::App& command, SteerableOptions& options);

}  // namespace waybreaker::apps

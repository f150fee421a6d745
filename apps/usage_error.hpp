// One helpful line about an error on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace waybreaker::apps {

// Precondition: root.parse() has just thrown `error`.
std::string usage_error(const CLI::App& root, const CLI::ParseError& error);

// Says that there is no such option or subcommand, and suggests a similar one.
std::string unexpected(const CLI::App& command, std::string given);

}  // namespace waybreaker::apps

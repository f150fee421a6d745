// What is wrong with a command line, in one helpful line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace waybreaker::apps {

// Precondition: root.parse() has just thrown `error`.
std::string usage_error(const CLI::App& root, const CLI::ParseError& error);

// That the command has no such option or command below it, and which may be meant.
std::string unexpected(const CLI::App& command, std::string given);

}  // namespace waybreaker::apps

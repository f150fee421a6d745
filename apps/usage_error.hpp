// One helpful line about an error on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace waybreaker::apps {

// Precondition of both: root.parse() has just thrown; usage_error: `error`.
std::string usage_error(const CLI::App& root, const CLI::ParseError& error);
// Throws InputError if a word stands where a command should, and is none: nobody can be helped with that one.
void refuse_unknown_command(const CLI::App& root);

// Says that there is no such option or subcommand, and suggests a similar one.
std::string unexpected(const CLI::App& command, std::string given);

}  // namespace waybreaker::apps

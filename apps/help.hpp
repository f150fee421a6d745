// Help in the usual layout: a summary, usage, options with wrapped texts, examples.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace waybreaker::apps {

class HelpFormatter : public CLI::FormatterBase {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

// Command lines for the end of the help; every command has some.
void set_examples(CLI::App& app, const std::vector<std::string>& examples);
std::vector<std::string> examples_of(const CLI::App& app);

// The commands of the tree, depth first, the root included, each with its name in full ("waybreaker map info").
struct NamedCommand {
    std::string name;
    const CLI::App* app;
};
std::vector<NamedCommand> all_commands(const CLI::App& root);

// What follows a command's name: "MAP [options]", "COMMAND".
std::string synopsis(const CLI::App& app);

// First line of a command's description.
std::string summary(const CLI::App& app);

// In the order they were added.
std::vector<const CLI::Option*> positionals_of(const CLI::App& app);
std::vector<const CLI::Option*> options_of(const CLI::App& app);

bool takes_value(const CLI::Option& option);
// Only behind "=".
bool may_take_value(const CLI::Option& option);

}  // namespace waybreaker::apps

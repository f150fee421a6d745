#include "help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace waybreaker::apps {
namespace {

constexpr std::size_t text_column = 26;
constexpr std::size_t line_width = 80;
const std::string examples_heading = "Examples:";

// The words of a text in lines; all but the first begin at the given column, where the first is already.
std::string wrapped(const std::string& text, std::size_t column) {
    std::istringstream words(text);
    std::string out;
    std::size_t at = column;
    for (std::string word; words >> word;) {
        if (at > column && at + 1 + word.size() > line_width) {
            out += "\n" + std::string(column, ' ');
            at = column;
        } else if (at > column) {
            out += " ";
            ++at;
        }
        out += word;
        at += word.size();
    }
    return out;
}

// The name in the left column, the text in the right one.
std::string entry(const std::string& name, const std::string& text) {
    const bool fits = name.size() + 4 <= text_column;
    return fmt::format("  {:<{}}{}{}\n", name, fits ? text_column - 2 : 0,
                       fits ? "" : "\n" + std::string(text_column, ' '), wrapped(text, text_column));
}

std::string option_entry(const CLI::Option& option) {
    std::string names = CLI::detail::find_and_replace(option.get_name(false, true), ",", ", ");
    if (names.starts_with("--")) names = "    " + names;  // in line with those that have a short name
    if (takes_value(option)) names += " " + option.get_type_name();
    if (may_take_value(option)) names += fmt::format("[={}]", option.get_type_name());
    return entry(names, option.get_description() + (option.get_required() ? " (required)" : ""));
}

}  // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const {
    std::string help;
    std::istringstream paragraphs(app->get_description());
    for (std::string paragraph; std::getline(paragraphs, paragraph);) help += wrapped(paragraph, 0) + "\n";
    help += fmt::format("\nUsage: {} {}\n", name, synopsis(*app));
    if (const auto commands = app->get_subcommands({}); !commands.empty()) {
        help += "\nCommands:\n";
        for (const CLI::App* command : commands) help += entry(command->get_name(), summary(*command));
    }
    if (const auto positionals = positionals_of(*app); !positionals.empty()) {
        help += "\nArguments:\n";
        for (const CLI::Option* option : positionals) {
            help += entry(option->get_name(true, false), option->get_description());
        }
    }
    std::string group;
    for (const CLI::Option* option : options_of(*app)) {
        if (option->get_group() != group) help += fmt::format("\n{}:\n", option->get_group());
        group = option->get_group();
        help += option_entry(*option);
    }
    return help + fmt::format("\n{}\n", app->get_footer());
}

void set_examples(CLI::App& app, const std::vector<std::string>& examples) {
    app.footer(fmt::format("{}\n  {}", examples_heading, fmt::join(examples, "\n  ")));
}

std::vector<std::string> examples_of(const CLI::App& app) {
    std::istringstream lines(app.get_footer());
    std::vector<std::string> examples;
    for (std::string line; std::getline(lines, line);) {
        if (line != examples_heading) examples.push_back(line.substr(2));
    }
    return examples;
}

std::vector<NamedCommand> all_commands(const CLI::App& root) {
    std::vector<NamedCommand> commands{{root.get_name(), &root}};
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const NamedCommand parent = commands[i];
        for (const CLI::App* child : parent.app->get_subcommands({})) {
            commands.push_back({parent.name + " " + child->get_name(), child});
        }
    }
    return commands;
}

std::string synopsis(const CLI::App& app) {
    if (!app.get_subcommands({}).empty()) return "COMMAND";
    std::string line;
    for (const CLI::Option* positional : positionals_of(app)) {
        line += positional->get_name(true, false) + (positional->get_expected_max() > 1 ? "... " : " ");
    }
    for (const CLI::Option* option : options_of(app)) {
        if (!option->get_required()) continue;
        const std::string short_name = option->get_snames().empty() ? "" : "-" + option->get_snames().front();
        line += fmt::format("{} {} ", short_name.empty() ? "--" + option->get_single_name() : short_name,
                            option->get_type_name());
    }
    return line + "[options]";
}

std::string summary(const CLI::App& app) {
    const std::string description = app.get_description();
    return description.substr(0, description.find('\n'));
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
    return app.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

bool takes_value(const CLI::Option& option) {
    return option.get_expected_max() > 0;
}

bool may_take_value(const CLI::Option& option) {
    return !takes_value(option) && !option.get_type_name().empty();
}

}  // namespace waybreaker::apps

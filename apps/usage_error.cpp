#include "usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "help.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

// How many letters to insert, drop or exchange to get from one word to the other (Levenshtein).
std::size_t edits(const std::string& from, const std::string& to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : from) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t exchanged = diagonal + (letter == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

// "; did you mean --goal?", if there is a word like that.
std::string suggestion(const std::string& given, const std::vector<std::string>& words) {
    const auto closer = [&](const std::string& a, const std::string& b) { return edits(given, a) < edits(given, b); };
    const auto closest = std::min_element(words.begin(), words.end(), closer);
    if (closest == words.end() || edits(given, *closest) > 2) return "";
    return fmt::format("; did you mean {}?", *closest);
}

// The command that the arguments belong to.
NamedCommand chosen(const CLI::App& root) {
    NamedCommand command{root.get_name(), &root};
    while (!command.app->get_subcommands().empty()) {
        command.app = command.app->get_subcommands().back();
        command.name += " " + command.app->get_name();
    }
    return command;
}

}  // namespace

std::string unexpected(const CLI::App& command, std::string given) {
    given = shown(given);
    std::vector<std::string> words;
    if (given.starts_with("-")) {
        given = given.substr(0, given.find('='));
        for (const CLI::Option* option : options_of(command)) words.push_back("--" + option->get_single_name());
        return fmt::format("unknown option {}{}", given, suggestion(given, words));
    }
    for (const CLI::App* child : command.get_subcommands({})) words.push_back(child->get_name());
    if (words.empty()) return fmt::format("unexpected argument '{}'", given);
    return fmt::format("unknown command '{}'{}", given, suggestion(given, words));
}

std::string usage_error(const CLI::App& root, const CLI::ParseError& error) {
    const auto [name, command] = chosen(root);
    if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) return error.what();
    const std::vector<std::string> rest = root.remaining(true);
    std::string message = error.what();
    if (const std::size_t many = message.find(": At Most 1 required but received "); many != message.npos)
        message = message.substr(0, many) + " is given more than once";
    if (!rest.empty()) {
        message = unexpected(*command, rest.front());
    } else if (!command->get_subcommands({}).empty()) {
        message = "a command is missing";
    }
    return fmt::format("{} (see {} --help)", message, name);
}

void refuse_unknown_command(const CLI::App& root) {
    const auto [name, command] = chosen(root);
    if (command->get_subcommands({}).empty()) return;
    for (const std::string& word : root.remaining(true)) {
        if (word.starts_with("-")) continue;
        throw InputError(fmt::format("{} (see {} --help)", unexpected(*command, word), name));
    }
}

}  // namespace waybreaker::apps

// `waybreaker completion`: scripts that complete commands, options and their values, made from the tree of options.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "option.hpp"

namespace waybreaker::apps {
namespace {

std::vector<std::string> names_of(const CLI::Option& option) {
    return CLI::detail::split(option.get_name(false, true), ',');
}

bool takes_file(const CLI::Option& option) {
    return option.get_positional() ? words_of(option).empty() : option.get_type_name() == "FILE";
}

std::vector<std::string> children_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* child : app.get_subcommands({})) names.push_back(child->get_name());
    return names;
}

// What can stand first in a command's arguments: its commands, or the words of its positional.
std::vector<std::string> first_words(const CLI::App& app) {
    std::vector<std::string> words = children_of(app);
    for (const CLI::Option* positional : positionals_of(app)) {
        for (const std::string& word : words_of(*positional)) words.push_back(word);
    }
    return words;
}

// One function: walk the words to the command in hand, then offer an option's values, options, or first words; where
// it offers nothing, bash completes file names.
std::string bash(const std::vector<NamedCommand>& commands) {
    std::string paths;
    std::string values;
    std::string words;
    for (const NamedCommand& command : commands) {
        for (const std::string& child : children_of(*command.app)) {
            paths += fmt::format("{}\"{} {}\"", paths.empty() ? "" : " | ", command.name, child);
        }
        std::vector<std::string> options;
        for (const CLI::Option* option : options_of(*command.app)) {
            for (const std::string& name : names_of(*option)) {
                options.push_back(name);
                if (!takes_value(*option) || takes_file(*option)) continue;
                values += fmt::format("    \"{} {}\") _waybreaker_offer \"{}\" \"$current\"; return ;;\n", command.name,
                                      name, fmt::join(words_of(*option), " "));
            }
        }
        words += fmt::format("    \"{}\") options=\"{}\" words=\"{}\" ;;\n", command.name, fmt::join(options, " "),
                             fmt::join(first_words(*command.app), " "));
    }
    return fmt::format(R"(# bash completion for waybreaker; made by `waybreaker completion bash`
_waybreaker_offer() {{
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}}
_waybreaker() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} path=waybreaker
    local word options words
    COMPREPLY=()
    # --option=value comes as three words
    if [[ $current == "=" ]]; then
        current=
    elif [[ $previous == "=" ]]; then
        previous=${{COMP_WORDS[COMP_CWORD - 2]}}
    fi
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case "$path $word" in
        {paths}) path+=" $word" ;;
        esac
    done
    case "$path $previous" in
{values}    esac
    case "$path" in
{words}    esac
    if [[ $current == -* ]]; then words=$options; fi
    _waybreaker_offer "$words" "$current"
}}
complete -o default -F _waybreaker waybreaker
)",
                       fmt::arg("paths", paths), fmt::arg("values", values), fmt::arg("words", words));
}

// Text inside single quotes.
std::string quoted(const std::string& text) {
    return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'";
}

std::string zsh_option(const CLI::Option& option) {
    // Brackets and colons have a meaning in specifications.
    std::string text = CLI::detail::find_and_replace(option.get_description(), ":", "\\:");
    text = CLI::detail::find_and_replace(CLI::detail::find_and_replace(text, "[", "\\["), "]", "\\]");
    std::string action;
    if (takes_file(option)) action = "_files";
    if (const auto words = words_of(option); !words.empty()) action = fmt::format("({})", fmt::join(words, " "));
    if (option.get_positional()) {
        const std::string place = option.get_expected_max() > 1 ? "*" : "1";
        return " \\\n    " + quoted(fmt::format("{}:{}:{}", place, option.get_name(true, false), action));
    }
    const std::string what = words_of(option).empty() ? option.get_type_name() : "value";
    std::string value = takes_value(option) ? fmt::format(":{}:{}", what, action) : "";
    if (may_take_value(option)) value = fmt::format("::{}:{}", what, action);
    std::string out;
    for (const std::string& name : names_of(option)) {
        const bool joined = takes_value(option) && name.starts_with("--");
        const char* const sign = joined ? "=" : may_take_value(option) ? "=-" : "";
        out += " \\\n    " + quoted(fmt::format("{}{}[{}]{}", name, sign, text, value));
    }
    return out;
}

// One function for each command, as _arguments wants it.
std::string zsh(const std::vector<NamedCommand>& commands) {
    std::string out = "#compdef waybreaker\n# zsh completion for waybreaker; made by `waybreaker completion zsh`\n";
    for (const NamedCommand& command : commands) {
        const std::string function = "_" + CLI::detail::find_and_replace(command.name, " ", "_");
        std::string arguments;
        for (const CLI::Option* option : positionals_of(*command.app)) arguments += zsh_option(*option);
        for (const CLI::Option* option : options_of(*command.app)) arguments += zsh_option(*option);
        const auto children = command.app->get_subcommands({});
        if (children.empty()) {
            out += fmt::format("\n{}() {{\n  _arguments{}\n}}\n", function, arguments);
            continue;
        }
        std::string described;
        for (const CLI::App* child : children) {
            described += " " + quoted(fmt::format("{}:{}", child->get_name(), summary(*child)));
        }
        out += fmt::format(R"(
{function}() {{
  local curcontext=$curcontext state line
  local -a commands=({described})
  _arguments -C{arguments} \
    '1: :->command' '*:: :->rest'
  case $state in
    command) _describe command commands ;;
    rest) (( $+functions[{function}_$line[1]] )) && {function}_$line[1] ;;
  esac
}}
)",
                           fmt::arg("function", function), fmt::arg("described", described),
                           fmt::arg("arguments", arguments));
    }
    return out +
           "\nif [[ $funcstack[1] == _waybreaker ]]; then\n  _waybreaker \"$@\"\nelse\n  compdef _waybreaker "
           "waybreaker\nfi\n";
}

// Fish asks for each line whether it applies: all words of the command seen, none of its commands'.
std::string fish_condition(const NamedCommand& command) {
    std::vector<std::string> conditions;
    const std::vector<std::string> words = CLI::detail::split(command.name, ' ');
    for (std::size_t i = 1; i < words.size(); ++i) conditions.push_back("__fish_seen_subcommand_from " + words[i]);
    if (const auto children = children_of(*command.app); !children.empty()) {
        conditions.push_back(fmt::format("not __fish_seen_subcommand_from {}", fmt::join(children, " ")));
    }
    return quoted(fmt::format("{}", fmt::join(conditions, "; and ")));
}

std::string fish(const std::vector<NamedCommand>& commands) {
    std::string out = "# fish completion for waybreaker; made by `waybreaker completion fish`\n";
    for (const NamedCommand& command : commands) {
        const std::string start = "complete -c waybreaker -n " + fish_condition(command);
        for (const CLI::App* child : command.app->get_subcommands({})) {
            out += fmt::format("{} -f -a {} -d {}\n", start, child->get_name(), quoted(summary(*child)));
        }
        for (const CLI::Option* positional : positionals_of(*command.app)) {
            if (const auto words = words_of(*positional); !words.empty()) {
                out += fmt::format("{} -f -a {}\n", start, quoted(fmt::format("{}", fmt::join(words, " "))));
            }
        }
        for (const CLI::Option* option : options_of(*command.app)) {
            out += start;
            for (const std::string& name : option->get_snames()) out += " -s " + name;
            for (const std::string& name : option->get_lnames()) out += " -l " + name;
            if (takes_file(*option))
                out += " -r -F";
            else if (takes_value(*option))
                out += " -x";
            if (const auto words = words_of(*option); !words.empty()) {
                out += " -a " + quoted(fmt::format("{}", fmt::join(words, " ")));
            }
            out += " -d " + quoted(option->get_description()) + "\n";
        }
    }
    return out;
}

using Script = std::string (*)(const std::vector<NamedCommand>&);

}  // namespace

void setup_completion(CLI::App& root, Run& run_chosen) {
    CLI::App* command = root.add_subcommand("completion",
                                            "Write a script that completes commands and options in your shell\n\n"
                                            "The script is the same for every user; packages install it for all.");
    auto script = std::make_shared<Script>(bash);
    add_choice<Script>(*command, "SHELL", {{"bash", bash}, {"zsh", zsh}, {"fish", fish}}, *script,
                       "Your shell: bash, zsh or fish")
        ->required();
    set_examples(*command, {"source <(waybreaker completion bash)",
                            "waybreaker completion fish > ~/.config/fish/completions/waybreaker.fish"});
    command->callback([&root, script, &run_chosen] {
        run_chosen = [&root, script] { io::write_whole("-", (*script)(all_commands(root))); };
    });
}

}  // namespace waybreaker::apps

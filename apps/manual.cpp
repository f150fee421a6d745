// `waybreaker manual`: the manual pages, made from the tree of options.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

// Text that roff prints as it is.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
            out += std::string("\\&") + c;
        else
            out += c;
    }
    return out;
}

std::string bold(const std::string& text) {
    return "\\fB" + plain(text) + "\\fR";
}

// What is to be replaced is set in italics, words to type in bold.
std::string argument(const CLI::Option& option) {
    if (may_take_value(option)) return fmt::format("[=\\fI{}\\fR]", plain(option.get_type_name()));
    if (!takes_value(option) || option.get_type_name().empty()) return "";
    const bool words = !words_of(option).empty();
    return fmt::format(" \\f{}{}\\fR", words ? "B" : "I", plain(option.get_type_name()));
}

std::string option_item(const CLI::Option& option) {
    std::string names;
    if (option.get_positional()) {
        names = "\\fI" + plain(option.get_name(true, false)) + "\\fR";
    } else {
        for (const std::string& name : CLI::detail::split(option.get_name(false, true), ',')) {
            names += (names.empty() ? "" : ", ") + bold(name);
        }
    }
    return fmt::format(".TP\n{}{}\n{}\n", names, argument(option), plain(option.get_description()));
}

std::string options(const CLI::App& app) {
    std::string out;
    for (const CLI::Option* option : positionals_of(app)) out += option_item(*option);
    std::string group = "Options";
    for (const CLI::Option* option : options_of(app)) {
        if (option->get_group() != group) out += fmt::format(".SS {}\n", plain(option->get_group()));
        group = option->get_group();
        out += option_item(*option);
    }
    return out;
}

std::string description(const CLI::App& app) {
    std::string out;
    std::istringstream lines(app.get_description());
    for (std::string line; std::getline(lines, line);) out += line.empty() ? ".PP\n" : plain(line) + "\n";
    return out;
}

std::string page_name(const std::string& command) {
    return CLI::detail::find_and_replace(command, " ", "-");
}

const char* const exit_status =
    ".TP\n0\nDone.\n"
    ".TP\n1\nThe input is valid, but no plan exists, or the plan to check is not valid.\n"
    ".TP\n2\nBad usage or bad input; the message names the file and line, or the option.\n"
    ".TP\n3\nInternal error.\n"
    ".TP\n4\nNo plan was found, though there may be one.\n";

std::string page(const NamedCommand& command, const std::vector<NamedCommand>& all, const std::string& version) {
    const std::string name = page_name(command.name);
    std::string upper = name;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    std::string out = fmt::format(".TH {} 1 \"\" \"{}\"\n", upper, version);
    out += fmt::format(".SH NAME\n{} \\- {}\n", plain(name), plain(summary(*command.app)));
    out += fmt::format(".SH SYNOPSIS\n{} {}\n", bold(command.name), plain(synopsis(*command.app)));
    out += fmt::format(".SH DESCRIPTION\n{}", description(*command.app));
    if (const auto children = command.app->get_subcommands({}); !children.empty()) {
        out += ".SH COMMANDS\n";
        for (const CLI::App* child : children) {
            out += fmt::format(".TP\n{}\n{}\n", bold(child->get_name()), plain(summary(*child)));
        }
    }
    out += fmt::format(".SH OPTIONS\n{}", options(*command.app));
    out += ".SH EXAMPLES\n.EX\n";
    for (const std::string& example : examples_of(*command.app)) out += plain(example) + "\n";
    out += fmt::format(".EE\n.SH EXIT STATUS\n{}.SH SEE ALSO\n", exit_status);
    std::string also;
    for (const NamedCommand& other : all) {
        if (other.name != command.name)
            also += fmt::format("{}{}(1)", also.empty() ? "" : ",\n", bold(page_name(other.name)));
    }
    return out + also + "\n";
}

void run(const CLI::App& root, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder, 0, "cannot make this folder: " + error.message());
    const std::vector<NamedCommand> commands = all_commands(root);
    for (const NamedCommand& command : commands) {
        io::write_whole(fmt::format("{}/{}.1", folder, page_name(command.name)),
                        page(command, commands, root.version()));
    }
}

}  // namespace

void setup_manual(CLI::App& root, Run& run_chosen) {
    auto folder = std::make_shared<std::string>();
    CLI::App* command =
        root.add_subcommand("manual", "Write the manual pages, one file for each command, into a folder");
    add_file(*command, "FOLDER", *folder, "Where to write them")->required();
    set_examples(*command, {"waybreaker manual man && man -l man/waybreaker-plan.1"});
    command->callback([&root, folder, &run_chosen] { run_chosen = [&root, folder] { run(root, *folder); }; });
}

}  // namespace waybreaker::apps

// `waybreaker help`: what COMMAND --help says.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "usage_error.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

void run(const CLI::App& root, const std::vector<std::string>& words) {
    const CLI::App* command = &root;
    std::string parent;
    for (const std::string& word : words) {
        parent += (parent.empty() ? "" : " ") + command->get_name();
        const auto children = command->get_subcommands({});
        const auto child = std::ranges::find(children, word, &CLI::App::get_name);
        if (child == children.end()) {
            throw InputError(fmt::format("{} (see {} --help)", unexpected(*command, word), parent));
        }
        command = *child;
    }
    io::write_whole("-", command->get_formatter()->make_help(
                             command, parent.empty() ? command->get_name() : parent + " " + command->get_name(),
                             CLI::AppFormatMode::Normal));
}

}  // namespace

void setup_help(CLI::App& root, Run& run_chosen) {
    auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* command = root.add_subcommand("help", "Explain a command, as COMMAND --help does");
    command->add_option("COMMAND", *words, "A command, such as plan or map info")->type_name("");
    set_examples(*command, {"waybreaker help plan", "waybreaker help map info"});
    command->callback([&root, words, &run_chosen] { run_chosen = [&root, words] { run(root, *words); }; });
}

}  // namespace waybreaker::apps

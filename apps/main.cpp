// waybreaker: the command line. Builds the tree of commands, runs the chosen one, turns errors into one line and an
// exit status (contract: 0 done, 1 no plan or no valid one, 2 bad usage or input, 3 internal error or an illegal run of
// a rehearsal, 4 no plan found).
#include <fcntl.h>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <string>
#include <string_view>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "service/import_worker.hpp"
#include "usage_error.hpp"
#include "version.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

enum ExitStatus : int { done = 0, no_plan = 1, bad_input = 2, internal_error = 3, illegal_run = 3, no_plan_found = 4 };

int complain(ExitStatus status, std::string message) {
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';  // one line, whatever a file name contains
    }
    std::fputs(fmt::format("waybreaker: {}\n", message).c_str(),
               stderr);  // if that fails, there is nowhere to report it
    return status;
}

// Options as the command spells them.
std::string worded(const InputError& error) {
    return error.error().code == ErrorCode::option ? fmt::format("--{}", error.what()) : error.what();
}

void setup(CLI::App& root, Run& run) {
    root.name("waybreaker");
    root.formatter(std::make_shared<HelpFormatter>());
    root.set_version_flag("-V,--version", "waybreaker " + version(), "Print the version and exit");
    root.set_help_flag("-h,--help", "Print this help and exit");
    root.require_subcommand(1);
    setup_plan(root, run);
    setup_check(root, run);
    setup_revise(root, run);
    setup_rehearse(root, run);
    setup_export(root, run);
    setup_import(root, run);
    setup_map(root, run);
    setup_missions(root, run);
    setup_experiment(root, run);
    setup_serve(root, run);
    setup_site(root, run);
    setup_help(root, run);
    setup_completion(root, run);
    setup_manual(root, run);
    set_examples(root, {"waybreaker plan data/berlin-adlershof.tif --start 130,104 --goal 466,105 --svg plan.svg",
                        "waybreaker plan --help"});
}

void parse_and_run(int argc, const char* const* argv) {
    CLI::App root{"Plan ground missions whose way an aircraft can open"};
    Run run;
    setup(root, run);
    try {
        root.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        refuse_unknown_command(root);
        return io::write_whole("-", root.help());
    } catch (const CLI::CallForVersion& version) {
        refuse_unknown_command(root);
        return io::write_whole("-", std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& error) {
        throw InputError(usage_error(root, error));
    }
    run();
}

// Opens closed standard descriptors on /dev/null, so that no file of ours becomes standard output by chance; writing
// there fails.
void fill_standard_streams() {
    for (int stream = 0; stream <= 2; ++stream) {
        if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDONLY);
    }
}

// What `serve` starts for each import: no command for people.
bool is_import_worker(int argc, const char* const* argv) {
    return argc == 4 && std::string_view(argv[1]) == service::import_worker_word;
}

}  // namespace
}  // namespace waybreaker::apps

int main(int argc, char** argv) {
    using namespace waybreaker::apps;
    fill_standard_streams();
    std::signal(SIGPIPE, SIG_DFL);  // when our reader leaves (`| head`) we end quietly, as other commands do
    try {
        if (is_import_worker(argc, argv)) return waybreaker::service::run_import_worker(argv[2], argv[3]);
        parse_and_run(argc, argv);
        return done;
    } catch (const NoPlan& error) {
        return complain(no_plan, error.what());
    } catch (const NoPlanFound& error) {
        return complain(no_plan_found, error.what());
    } catch (const InvalidPlan& error) {
        return complain(no_plan, error.what());
    } catch (const IllegalRun& error) {
        return complain(illegal_run, error.what());
    } catch (const waybreaker::InputError& error) {
        return complain(bad_input, worded(error));
    } catch (const std::bad_alloc&) {
        return complain(internal_error, "out of memory");
    } catch (const std::exception& error) {
        return complain(internal_error, fmt::format("internal error: {}", error.what()));
    }
}

// `waybreaker experiment run`: plans the missions of an experiment that have no result yet.
#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <cstdlib>

#include "experiment.hpp"
#include "experiment/run.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "progress.hpp"
#include "version.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

constexpr std::int64_t most_shards = 1'000'000;

struct ExperimentRunOptions {
    std::string spec;
    std::string output;
    unsigned threads = 0;
    experiment::Shard shard;
};

// The signal that asked us to end, 0 if none did: a handler can only set a flag.
volatile std::sig_atomic_t asked_to_end = 0;

// On the first signal (Ctrl-C, a batch system's time limit) a run stores what it has; on the second it ends at once.
void heed_requests_to_end() {
    struct sigaction action {};
    action.sa_handler = [](int signal) { asked_to_end = signal; };
    action.sa_flags = int(SA_RESETHAND | SA_RESTART);
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

std::string duration(double seconds) {
    if (seconds < 60) return fmt::format("{:.0f} s", seconds);
    const int minutes = int(seconds / 60);
    return minutes < 60 ? fmt::format("{} min", minutes) : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

// One line that is overwritten, for a person who watches.
void show(const experiment::RunProgress& progress) {
    const std::size_t now = progress.stored - progress.begun_with;
    const std::string left =
        now == 0 ? ""
                 : ", " + duration(progress.seconds / double(now) * double(progress.jobs - progress.stored)) + " left";
    const std::string unsolved = progress.unsolved == 0 ? "" : fmt::format(", {} unsolved", progress.unsolved);
    fmt::print(stderr, "\r\033[K{} of {} results{}{}", progress.stored, progress.jobs, unsolved, left);
}

std::string run_summary(const std::string& file, const experiment::RunProgress& progress) {
    std::string text = fmt::format("{}: {} of {} results", file, progress.stored, progress.jobs);
    if (progress.begun_with > 0) text += fmt::format(", {} of them from before", progress.begun_with);
    if (progress.unsolved > 0) text += fmt::format("; {} timed out, failed or crashed", progress.unsolved);
    text += '\n';
    if (progress.stored > progress.begun_with) {
        text += fmt::format("{:.1f} s on {} threads, {:.1f} % of it planning\n", progress.seconds, progress.threads,
                            100 * progress.planning / (progress.seconds * progress.threads));
    }
    return text;
}

experiment::Experiment read(const std::string& spec) {
    const Progress progress("reading " + spec);
    return experiment::read_experiment(spec);
}

void run(const ExperimentRunOptions& options) {
    require_ending("--output", options.output, {".db"}, "; waybreaker experiment export writes CSV");
    const experiment::Experiment experiment = read(options.spec);
    experiment::Store store(options.output, experiment, options.shard, version());
    heed_requests_to_end();
    StopSource stop;
    const bool watched = isatty(STDERR_FILENO) == 1;
    const auto on_progress = [&](const experiment::RunProgress& progress) {
        if (watched) show(progress);
        if (asked_to_end != 0) stop.request_stop();
    };
    const experiment::RunProgress progress = experiment::run(
        experiment, store,
        {.threads = options.threads, .stop = stop.get_token(), .progress = on_progress, .evaluators = {}});
    if (watched) fmt::print(stderr, "\r\033[K");
    io::write_whole("-", run_summary(options.output, progress));
    if (asked_to_end != 0 && progress.stored < progress.jobs) {
        // Shells and batch systems expect a program to die of the signal that ended it.
        std::signal(asked_to_end, SIG_DFL);
        std::raise(asked_to_end);
    }
}

std::optional<std::uint32_t> positive(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == 0 || value > most_shards) return {};
    return value;
}

// Of an array job; counted from the array's least number.
experiment::Shard shard_of_slurm() {
    const auto variable = [](const char* name) {
        const char* text = std::getenv(name);
        return std::string_view(text == nullptr ? "" : text);
    };
    const auto count = positive(variable("SLURM_ARRAY_TASK_COUNT"));
    const auto offset = variable("SLURM_ARRAY_TASK_MIN") == "0" ? 0U : positive(variable("SLURM_ARRAY_TASK_MIN"));
    const auto id = variable("SLURM_ARRAY_TASK_ID") == "0" ? 0U : positive(variable("SLURM_ARRAY_TASK_ID"));
    if (!count || !offset || !id || *id < *offset || *id - *offset >= *count) {
        throw CLI::ValidationError("--shard",
                                   "slurm: SLURM_ARRAY_TASK_ID, _MIN and _COUNT do not say which of how many this is: "
                                   "is it an array job, of numbers in a row?");
    }
    return {*id - *offset + 1, *count};
}

experiment::Shard shard_of(const std::string& given) {
    if (given == "slurm") return shard_of_slurm();
    const std::size_t slash = std::min(given.find('/'), given.size());
    const auto index = positive(given.substr(0, slash));
    const auto count = positive(std::string_view(given).substr(std::min(slash + 1, given.size())));
    if (!index || !count || *index > *count) {
        throw CLI::ValidationError(
            "--shard", fmt::format("'{}' is not a shard: I/N is one of N parts, such as 1/8; or slurm", given));
    }
    return {*index, *count};
}

}  // namespace

void setup_experiment_run(CLI::App& experiment, Run& run_chosen) {
    auto options = std::make_shared<ExperimentRunOptions>();
    CLI::App* command = experiment.add_subcommand(
        "run",
        "Plan the missions of an experiment, or go on where a run has ended\n\n"
        "A spec names scenario files and says which methods plan their missions, with how many removals. Results go to "
        "an SQLite file. However a run ends, the same command goes on with what is missing; a mission that fails, "
        "crashes or takes too long is a result as well. The number of threads and shards makes no difference to the "
        "results.");
    add_file(*command, "SPEC", options->spec, "What to run, in TOML")->required();
    add_file(*command, "-o,--output", options->output, "The results; a new file, or one to go on with")->required();
    add_count(
        *command, "--threads", [options](auto n) { options->threads = unsigned(n); }, 1, 1024,
        "How many missions to plan at a time (default: one on each core)");
    command
        ->add_option_function<std::string>(
            "--shard", [options](const std::string& given) { options->shard = shard_of(given); },
            "Run only one of N parts; `slurm` takes the number of the array task")
        ->type_name("I/N");
    set_examples(*command, {"waybreaker experiment run data/paper-maps/paper.toml -o results.db",
                            "waybreaker experiment run paper.toml --shard 3/8 -o shard-3.db"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

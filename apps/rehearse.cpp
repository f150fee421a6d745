// `waybreaker rehearse`: a plan played many times, with failures and delays that are drawn.
#include "waybreaker/rehearse.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "draw_options.hpp"
#include "help.hpp"
#include "io/check_report.hpp"
#include "io/output_file.hpp"
#include "io/plan_file.hpp"
#include "io/sha256.hpp"
#include "mapfile/map_reader.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "progress.hpp"
#include "rehearse_report.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct RehearseOptions {
    std::string map;
    std::string plan;
    std::string compare;
    std::string json;
    std::string csv;
    std::string svg;
    OverlayOptions overlays;
    RehearsalOptions rehearsal;
    double seconds = 10;
    bool no_timing = false;
};

RehearsedPlan rehearsed(const RehearseOptions& options, const io::PlanFile& file, const std::string& name,
                        const io::MapFile& base) {
    io::require_map_of(file, base, name);
    io::MapFile map = io::known_map(base, file.plan);
    if (const auto weighed = io::reweighed(file, map, {})) map.map = *weighed;
    Progress progress("rehearsing " + name);
    RehearsalOptions asked = options.rehearsal;
    asked.progress = [&](int done) { progress.update(fmt::format("{} of {} runs", done, asked.runs)); };
    try {
        const Mission& mission = file.asked.mission;
        return {name,
                rehearse(map.map, mission, file.plan, asked, method_of_revisions(file.asked.method),
                         {.seconds = options.seconds, .threads = 1}),
                mission.rules.objective, mission.rules.unreached.has_value()};
    } catch (const InputError& error) {
        throw InputError(name, 0, error.what());
    }
}

void run(const RehearseOptions& options) {
    const std::vector<site::OverlaySource> overlays = overlays_of(options.overlays);
    NamedFiles inputs{{"MAP", options.map}, {"PLAN", options.plan}, {"--compare", options.compare}};
    for (const site::OverlaySource& overlay : overlays) inputs.emplace_back("--also", overlay.file);
    validate_inputs(inputs);
    const NamedFiles outputs{{"--json", options.json}, {"--csv", options.csv}, {"--svg", options.svg}};
    validate_outputs(outputs, inputs);
    std::vector<std::pair<std::string, io::PlanFile>> files;
    files.emplace_back(io::input_name(options.plan), io::read_plan_file(options.plan));
    if (!options.compare.empty())
        files.emplace_back(io::input_name(options.compare), io::read_plan_file(options.compare));
    const io::PlanFile& first = files.front().second;
    const io::MapFile map = [&] {
        const Progress progress("reading " + io::input_name(options.map));
        return to_plan_on(overlays, mapfile::read_map_file(options.map, first.connectivity, first.image));
    }();
    RehearsalReport report{
        .options = options.rehearsal, .time_unit = first.asked.in_seconds ? "s" : "", .timing = !options.no_timing};
    for (const auto& [name, file] : files) {
        if (file.connectivity != first.connectivity)
            throw InputError(name, 0, "was made for other obstacles than " + files.front().first + ": --connectivity");
        report.plans.push_back(rehearsed(options, file, name, map));
    }
    bool to_standard_output = false;
    const auto write = [&](const std::string& path, std::string (*content)(const RehearsalReport&)) {
        if (path.empty()) return;
        to_standard_output = to_standard_output || path == "-";
        io::write_whole(path, content(report));
    };
    write(options.json, rehearsal_json);
    write(options.csv, rehearsal_csv);
    write(options.svg, rehearsal_svg);
    if (!to_standard_output) io::write_whole("-", rehearsal_table(report, isatty(STDOUT_FILENO) == 1));
    for (const RehearsedPlan& plan : report.plans) {
        if (plan.rehearsal.illegal == 0) continue;
        const auto& runs = plan.rehearsal.runs;
        const auto illegal = std::ranges::find_if(runs, [](const Rehearsed& run) { return run.illegal > 0; });
        throw IllegalRun(fmt::format("{}: {} of {} runs illegal; in run {}: {}", plan.name, plan.rehearsal.illegal,
                                     runs.size(), illegal - runs.begin(), illegal->fault));
    }
}

}  // namespace

void setup_rehearse(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<RehearseOptions>();
    CLI::App* command = root.add_subcommand(
        "rehearse",
        "Play a plan many times, with failures and delays that are drawn\n\n"
        "Agents keep to the plan's orders: each goes on as early as they allow, however late the others are. When a "
        "breach fails, a street is blocked or an aircraft is lost, all agents stop or turn at once, the rest of the "
        "mission is planned anew, as waybreaker revise does, and they go on with that. The report says how long "
        "missions take, how many end with all vehicles at their goals, and why others do not. It also counts runs in "
        "which vehicles overlap or are in an obstacle that stands: if there are any, the exit status is 3.");
    add_file(*command, "MAP", options->map, "The map the plan was made for")->required();
    add_file(*command, "PLAN", options->plan, "A plan file, as waybreaker plan or revise writes it")->required();
    add_draws(*command, options->rehearsal);
    add_count(
        *command, "--threads", [options](auto n) { options->rehearsal.threads = unsigned(n); }, 1, 1024,
        "How many threads play; the result is the same (default: one on each core)");
    add_file(*command, "--compare", options->compare, "Play that plan as well, on the same draws");
    add_file(*command, "--json", options->json, "Write the figures (waybreaker-rehearsal/1); - is standard output");
    add_file(*command, "--csv", options->csv, "Write a line for each run");
    add_file(*command, "--svg", options->svg, "Draw how the makespans are distributed");
    add_number(
        *command, "--time-limit", [options](double seconds) { options->seconds = seconds; }, {1e-3, 1e6}, "SECONDS",
        "Plan each revision for at most so long; a limit that ends one can make runs differ (default: 10)");
    command->add_flag("--no-timing", options->no_timing, "Leave measured times out, so that bytes repeat");
    add_overlay_options(*command, options->overlays);
    set_examples(*command, {"waybreaker rehearse data/berlin-mitte.tif plan.json --fail 10% --delay exponential:2s "
                            "--runs 10000 --seed 1",
                            "waybreaker rehearse data/berlin-mitte.tif plan.json --fail 10% --compare other.json --svg "
                            "makespans.svg"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

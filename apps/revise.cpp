// `waybreaker revise`: the rest of a mission planned anew, from what has happened to its plan.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "io/plan_file.hpp"
#include "io/sha256.hpp"
#include "io/state_json.hpp"
#include "mapfile/map_reader.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "raster/png.hpp"
#include "render/plan_picture.hpp"
#include "revision/revised_file.hpp"
#include "waybreaker/error.hpp"
#include "zone_options.hpp"

namespace waybreaker::apps {
namespace {

using revision::RevisedFile;

struct ReviseOptions {
    std::string map;
    std::string plan;
    std::string state;
    std::string json;
    std::string svg;
    std::string png;
    OverlayOptions overlays;
    double reaction = 0;
    double seconds = 10;
    bool no_timing = false;
};

// What has become of the plan, for a person.
std::string summary(const RevisedFile& next) {
    std::string text;
    switch (next.status) {
        case RevisionStatus::unchanged:
            return "nothing new: the plan knows that report already\n";
        case RevisionStatus::kept:
            text = "kept: nothing better was found than the rest of the plan\n";
            break;
        case RevisionStatus::revised:
            text = "revised: the rest of the plan is another one\n";
            break;
        case RevisionStatus::no_plan:
        case RevisionStatus::broken:
            return "";
    }
    for (const Decision& decision : next.plan.revised->decisions) {
        text += fmt::format("{} keeps to the plan before until {:.3f}, point {}\n", decision.agent, decision.time,
                            decision.point);
    }
    return text + "\n";
}

[[noreturn]] void report_none(const RevisedFile& next) {
    if (next.status == RevisionStatus::broken) {
        std::string text = "no agent can keep to its plan until it decides";
        for (const Halt& halt : next.plan.revised->halts) {
            text +=
                fmt::format("; {} must stop before point {} of its path, by {:.3f}", halt.agent, halt.point, halt.by);
        }
        throw NoPlan(text);
    }
    const std::string& reason = next.plan.revised->reason;
    if (!reason.empty()) throw NoPlan("no plan: " + reason);
    if (next.plan.status == PlanStatus::no_plan) throw NoPlan("no plan: what is left of the mission has none");
    const bool or_time = next.plan.status == PlanStatus::limit_reached;
    if (next.plan.barred_by)
        throw NoPlanFound(barred_text(*next.plan.barred_by, next.asked.mission.rules.zones, or_time));
    throw NoPlanFound(std::string("no plan of what is left of the mission was found, nor that there is none") +
                      (or_time ? "; raise --time-limit" : ""));
}

void run(const ReviseOptions& options) {
    const std::vector<site::OverlaySource> overlays = overlays_of(options.overlays);
    NamedFiles inputs{{"MAP", options.map}, {"PLAN", options.plan}, {"--state", options.state}};
    for (const site::OverlaySource& overlay : overlays) inputs.emplace_back("--also", overlay.file);
    validate_inputs(inputs);
    validate_outputs({{"--json", options.json}, {"--svg", options.svg}, {"--png", options.png}}, inputs);
    const std::string bytes = io::read_whole(options.plan, io::max_plan_bytes);
    const io::PlanFile before = io::parse_plan(bytes, io::input_name(options.plan));
    const State state = io::read_state_file(options.state);
    const io::MapFile map = [&] {
        const Progress progress("reading " + io::input_name(options.map));
        return to_plan_on(overlays, mapfile::read_map_file(options.map, before.connectivity, before.image));
    }();
    Planner planner;
    const RevisedFile next = [&] {
        const Progress progress("revising");
        return revision::revise(planner,
                                {.before = before,
                                 .before_name = io::input_name(options.plan),
                                 .digest = io::sha256_digest(bytes),
                                 .map = map,
                                 .state = state,
                                 .state_name = io::input_name(options.state),
                                 .reaction = options.reaction},
                                {.seconds = options.seconds});
    }();
    const bool solved = next.plan.status == PlanStatus::solved;
    std::vector<io::OutputFile> outputs;
    if (!options.json.empty()) outputs.push_back({options.json, next.json(!options.no_timing)});
    const auto picture = [&] {
        return render::svg(next.map.map, next.asked.mission, next.plan,
                           render::picture_options(next.map, next.asked, next.plan));
    };
    if (solved && !options.svg.empty()) outputs.push_back({options.svg, picture()});
    if (solved && !options.png.empty()) outputs.push_back({options.png, raster::png_of(picture())});
    std::ranges::move(files_of_map(options.map, map), std::back_inserter(inputs));
    write_beside(outputs, inputs);
    if (!solved) report_none(next);
    if (std::ranges::find(outputs, "-", &io::OutputFile::path) != outputs.end()) return;
    const TableStyle style{.metres = next.map.has_metres(), .bold = isatty(STDOUT_FILENO) == 1};
    io::write_whole("-", summary(next) + plan_table(next.plan, next.context(!options.no_timing), style));
}

}  // namespace

void setup_revise(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<ReviseOptions>();
    CLI::App* command = root.add_subcommand(
        "revise",
        "Plan the rest of a mission anew, from what has happened\n\n"
        "A state says where agents are, which breaches have failed, and what was found. What they are bound to do "
        "stays: "
        "a vehicle drives to its next bend, an aircraft finishes a breach that it has begun. The rest is planned anew, "
        "with a bound, and never ends later than the old plan where that is still possible. The new plan file can be "
        "revised in turn; waybreaker check --after judges whether it goes on from the old one. The exit status is 1 if "
        "there is no plan left.");
    add_file(*command, "MAP", options->map, "The map the plan was made for")->required();
    add_file(*command, "PLAN", options->plan, "A plan file, as waybreaker plan or revise writes it")->required();
    add_file(*command, "--state", options->state, "What has happened (waybreaker-state/1, docs/live.md); or -")
        ->required();
    add_file(*command, "--json", options->json, "Write the new plan; - is standard output");
    add_file(*command, "--svg", options->svg, "Draw it");
    add_file(*command, "--png", options->png, "Draw it");
    add_number(
        *command, "--reaction", [options](double time) { options->reaction = time; }, {0, most_breach_time}, "TIME",
        "How long it takes until agents know of the new plan; they keep to the old one until then (default: 0)");
    add_number(
        *command, "--time-limit", [options](double seconds) { options->seconds = seconds; }, {1e-3, 1e6}, "SECONDS",
        "Plan for at most so long (default: 10)");
    command->add_flag("--no-timing", options->no_timing, "Leave measured seconds out, so that bytes repeat");
    add_overlay_options(*command, options->overlays);
    set_examples(*command,
                 {"waybreaker revise data/berlin-mitte.tif plan.json --state state.json --json new.json",
                  "waybreaker revise data/berlin-mitte.tif plan.json --state state.json --reaction 2 --svg new.svg"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

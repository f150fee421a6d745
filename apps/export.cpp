// `waybreaker export`: converts a plan file to other formats.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "commands.hpp"
#include "help.hpp"
#include "io/check_report.hpp"
#include "io/map_file.hpp"
#include "io/output_file.hpp"
#include "io/plan_file.hpp"
#include "mapfile/map_reader.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "page_planner.hpp"
#include "plan_exports.hpp"
#include "progress.hpp"
#include "studio/plan_html.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct ExportOptions {
    std::string map;
    std::string plan;
    PlanExports exports;
    std::string html;
    SteerableOptions steerable;
    OverlayOptions overlays;
    bool ignore_digest = false;
};

io::MapFile read_map(const ExportOptions& options, const std::vector<city::OverlaySource>& overlays,
                     const io::PlanFile& plan) {
    const Progress progress("reading " + io::input_name(options.map));
    return io::known_map(to_plan_on(overlays, mapfile::read_map_file(options.map, plan.connectivity, plan.image)),
                         plan.plan);
}

// Writers trust a plan, so one that comes from a file is checked first.
void require_valid(const ExportOptions& options, const io::PlanFile& plan, const io::MapFile& map) {
    const std::vector<Violation> violations = io::judge(plan, map, {.ignore_digest = options.ignore_digest});
    if (violations.empty()) return;
    const std::string name = io::input_name(options.plan);
    if (violations.front().rule == Rule::map) throw InputError(name, 0, violations.front().message);
    throw InputError(name, 0, fmt::format("is not valid: see waybreaker check {} {}", options.map, options.plan));
}

std::string html(const ExportOptions& options, const std::string& text, const io::PlanFile& plan,
                 const io::MapFile& map) {
    if (!options.steerable.asked) return studio::plan_html(map, std::array{studio::NamedPlan{"plan", text}});
    if (plan.plan.status != PlanStatus::solved)
        throw InputError(options.plan, 0, "has no plan, which --steerable could begin with");
    return studio::steerable_html(map, plan.connectivity, text, packed_page_planner(options.steerable));
}

void run(const ExportOptions& options) {
    validate(options.exports);
    auto outputs = named_outputs(options.exports);
    outputs.emplace_back("--html", options.html);
    const std::vector<city::OverlaySource> overlays = overlays_of(options.overlays);
    NamedFiles inputs{{"MAP", options.map}, {"PLAN", options.plan}};
    for (const city::OverlaySource& overlay : overlays) inputs.emplace_back("--also", overlay.file);
    validate_inputs(inputs);
    validate_outputs(outputs, inputs);
    if (std::all_of(outputs.begin(), outputs.end(), [](const auto& output) { return output.second.empty(); })) {
        throw InputError(
            "nothing to write: give --geojson, --csv, --ros-path, --ros-parts, --opened-map, --xml, --reach, --gpx, "
            "--kml, --qgc, --vda5050 or --html");
    }
    const std::string text = io::read_whole(options.plan, io::max_plan_bytes);
    const io::PlanFile plan = io::parse_plan(text, options.plan);
    const io::MapFile map = read_map(options, overlays, plan);
    require_valid(options, plan, map);
    if (!options.exports.reach.empty() && plan.plan.status != PlanStatus::solved)
        throw InputError(options.plan, 0, "has no plan, by which --reach could say what is reached");
    auto files = export_plan(options.exports, plan.plan, map, plan.asked);
    if (!options.html.empty()) files.push_back({options.html, html(options, text, plan, map)});
    std::ranges::move(files_of_map(options.map, map), std::back_inserter(inputs));
    write_beside(files, inputs);
}

}  // namespace

void setup_export(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = root.add_subcommand(
        "export",
        "Write a plan for GIS, spreadsheets, robots and the authors' tools\n\n"
        "Takes a plan file and its map, and writes what waybreaker plan would have with the same options. A plan that "
        "is not valid for the map is refused.");
    add_file(*command, "MAP", options->map, "The map the plan was made for; - is standard input")->required();
    add_file(*command, "PLAN", options->plan, "A plan file, as waybreaker plan --json writes it; or -")->required();
    add_plan_exports(*command, options->exports);
    add_file(*command, "--html", options->html, "Write a page for a browser that plays the plan");
    add_steerable(*command, options->steerable);
    add_overlay_options(*command, options->overlays);
    command->add_flag("--ignore-digest", options->ignore_digest,
                      "Accept another map file, if only the plan holds on it");
    set_examples(*command, {"waybreaker export data/berlin-mitte.tif plan.json --geojson plan.geojson",
                            "waybreaker export floor.yaml plan.json --ros-path path.yaml --csv waypoints.csv",
                            "waybreaker export floor.yaml plan.json --vda5050 orders.json",
                            "waybreaker export data/berlin-mitte.tif plan.json --altitude 60 --qgc flight.plan"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

// `waybreaker check`: whether a plan file is valid, judged from the map alone.
#include <fmt/format.h>

#include "commands.hpp"
#include "help.hpp"
#include "io/check_report.hpp"
#include "io/map_file.hpp"
#include "io/output_file.hpp"
#include "io/plan_file.hpp"
#include "mapfile/map_reader.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "progress.hpp"

namespace waybreaker::apps {
namespace {

struct CheckOptions {
    std::string map;
    std::string plan;
    std::string json;
    double tolerance = io::JudgeOptions().tolerance;
    bool ignore_digest = false;
};

// For a person: the first few, with time and place.
std::string as_text(const std::vector<Violation>& violations, const std::string& plan) {
    if (violations.empty()) return plan + " is valid\n";
    constexpr std::size_t most = 10;
    std::string text = fmt::format("{:>10}  {:>15}  {}\n", "time", "place", "violation");
    for (std::size_t i = 0; i < std::min(violations.size(), most); ++i) {
        const Violation& violation = violations[i];
        const std::string time = violation.time ? fmt::format("{:.3f}", *violation.time) : "-";
        const std::string place =
            violation.place ? fmt::format("{:.6g},{:.6g}", violation.place->x, violation.place->y) : "-";
        text += fmt::format("{:>10}  {:>15}  {}\n", time, place, violation.message);
    }
    if (violations.size() > most) text += fmt::format("and {} more; --json lists all\n", violations.size() - most);
    return text;
}

void run(const CheckOptions& options) {
    const NamedFiles inputs{{"MAP", options.map}, {"PLAN", options.plan}};
    validate_inputs(inputs);
    validate_outputs({{"--json", options.json}}, inputs);
    const io::PlanFile plan = io::read_plan_file(options.plan);
    const io::MapFile map = [&] {
        const Progress progress("reading " + io::input_name(options.map));
        return mapfile::read_map_file(options.map, plan.connectivity, plan.image);
    }();
    const std::vector<Violation> violations =
        io::judge(plan, map, {.tolerance = options.tolerance, .ignore_digest = options.ignore_digest});
    if (!options.json.empty()) io::write_whole(options.json, io::check_json(violations));
    if (options.json != "-") io::write_whole("-", as_text(violations, io::input_name(options.plan)));
    if (violations.empty()) return;
    throw InvalidPlan(fmt::format("{} is not valid: {} {}", io::input_name(options.plan), violations.size(),
                                  violations.size() == 1 ? "violation" : "violations"));
}

}  // namespace

void setup_check(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = root.add_subcommand(
        "check",
        "Check a plan file against its map\n\n"
        "Judges from the map alone, without the planner's geometry: the ground agent's way against all that stands at "
        "that moment, speeds and times, breaches, lengths, objective and bound. Says what is wrong, where and when; "
        "the "
        "exit status is 0 if the plan is valid, 1 if it is not and 2 if it cannot be read.");
    add_file(*command, "MAP", options->map, "The map the plan was made for; - is standard input")->required();
    add_file(*command, "PLAN", options->plan, "A plan file, as waybreaker plan --json writes it; or -")->required();
    add_file(*command, "--json", options->json, "Write all violations, for programs; - is standard output");
    command->add_flag("--ignore-digest", options->ignore_digest,
                      "Accept another map file, if only the plan holds on it");
    add_number(
        *command, "--tolerance", [options](double share) { options->tolerance = share; }, {1e-15, 1}, "SHARE",
        "How far numbers may be off, as a share of them (default: 1e-6)");
    set_examples(*command, {"waybreaker check data/berlin-mitte.tif plan.json",
                            "waybreaker check Berlin_0_512.map plan.json --json - | jq '.violations[0]'"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

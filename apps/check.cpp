// `waybreaker check`: whether a plan file is valid, judged from the map alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "help.hpp"
#include "io/check_report.hpp"
#include "io/map_file.hpp"
#include "io/output_file.hpp"
#include "io/plan_file.hpp"
#include "io/state_json.hpp"
#include "io/weights.hpp"
#include "mapfile/map_reader.hpp"
#include "mission/waits.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "progress.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::apps {
namespace {

constexpr double seconds_to_replan = 10;

struct CheckOptions {
    std::string map;
    std::string plan;
    std::string json;
    std::string weights;
    double tolerance = io::JudgeOptions().tolerance;
    OverlayOptions overlays;
    std::string after;
    std::string state;
    bool ignore_digest = false;
    bool replan = false;
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

// Holds why agents wait against what is found from the paths once more.
void judge_causes(const io::PlanFile& file, const Map& map, double tolerance, std::vector<Violation>& violations) {
    const std::vector<Agent>& asked = file.asked.mission.agents;
    const std::vector<Itinerary>& stated = file.plan.agents;
    const auto explained = [](const Itinerary& agent) { return !agent.waits.empty(); };
    if (!std::ranges::equal(asked, stated, {}, &Agent::id, &Itinerary::id)) return;
    if (std::ranges::none_of(stated, explained)) return;
    Plan again = file.plan;
    add_waits(map, file.asked.mission, again);
    const auto same = [tolerance](const Wait& a, const Wait& b) {
        constexpr double rounding = 2e-6;  // of the times at which they change
        const double hair = rounding + tolerance * std::max(1.0, std::abs(a.until));
        return a.reason == b.reason && a.obstacle == b.obstacle && a.agent == b.agent &&
               std::abs(a.from - b.from) <= hair && std::abs(a.until - b.until) <= hair;
    };
    for (std::size_t i = 0; i < stated.size(); ++i) {
        if (std::ranges::equal(stated[i].waits, again.agents[i].waits, same)) continue;
        violations.push_back({Rule::waits,
                              fmt::format("what the {} agent waits for is not what is found again", stated[i].id),
                              stated[i].id});
    }
}

// Holds what no path in the file proves, the figures without removals and the bound, against planning once more.
void judge_by_planning(const io::PlanFile& file, const Map& map, double tolerance, std::vector<Violation>& violations) {
    const Progress progress("planning again");
    const Plan& plan = file.plan;
    Method method = file.asked.method;
    method.bound = plan.bound.has_value();
    method.explain = false;
    const Plan again = Planner().plan(map, file.asked.mission, method, {.seconds = seconds_to_replan});
    const auto report = [&](Rule rule, const char* what, double stated, double found) {
        violations.push_back(
            {rule, fmt::format("{} is {:.9g} by the plan, and {:.9g} when it is planned again", what, stated, found)});
    };
    const auto& before = plan.before.ground().length;
    const auto& before_again = again.before.ground().length;
    const bool limited = plan.limit_reached || again.limit_reached;
    if (before && before_again && !limited && std::abs(*before - *before_again) > tolerance * *before_again) {
        report(Rule::before, "before removal the ground agent's length", *before, *before_again);
    }
    // A limit makes a bound weaker, never wrong: what was proven this time need not be all there is.
    if (plan.bound && again.bound && !again.limit_reached && *plan.bound > *again.bound * (1 + tolerance)) {
        report(Rule::bound, "the bound", *plan.bound, *again.bound);
    }
    if (plan.least_demolition && again.least_demolition && !again.limit_reached &&
        *plan.least_demolition > *again.least_demolition) {
        report(Rule::bound, "what plans as good demolish at least, in cells,", double(*plan.least_demolition),
               double(*again.least_demolition));
    }
}

void run(const CheckOptions& options) {
    const std::vector<site::OverlaySource> overlays = overlays_of(options.overlays);
    NamedFiles inputs{{"MAP", options.map},
                      {"PLAN", options.plan},
                      {"--weights", options.weights},
                      {"--after", options.after},
                      {"--state", options.state}};
    for (const site::OverlaySource& overlay : overlays) inputs.emplace_back("--also", overlay.file);
    validate_inputs(inputs);
    validate_outputs({{"--json", options.json}}, inputs);
    if (options.after.empty() != options.state.empty())
        throw InputError("--after and --state belong together: the plan before, and what had happened to it");
    const io::PlanFile plan = io::read_plan_file(options.plan);
    const io::MapFile map = [&] {
        const Progress progress("reading " + io::input_name(options.map));
        return io::known_map(to_plan_on(overlays, mapfile::read_map_file(options.map, plan.connectivity, plan.image)),
                             plan.plan);
    }();
    io::JudgeOptions judging{.tolerance = options.tolerance, .ignore_digest = options.ignore_digest};
    if (plan.asked.area_budget && !options.weights.empty()) {
        throw InputError(io::input_name(options.plan), 0, "has a budget of square metres: --weights is not for it");
    }
    if (!options.weights.empty()) judging.weights = io::read_weights(options.weights, map.map);
    std::vector<Violation> violations = options.after.empty()
                                            ? io::judge(plan, map, judging)
                                            : io::judge_after(plan, map, io::read_plan_file(options.after),
                                                              io::read_state_file(options.state), judging);
    if (options.replan && violations.empty()) {
        const std::optional<Map> other = io::reweighed(plan, map, judging);
        judge_causes(plan, map.map, options.tolerance, violations);
        judge_by_planning(plan, other ? *other : map.map, options.tolerance, violations);
    }
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
    command->add_flag(
        "--replan", options->replan,
        "Plan the mission again, for at most 10 s, and compare the figures without removals and the bound, which "
        "nothing else in the file proves; and find again what agents wait for");
    add_file(*command, "--after", options->after,
             "The plan before: judge whether PLAN, which revises it, goes on from there; with --state");
    add_file(*command, "--state", options->state, "What had happened to it, as waybreaker revise was told");
    command->add_flag("--ignore-digest", options->ignore_digest,
                      "Accept another map file, if only the plan holds on it");
    add_overlay_options(*command, options->overlays);
    add_file(*command, "--weights", options->weights,
             "Weights that the mission gave obstacles, as for waybreaker plan (default: as the map says)");
    add_number(
        *command, "--tolerance", [options](double share) { options->tolerance = share; }, {1e-15, 1}, "SHARE",
        "How far numbers may be off, as a share of them, or of 1000 if they are larger (default: 1e-6)");
    set_examples(*command, {"waybreaker check data/berlin-mitte.tif plan.json",
                            "waybreaker check Berlin_0_512.map plan.json --json - | jq '.violations[0]'"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

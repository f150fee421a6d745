// `waybreaker plan`: one mission, from a map file to a table, a plan file and pictures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "core/stopwatch.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "io/plan_json.hpp"
#include "io/search_trace.hpp"
#include "mapfile/map_reader.hpp"
#include "plan_options.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "raster/png.hpp"
#include "render/picture.hpp"
#include "studio/plan_html.hpp"
#include "studio/plan_picture.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::apps {
namespace {

// Every step of the ground search on the closed map. Searches again, so that tracing slows down nothing else.
std::string trace(const Map& map, const Mission& mission, const Method& method) {
    const Agent& driver = mission.first(AgentKind::ground);
    SearchOptions search = search_options(method, driver.body);
    const OpenedMap closed(map);
    io::SearchTrace listener(closed, driver.start, driver.goal);
    search.listener = &listener;
    Searcher().find(closed, driver.start, driver.goal, search);
    return listener.text();
}

// Never zero: a plan that starts late still has to finish.
double time_left(const Deadline& deadline) {
    constexpr double least = 0.01;
    return std::max(deadline.left(), least);
}

constexpr int usual_most_removals = 8;  // that a page's curve shows

// Bold headings, where a person reads them and has not asked for plain text (no-color.org).
bool wants_bold() {
    const char* no_color = std::getenv("NO_COLOR");
    return isatty(STDOUT_FILENO) == 1 && (no_color == nullptr || *no_color == '\0');
}

constexpr double share_of_team = 0.7;  // of the time: for a team's plan, before what its page compares it with

// The plan, and what there is to compare it with: no removal, the paper's plan (which knows no teams), more and fewer
// removals.
std::string html(const io::PlanContext& context, const Plan& chosen, const Limits& limits, const Deadline& deadline) {
    MissionPlanner planner;
    const auto what_is_left = [&] {
        Limits left = limits;
        left.seconds = time_left(deadline);
        return left;
    };
    std::vector<studio::NamedPlan> plans;
    const auto json = [&](const Mission& mission, const Method& method, const Plan& plan,
                          std::span<const Plan> front = {}) {
        return io::plan_json(plan, {.map = context.map,
                                    .mission = mission,
                                    .method = method,
                                    .connectivity = context.connectivity,
                                    .timing_fields = context.timing_fields,
                                    .image = context.image,
                                    .front = front,
                                    .area_budget = context.area_budget,
                                    .in_seconds = context.in_seconds});
    };
    const auto add = [&](const std::string& name, const Mission& mission, const Method& method) {
        const Plan plan = planner.plan(context.map.map, mission, method, what_is_left());
        plans.push_back({name, json(mission, method, plan)});
    };
    plans.push_back({"plan", json(context.mission, context.method, chosen)});
    Method usual = context.method;
    usual.explain = false;
    Mission none = context.mission;
    none.rules.removals = 0;
    none.rules.force.clear();
    add("before", none, usual);
    const bool is_team = context.mission.is_team();
    if (usual.select == Selection::exact && !is_team) {
        Mission mission = context.mission;
        Method paper = usual;
        follow_paper(mission.rules, paper);
        add("paper", mission, paper);
    }
    if (is_team && deadline.passed()) return studio::plan_html(context.map, plans);
    Mission more = context.mission;
    more.rules.removals = std::max(more.rules.removals, usual_most_removals);
    const std::vector<Plan> front = planner.front(context.map.map, more, usual, what_is_left());
    return studio::plan_html(context.map, plans, json(more, usual, front.back(), front));
}

// Writes all outputs, standard output last, when all files are complete. `outputs`: what is known without a plan.
void write_outputs(std::vector<std::pair<std::string, std::string>> outputs, const PlanOptions& options,
                   const io::PlanContext& context, const Plan& explained, const Limits& limits,
                   const Deadline& deadline) {
    Plan plan = explained;
    if (!context.method.explain) {  // for the page alone
        for (Breach& breach : plan.breaches) breach.saves.reset();
        plan.next.clear();
        for (Itinerary& agent : plan.agents) {
            agent.gain.reset();
            agent.waits.clear();
        }
    }
    const io::MapFile& file = context.map;
    const render::PictureOptions picture =
        studio::picture_options(file, context.mission.rules.objective, context.in_seconds);
    if (!options.json.empty()) outputs.emplace_back(options.json, io::plan_json(plan, context));
    if (!options.svg.empty()) outputs.emplace_back(options.svg, render::svg(file.map, context.mission, plan, picture));
    if (!options.png.empty())
        outputs.emplace_back(options.png, raster::png_of(render::svg(file.map, context.mission, plan, picture)));
    if (!options.html.empty()) outputs.emplace_back(options.html, html(context, explained, limits, deadline));
    if (!options.trace.empty()) {
        outputs.emplace_back(options.trace, trace(file.map, context.mission, context.method));
    }
    Plan exported = plan;
    if (options.no_timing) {
        for (Route& route : exported.after.routes) route.seconds = 0;
    }
    for (auto& output :
         export_plan(options.exports, exported, file, search_options(context.method, context.mission.ground_body()))) {
        outputs.push_back(std::move(output));
    }
    const auto last =
        std::stable_partition(outputs.begin(), outputs.end(), [](const auto& output) { return output.first != "-"; });
    if (last == outputs.end() && plan.status == PlanStatus::solved) {
        outputs.emplace_back("-", plan_table(plan, context, {.metres = file.has_metres(), .bold = wants_bold()}));
    }
    for (const auto& [path, bytes] : outputs) io::write_whole(path, bytes);
}

std::string why_no_team_plan(const Plan& plan, const Mission& mission) {
    if (plan.status == PlanStatus::limit_reached) {
        const bool flies = std::ranges::any_of(mission.agents, [](const Agent& a) { return a.kind == AgentKind::air; });
        return fmt::format(
            "no plan for {} agents was found, nor that there is none; fewer agents{} or more time may help",
            mission.agents.size(), flies ? ", more removals" : "");
    }
    return "no plan: a ground agent cannot get from its start to its goal, even if it were alone";
}

void require_plan(const Plan& plan, const Mission& mission, const Limits& limits) {
    if (plan.status == PlanStatus::solved) return;
    if (mission.is_team()) throw NoPlan(why_no_team_plan(plan, mission));
    const Agent& driver = mission.first(AgentKind::ground);
    const std::string way =
        fmt::format("from {},{} to {},{}", driver.start.x, driver.start.y, driver.goal.x, driver.goal.y);
    if (plan.status == PlanStatus::limit_reached) {
        if (limits.expansions == UINT64_MAX) {
            throw NoPlan(fmt::format("no plan {} was found in time; raise --time-limit", way));
        }
        throw NoPlan(fmt::format("no plan {} within {} expansions; raise --expansion-limit", way, limits.expansions));
    }
    const std::size_t removed = plan.breaches.size();
    throw NoPlan(fmt::format("no plan: the ground agent cannot get {}{}", way,
                             removed == 0 ? "" : fmt::format(", even with {} removed obstacles", removed)));
}

io::MapFile read_map(const PlanOptions& options) {
    const Progress progress("reading " + io::input_name(options.map));
    io::MapFile file = mapfile::read_map_file(options.map, options.connectivity, options.image);
    file.cell_size = options.cell_size.value_or(file.cell_size);
    file.cell_size_given = options.cell_size.has_value();
    return file;
}

// One plan; or, with --removals auto, those for 0, 1, 2, ... removals as long as they gain.
std::vector<Plan> plan_mission(const io::MapFile& file, const io::MissionDocument& asked, bool front) {
    Progress progress("planning");
    Limits limits = asked.limits;
    limits.progress = [&progress](const waybreaker::Progress& known) {
        if (!std::isfinite(known.best)) return;
        progress.update(fmt::format("best {:.1f}, none below {:.1f}", known.best, known.bound));
    };
    MissionPlanner planner;
    std::vector<Plan> plans = front ? planner.front(file.map, asked.mission, asked.method, limits)
                                    : std::vector<Plan>{planner.plan(file.map, asked.mission, asked.method, limits)};
    plans.back().seconds.label = file.label_seconds;
    plans.back().seconds.total += file.label_seconds;
    return plans;
}

void run(const PlanOptions& options) {
    validate(options);
    const Stopwatch since_start;
    io::MapFile file = read_map(options);
    io::MissionDocument asked = mission_of(options, file);
    if (const auto weights = weights_of(options, asked, file)) file.map = file.map.with_weights(*weights);
    std::vector<std::pair<std::string, std::string>> outputs;
    if (!options.save_mission.empty()) outputs.emplace_back(options.save_mission, io::mission_text(asked));
    const Deadline deadline(asked.limits.seconds - since_start.seconds());
    validate(search_options(asked.method, asked.mission.ground_body()));
    try {
        validate(file.map, asked.mission, asked.method, asked.limits);
    } catch (const InputError& error) {
        const std::string& file_at_fault = options.mission.empty() ? options.map : options.mission;
        throw InputError(io::input_name(file_at_fault), 0, error.what());
    }
    asked.limits.seconds = time_left(deadline);
    if (!options.html.empty() && asked.mission.is_team()) asked.limits.seconds *= share_of_team;
    const bool explain = std::exchange(asked.method.explain, asked.method.explain || !options.html.empty());
    const std::vector<Plan> plans = plan_mission(file, asked, options.removals_auto);
    asked.method.explain = explain;
    Rules& rules = asked.mission.rules;
    if (options.removals_auto) rules.removals = int(plans.size() + rules.force.size()) - 1;
    const Plan& plan = plans.back();
    const io::PlanContext context{.map = file,
                                  .mission = asked.mission,
                                  .method = asked.method,
                                  .connectivity = options.connectivity,
                                  .timing_fields = !options.no_timing,
                                  .image = options.image,
                                  .front = options.removals_auto ? std::span(plans) : std::span<const Plan>(),
                                  .area_budget = asked.area_budget,
                                  .in_seconds = asked.in_seconds};
    write_outputs(std::move(outputs), options, context, plan, asked.limits, deadline);
    require_plan(plan, asked.mission, asked.limits);
}

}  // namespace

void setup_plan(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<PlanOptions>();
    CLI::App* command = root.add_subcommand(
        "plan",
        "Plan one mission: which obstacles an aircraft removes, how it flies, how the ground agent drives\n\n"
        "Cells are counted from the upper-left one, 0,0: x to the right, y down. Without an output option for standard "
        "output a short table of the plan and of the mission without removals goes there.");
    add_plan_options(*command, *options);
    set_examples(*command,
                 {"waybreaker plan data/berlin-adlershof.tif --start 130,104 --goal 466,105",
                  "waybreaker plan data/berlin-adlershof.tif --start 130,104 --goal 466,105 --removals auto --explain",
                  "waybreaker plan data/berlin-adlershof.tif --start 130,104 --goal 466,105 --html plan.html",
                  "waybreaker plan Berlin_0_512.map --start 12,20 --goal 400,380 --paper -n 1 --json plan.json",
                  "waybreaker plan task.xml --planner jps --svg - | rsvg-convert > plan.png"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

// `waybreaker plan`: one mission, from a map file to a table, a plan file and pictures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "core/stopwatch.hpp"
#include "draw_options.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "io/plan_json.hpp"
#include "io/search_trace.hpp"
#include "mapfile/map_reader.hpp"
#include "mission/reach.hpp"
#include "places.hpp"
#include "plan_options.hpp"
#include "plan_table.hpp"
#include "progress.hpp"
#include "raster/png.hpp"
#include "render/plan_picture.hpp"
#include "robust.hpp"
#include "studio/plan_html.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/revise.hpp"
#include "zone_options.hpp"

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

// What a page's curve shows where the time has ended it: the plan, what is reached without removals, and that nothing
// is known of the rest. It begins with what has to be removed.
std::vector<Plan> as_far_as_known(std::vector<Plan> front, const Rules& rules, const Plan& before, const Plan& chosen) {
    const std::size_t first = rules.force.size();
    Plan unknown;
    unknown.status = PlanStatus::limit_reached;
    front.resize(std::max(front.size(), std::max<std::size_t>(usual_most_removals, first) + 1 - first), unknown);
    const auto add = [&](std::size_t removals, const Plan& plan) {
        constexpr double never = std::numeric_limits<double>::infinity();
        const auto reached = [&](const Plan& one) { return value(one.after, rules.objective).value_or(never); };
        Plan& step = front[removals - first];
        if (step.status == PlanStatus::limit_reached || reached(plan) < reached(step)) step = plan;
    };
    if (first == 0 && before.status != PlanStatus::limit_reached) {
        add(0, before);
    } else if (first == 0 && chosen.before.makespan) {
        Plan without;
        without.status = PlanStatus::solved;
        without.after = chosen.before;
        add(0, without);
    }
    const std::size_t most = std::min(std::size_t(rules.removals), front.size() - 1 + first);
    for (std::size_t removals = std::max(chosen.breaches.size(), first); removals <= most; ++removals)
        add(removals, chosen);
    return front;
}

constexpr double share_of_team = 0.7;  // of the time: for a team's plan, before what its page compares it with

// The plan, and what there is to compare it with: no removal, the paper's plan (which knows no teams), more and fewer
// removals.
std::string html(const io::PlanContext& context, const Plan& chosen, const Limits& limits, const Deadline& deadline) {
    Planner planner;
    const auto what_is_left = [&] {
        Limits left = limits;
        left.seconds = time_left(deadline);
        return left;
    };
    std::vector<studio::NamedPlan> plans;
    const auto json = [&](const io::MissionDocument& asked, const Plan& plan, std::span<const Plan> front = {}) {
        return io::plan_json(plan, {.map = context.map,
                                    .asked = asked,
                                    .connectivity = context.connectivity,
                                    .timing_fields = context.timing_fields,
                                    .image = context.image,
                                    .front = front});
    };
    const auto add = [&](const std::string& name, const io::MissionDocument& asked) {
        Plan plan = planner.plan(context.map.map, asked.mission, asked.method, what_is_left());
        plans.push_back({name, json(asked, plan)});
        return plan;
    };
    plans.push_back({"plan", json(context.asked, chosen)});
    io::MissionDocument usual = context.asked;
    usual.method.explain = false;
    io::MissionDocument none = usual;
    none.mission.rules.removals = 0;
    none.mission.rules.force.clear();
    const Plan before = add("before", none);
    const bool is_team = usual.mission.is_team();
    if (usual.method.select == Selection::exact && !is_team) {
        io::MissionDocument paper = usual;
        follow_paper(paper.mission.rules, paper.method);
        add("paper", paper);
    }
    if (is_team && deadline.passed()) return studio::plan_html(context.map, plans);
    io::MissionDocument more = usual;
    more.mission.rules.removals = std::max(more.mission.rules.removals, usual_most_removals);
    std::vector<Plan> front = planner.front(context.map.map, more.mission, more.method, what_is_left());
    if (deadline.passed()) front = as_far_as_known(std::move(front), usual.mission.rules, before, chosen);
    return studio::plan_html(context.map, plans, json(more, front.back(), front));
}

// Writes all outputs, standard output last, when all files are complete. `outputs`: what is known without a plan.
// `report`: goes below the table.
void write_outputs(std::vector<io::OutputFile> outputs, const PlanOptions& options, const io::PlanContext& context,
                   const Plan& explained, const std::string& report, const Limits& limits, const Deadline& deadline) {
    Plan plan = explained;
    const io::MissionDocument& asked = context.asked;
    if (!asked.method.explain) {  // for the page alone
        for (Breach& breach : plan.breaches) breach.saves.reset();
        plan.next.clear();
        for (Itinerary& agent : plan.agents) agent.gain.reset();
    }
    const io::MapFile& file = context.map;
    render::PictureOptions picture = render::picture_options(file, asked, plan);
    if (!options.svg.empty() || !options.png.empty()) picture.reach = reach_of(file.map, asked.mission, plan);
    if (!options.json.empty()) outputs.push_back({options.json, io::plan_json(plan, context)});
    if (!options.svg.empty()) {
        render::PictureOptions moving = picture;
        moving.animate = options.animate;
        outputs.push_back({options.svg, render::svg(file.map, asked.mission, plan, moving)});
    }
    if (!options.png.empty())
        outputs.push_back({options.png, raster::png_of(render::svg(file.map, asked.mission, plan, picture))});
    if (options.steerable.asked) {
        outputs.push_back(
            {options.html, studio::steerable_html(file, context.connectivity, io::plan_json(plan, context),
                                                  packed_page_planner(options.steerable))});
    } else if (!options.html.empty()) {
        outputs.push_back({options.html, html(context, explained, limits, deadline)});
    }
    if (!options.trace.empty()) {
        outputs.push_back({options.trace, trace(file.map, asked.mission, asked.method)});
    }
    Plan exported = plan;
    if (options.no_timing) {
        for (Route& route : exported.after.routes) route.seconds = 0;
    }
    std::ranges::move(export_plan(options.exports, exported, file, asked), std::back_inserter(outputs));
    const auto last =
        std::stable_partition(outputs.begin(), outputs.end(), [](const auto& output) { return output.path != "-"; });
    if (last == outputs.end() && plan.status == PlanStatus::solved) {
        const TableStyle style{.metres = file.has_metres(), .bold = wants_bold()};
        outputs.push_back({"-", plan_table(plan, context, style) + report});
    }
    NamedFiles read = files_of_map(options.map, file);
    for (const site::OverlaySource& overlay : asked.overlays) read.emplace_back("an overlay", overlay.file);
    write_beside(outputs, read);
}

[[noreturn]] void report_no_team_plan(const Plan& plan, const Mission& mission) {
    if (plan.status == PlanStatus::no_plan) {
        throw NoPlan("no plan: a ground agent cannot get from its start to its goal, even if it were alone");
    }
    const bool flies = std::ranges::any_of(mission.agents, [](const Agent& a) { return a.kind == AgentKind::air; });
    const bool out_of_time = plan.status == PlanStatus::limit_reached;
    throw NoPlanFound(fmt::format("no plan for {} agents was found, nor that there is none; fewer agents{}{} may help",
                                  mission.agents.size(), flies ? ", more removals" : "",
                                  out_of_time ? " or more time" : ""));
}

void require_plan(const Plan& plan, const Mission& mission, const Limits& limits, const PlanOptions& options,
                  const io::MapFile& map) {
    if (plan.status == PlanStatus::solved) return;
    if (plan.barred_by) {
        const bool or_time = plan.status == PlanStatus::limit_reached;
        throw NoPlanFound(barred_text(*plan.barred_by, mission.rules.zones, or_time));
    }
    if (mission.is_team()) report_no_team_plan(plan, mission);
    const Agent& driver = mission.first(AgentKind::ground);
    const std::string way =
        fmt::format("from {} to {}", place_text(driver.start, options, map), place_text(driver.goal, options, map));
    if (plan.status == PlanStatus::limit_reached) {
        if (limits.expansions == UINT64_MAX) {
            throw NoPlanFound(fmt::format("no plan {} was found in time; raise --time-limit", way));
        }
        throw NoPlanFound(
            fmt::format("no plan {} within {} expansions; raise --expansion-limit", way, limits.expansions));
    }
    if (plan.status == PlanStatus::not_found) {
        throw NoPlanFound(
            fmt::format("no plan {} was found, nor that there is none; a smaller --radius may help", way));
    }
    if (!mission.rules.force.empty() && plan.before.ground().length) {
        throw NoPlan(
            "no plan: the aircraft cannot breach all that must be removed and come home; a longer range, or more "
            "aircraft, may help");
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

// The mission, its files as seen from where it is saved.
std::string saved_mission(io::MissionDocument asked, const std::string& path) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    for (site::OverlaySource& overlay : asked.overlays) {
        if (std::filesystem::path(overlay.file).is_relative()) {
            overlay.file = std::filesystem::absolute(overlay.file).lexically_relative(folder).string();
        }
    }
    return io::mission_text(asked);
}

// One plan; or, with --removals auto, those for 0, 1, 2, ... removals as long as they gain.
std::vector<Plan> plan_mission(const io::MapFile& file, const io::MissionDocument& asked, bool front) {
    Progress progress("planning");
    Limits limits = asked.limits;
    limits.progress = [&progress](const waybreaker::Progress& known) {
        if (!std::isfinite(known.best)) return;
        std::string line = fmt::format("best {:.1f}", known.best);
        if (known.bound > 0) line += fmt::format(", none below {:.1f}", known.bound);
        progress.update(line);
    };
    Planner planner;
    std::vector<Plan> plans = front ? planner.front(file.map, asked.mission, asked.method, limits)
                                    : std::vector<Plan>{planner.plan(file.map, asked.mission, asked.method, limits)};
    plans.back().seconds.label = file.label_seconds;
    plans.back().seconds.total += file.label_seconds;
    return plans;
}

void require_failures_can_be_planned(const PlanOptions& options, const Mission& mission) {
    if (!options.plan_b && !options.robust.share) return;
    const char* option = options.plan_b ? "--plan-b" : "--robust";
    if (mission.rules.timing == Timing::ignore)
        throw InputError(fmt::format("{} needs --timing enforce: where timing is ignored no breach fails", option));
}

Plan planned_for_failures(const io::MapFile& file, const io::MissionDocument& asked, double seconds, Plan plan) {
    if (plan.status != PlanStatus::solved) return plan;
    const Progress progress("planning for failures");
    Planner planner;
    return with_plan_b(planner, file.map, asked.mission, std::move(plan), method_of_revisions(asked.method),
                       {.seconds = seconds});
}

void run(const PlanOptions& options) {
    validate(options);
    const Stopwatch since_start;
    io::MissionDocument given = given_mission(options);
    io::MapFile file = to_plan_on(given.overlays, read_map(options));
    io::MissionDocument asked = mission_of(options, std::move(given), file);
    require_failures_can_be_planned(options, asked.mission);
    if (auto weighed = io::settle(asked, file, weights_of(options, asked, file.map))) file.map = std::move(*weighed);
    std::vector<io::OutputFile> outputs;
    if (!options.save_mission.empty())
        outputs.push_back({options.save_mission, saved_mission(asked, options.save_mission)});
    const Deadline deadline(asked.limits.seconds - since_start.seconds());
    validate(search_options(asked.method, asked.mission.ground_body()));
    const std::string file_at_fault = io::input_name(options.mission.empty() ? options.map : options.mission);
    try {
        validate(file.map, asked.mission, asked.method, asked.limits);
    } catch (const PlaceError& error) {
        throw InputError(file_at_fault, 0, why_misplaced(error.misplaced, options, file));
    } catch (const InputError& error) {
        throw InputError(file_at_fault, 0, error.what());
    }
    asked.limits.seconds = time_left(deadline);
    if (!options.html.empty() && asked.mission.is_team()) asked.limits.seconds *= share_of_team;
    const bool for_page = !options.html.empty() && !options.robust.share;
    const bool explain = std::exchange(asked.method.explain, asked.method.explain || for_page);
    std::string report;
    std::vector<Plan> plans;
    if (options.robust.share) {
        RobustPlan robust = robust_plan(file, asked, options.robust);
        plans.push_back(std::move(robust.plan));
        report = std::move(robust.report);
    } else {
        plans = plan_mission(file, asked, options.removals_auto);
    }
    asked.method.explain = explain;
    Rules& rules = asked.mission.rules;
    if (options.removals_auto) rules.removals = io::removals_of(plans, rules);
    if (options.plan_b) plans.back() = planned_for_failures(file, asked, time_left(deadline), std::move(plans.back()));
    const Plan& plan = plans.back();
    const io::PlanContext context{.map = file,
                                  .asked = asked,
                                  .connectivity = options.connectivity,
                                  .timing_fields = !options.no_timing,
                                  .image = options.image,
                                  .front = options.removals_auto ? std::span(plans) : std::span<const Plan>()};
    write_outputs(std::move(outputs), options, context, plan, report, asked.limits, deadline);
    require_plan(plan, asked.mission, asked.limits, options, file);
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
                  "waybreaker plan data/berlin-adlershof.tif --start 130,104 --goal 466,105 --svg plan.svg --animate",
                  "waybreaker plan Berlin_0_512.map --start 12,20 --goal 400,380 --paper -n 1 --json plan.json",
                  "waybreaker plan task.xml --planner jps --svg - | rsvg-convert > plan.png"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps

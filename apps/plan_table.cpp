#include "plan_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "io/option_words.hpp"
#include "io/plan_surfaces.hpp"
#include "range_options.hpp"
#include "render/caption.hpp"
#include "site/demolition.hpp"
#include "table.hpp"
#include "team_table.hpp"

namespace waybreaker::apps {
namespace {

// The map, the mission, and what the figures are in.
std::string heading(const io::PlanContext& context, const TableStyle& style) {
    const Map& map = context.map.map;
    std::string line = fmt::format("{}: {} x {} cells", context.map.source, map.width(), map.height());
    if (style.metres) line += fmt::format(" of {:.6g} m", context.map.cell_size);
    line += fmt::format(", {} {}\n", map.obstacles().size(), map.obstacles().size() == 1 ? "obstacle" : "obstacles");
    const std::string team_units = fmt::format("lengths in cells, times in {}\n", time_unit(context));
    if (context.asked.mission.is_team()) {
        const std::size_t count = context.asked.mission.agents.size();
        return line + fmt::format("{} {}\n", count, count == 1 ? "agent" : "agents") + team_units;
    }
    for (const Agent& agent : context.asked.mission.agents) {
        line += fmt::format("{} agent from {} to {}", shortened(agent.id), text(agent.start), text(agent.goal));
        if (context.asked.in_seconds && style.metres) {
            line += fmt::format(", {:.6g} m/s\n", agent.speed * context.map.cell_size);
        } else {
            line += times_are_lengths(context) ? "\n" : fmt::format(", {:.6g} cells per unit of time\n", agent.speed);
        }
    }
    const bool walking = style.metres && times_are_lengths(context);
    return line + fmt::format("lengths in cells, times in {}{}\n", time_unit(context),
                              walking ? " and in seconds at 1 m/s" : "");
}

// The rules beside how many removals there may be; empty where there are none.
std::string rules(const io::PlanContext& context) {
    const Rules& asked = context.asked.mission.rules;
    std::vector<std::string> parts;
    const auto counted = [](std::size_t count) { return fmt::format("{} obstacle{}", count, count == 1 ? "" : "s"); };
    if (asked.budget < INFINITY) {
        parts.push_back(context.asked.area_budget ? fmt::format("at most {:.6g} m\u00b2 demolished", asked.budget)
                                                  : fmt::format("removals that weigh at most {:.6g}", asked.budget));
    }
    if (asked.minimise_demolition == 0.0) parts.emplace_back("of the best plans the one that demolishes least");
    if (const double tolerance = asked.minimise_demolition.value_or(0); tolerance > 0) {
        parts.push_back(fmt::format("the least demolition within {:.3g} % of the best plan", 100 * tolerance));
    }
    if (!asked.protect.empty()) parts.push_back(counted(asked.protect.size()) + " protected");
    if (!asked.force.empty()) parts.push_back(counted(asked.force.size()) + " to be removed");
    return parts.empty() ? "" : fmt::format("asked for: {}\n", fmt::join(parts, "; "));
}

// The first column as wide in one table as in the next, so that they stand under each other.
Row columns(const std::string& what) {
    return {fmt::format("{:<16}", what), fmt::format("{:>8}", "before"), fmt::format("{:>8}", "after"),
            fmt::format("{:>8}", "change")};
}

// Lengths or times: by name, before and after. `unit` is what cell_size makes of them; empty: only cells.
struct Quantity {
    std::string name;
    std::optional<double> before;
    std::optional<double> after;
};

std::string quantities(const std::string& what, const std::vector<Quantity>& list, const std::string& unit,
                       double cell_size, bool bold) {
    std::vector<Row> rows{columns(what)};
    if (!unit.empty()) {
        for (const char* when : {"before", "after"}) rows.front().push_back(fmt::format("{} ({})", when, unit));
    }
    for (const auto& [name, before, after] : list) {
        rows.push_back({name, text(before, 3), text(after, 3), change(before, after)});
        if (unit.empty()) continue;
        for (const std::optional<double>& value : {before, after}) {
            rows.back().push_back(value ? fmt::format("{:.1f}", *value * cell_size) : nothing);
        }
    }
    return aligned(rows, bold) + "\n";
}

std::string searches(const Route& before, const Route& after, const io::PlanContext& context, bool bold) {
    std::vector<Row> rows{columns("ground search")};
    const auto add_count = [&](const std::string& name, std::uint64_t was, std::uint64_t is) {
        rows.push_back({name, std::to_string(was), std::to_string(is), change(double(was), double(is))});
    };
    add_count("nodes expanded", before.expanded, after.expanded);
    add_count("nodes generated", before.generated, after.generated);
    if (context.timing_fields) {
        rows.push_back({"search time (ms)", text(before.seconds * 1000, 3), text(after.seconds * 1000, 3),
                        change(before.seconds, after.seconds)});
    }
    return aligned(rows, bold) + "\n";
}

// Lengths and times in tables of their own: one is not the other.
std::string outcomes(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    const Outcome& before = plan.before;
    const Outcome& after = plan.after;
    const double cell_size = context.map.cell_size;
    const bool seconds = style.metres && times_are_lengths(context);
    std::vector<Quantity> times;
    for (const Objective time : render::shown_times(context.asked.mission.rules.objective)) {
        times.push_back(
            {std::string(render::name_of(time, context.asked.mission)), value(before, time), value(after, time)});
    }
    return quantities("length",
                      {{"path A (ground)", before.ground().length, after.ground().length},
                       {"path B (air)", before.air().length, after.air().length}},
                      style.metres ? "m" : "", cell_size, style.bold) +
           quantities(timed("time", context), times, seconds ? "s" : "", cell_size, style.bold) +
           searches(before.ground(), after.ground(), context, style.bold);
}

// In square metres, without the unit.
std::string area(std::uint32_t cells, const io::MapFile& map) {
    const std::string text = site::area_text(map.square_metres(cells));
    return text.substr(0, text.find(' '));
}

// "3 openings in 2 buildings, 640 m²"; empty where it would say nothing new.
std::string demolition(const Plan& plan, const io::MapFile& map) {
    if (!map.has_metres() && map.annotations.sections.empty()) return "";
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    const site::Demolition all = site::demolition(map.map, map.annotations.sections, removed);
    const std::string extent =
        map.has_metres() ? site::area_text(map.square_metres(all.cells)) : fmt::format("{} cells", all.cells);
    return site::removals_text(all, map.annotations.sections) + ", " + extent + "\n";
}

// "no plan within 0.5 % of the best demolishes less"
std::string least_demolition(const Plan& plan, const io::PlanContext& context) {
    if (!plan.least_demolition) return "";
    std::uint64_t cells = 0;
    for (const Breach& breach : plan.breaches) cells += breach.cells;
    const double percent = 100 * context.asked.mission.rules.minimise_demolition.value_or(0);
    const std::string as_good =
        percent == 0 ? "as good as the best" : fmt::format("within {:.3g} % of the best", percent);
    const std::uint64_t least = *plan.least_demolition;
    if (least == 0) {
        return fmt::format("of the plans {} that were found it demolishes least\n", as_good);
    }
    const io::MapFile& map = context.map;
    const std::string extent =
        map.has_metres() ? site::area_text(map.square_metres(least)) : fmt::format("{} cells", least);
    return fmt::format("no plan {} demolishes less{}\n", as_good, least == cells ? "" : " than " + extent);
}

std::string surface(const Plan& plan, const io::PlanContext& context) {
    const std::string line = io::surface_line(plan, context.asked.mission, context.map);
    return line.empty() ? "" : fmt::format("\n{}\n", line);
}

// Whether the bound proves that no plan is better.
bool is_best(const Plan& plan) {
    constexpr double rounding = 1e-9;
    return plan.gap.value_or(1) < rounding;
}

// What all removals save, by the figures as shown: what each saves does not add up to it. Of a team the figures without
// removals are those of each agent alone.
std::string saved_together(const Plan& plan, const Mission& mission) {
    if (mission.is_team()) return "";
    const auto shown = [&](const Outcome& o) {
        return std::round(1000 * value(o, mission.rules.objective).value_or(NAN)) / 1000;
    };
    const double saved = shown(plan.before) - shown(plan.after);
    return plan.breaches.size() > 1 && saved == saved ? fmt::format("together they save {:.3f}\n", saved) : "";
}

// Plan B: what is reached, and what is removed.
std::array<std::string, 2> if_failed(const Breach& breach) {
    if (!breach.if_failed) return {nothing, nothing};
    const auto& [objective, removed] = *breach.if_failed;
    if (objective == INFINITY) return {"no plan", nothing};
    std::string ids;
    for (const ObstacleId id : removed) ids += (ids.empty() ? "" : " ") + std::to_string(id.value);
    return {text(objective, 3), ids.empty() ? nothing : shortened(ids)};
}

std::string removals(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    const auto named = [](const Breach& breach) { return breach.source_id != 0; };
    const bool source_ids = std::any_of(plan.breaches.begin(), plan.breaches.end(), named);
    const bool explained =
        std::ranges::any_of(plan.breaches, [](const Breach& breach) { return breach.saves.has_value(); });
    const auto name_of = [&](const Breach& breach) { return context.map.annotations.name_of(breach.obstacle); };
    const bool names = !std::ranges::all_of(plan.breaches, &std::string_view::empty, name_of);
    const bool counted = context.asked.method.select == Selection::hits;
    std::vector<Row> rows{
        {"removed", "obstacle", "cells", "breach cell", timed("breached at", context), timed("entered at", context)}};
    if (counted) rows.front().insert(rows.front().begin() + 3, "hits");
    if (style.metres) rows.front().insert(rows.front().begin() + 3, "m\u00b2");
    const bool shared = std::ranges::any_of(plan.breaches, [](const Breach& breach) { return !breach.by.empty(); });
    if (explained) rows.front().push_back(timed("saves", context));
    const bool plan_b = std::ranges::any_of(plan.breaches, [](const Breach& b) { return b.if_failed.has_value(); });
    if (plan_b) rows.front().insert(rows.front().end(), {timed("if it fails", context), "removed then"});
    if (shared) rows.front().emplace_back("by");
    if (source_ids) rows.front().insert(rows.front().begin() + 2, "OSM id");
    if (names) rows.front().emplace_back("name");
    for (const Breach& breach : plan.breaches) {
        rows.push_back({std::to_string(rows.size()), std::to_string(breach.obstacle.value),
                        std::to_string(breach.cells), text(breach.at), text(breach.cleared_at, 3),
                        text(breach.entered_at, 3)});
        if (counted) rows.back().insert(rows.back().begin() + 3, std::to_string(breach.hits));
        if (style.metres) rows.back().insert(rows.back().begin() + 3, area(breach.cells, context.map));
        if (explained) rows.back().push_back(breach.saves == INFINITY ? "needed" : text(breach.saves, 3));
        if (plan_b) {
            for (const std::string& cell : if_failed(breach)) rows.back().push_back(cell);
        }
        if (shared) rows.back().push_back(shortened(breach.by));
        const std::string source_id = named(breach) ? std::to_string(breach.source_id) : nothing;
        if (source_ids) rows.back().insert(rows.back().begin() + 2, source_id);
        if (names) rows.back().push_back(shortened(name_of(breach)));
    }
    if (rows.size() > 1) {
        return aligned(rows, style.bold, names) + demolition(plan, context.map) + least_demolition(plan, context) +
               (explained ? saved_together(plan, context.asked.mission) : "");
    }
    if (context.asked.mission.rules.removals == 0) return "nothing removed, as asked for\n";
    if (context.asked.method.select == Selection::none) return "nothing removed: none was asked for\n";
    if (plan.limit_reached) return "nothing removed: no better plan was found in time\n";
    if (plan.least_demolition) {
        return fmt::format("nothing removed: no removal gains more than {:.3g} %\n",
                           100 * context.asked.mission.rules.minimise_demolition.value_or(0));
    }
    if (counted && context.asked.mission.rules.timing == Timing::ignore) {
        return "nothing removed: the search ran into no obstacle\n";
    }
    return is_best(plan) ? "nothing removed: no removal gains anything\n"
                         : "nothing removed: no removal was found that gains anything\n";
}

// Of a team in which nobody may breach.
std::string without_breachers(const Mission& mission) {
    return mission.rules.removals == 0 ? "" : "\nnothing is removed: no agent may breach\n";
}

// The objective as a person says it.
std::string words(Objective objective) {
    return objective == Objective::ground_makespan ? "ground agent's arrival" : std::string(to_string(objective));
}

// What each further removal saves.
std::string front(const io::PlanContext& context, const TableStyle& style) {
    if (context.front.empty()) return "";
    std::vector<Row> rows{{"removals", timed(words(context.asked.mission.rules.objective).c_str(), context),
                           timed("saves", context), "no plan below"}};
    if (style.metres) rows.front().emplace_back("m\u00b2");
    rows.front().emplace_back("obstacles");
    std::optional<double> before;
    for (const Plan& plan : context.front) {
        const std::optional<double> reached = value(plan.after, context.asked.mission.rules.objective);
        const std::optional<double> saves = before && reached ? std::optional(*before - *reached) : std::nullopt;
        std::vector<std::uint32_t> ids;
        std::uint32_t cells = 0;
        for (const Breach& breach : plan.breaches) {
            ids.push_back(breach.obstacle.value);
            cells += breach.cells;
        }
        std::ranges::sort(ids);
        rows.push_back({std::to_string(rows.size() - 1), text(reached, 3), text(saves, 3), text(plan.bound, 3)});
        if (style.metres) rows.back().push_back(area(cells, context.map));
        rows.back().push_back(ids.empty() ? nothing : fmt::format("{}", fmt::join(ids, " ")));
        before = reached;
    }
    return aligned(rows, style.bold) + "\n";
}

// What one removal more would gain.
std::string next(const Plan& plan, const io::PlanContext& context) {
    std::string lines;
    for (const NextBreach& next : plan.next) {
        const std::string_view name = context.map.annotations.name_of(next.obstacle);
        lines += fmt::format("\none removal more, obstacle {}{}, would save {:.3f}\n", next.obstacle.value,
                             name.empty() ? "" : fmt::format(" ({})", shortened(name)), next.saves);
    }
    return lines;
}

// How far the plan can be from the best.
std::string bound(const Plan& plan, const io::PlanContext& context) {
    const std::optional<double> reached = value(plan.after, context.asked.mission.rules.objective);
    if (!plan.bound || !plan.gap || !reached) return "";
    const std::string objective = words(context.asked.mission.rules.objective);
    const double gap = *plan.gap;
    const int n = context.asked.mission.removals_allowed();
    const std::string removals = n == 1 ? "1 removal" : fmt::format("{} removals", n);
    if (context.asked.mission.is_team()) {
        if (is_best(plan)) return fmt::format("\nno plan has a smaller {}\n", objective);
        return fmt::format("\nno {} is below {:.3f}: the gap is {:.2f} %\n", objective, *plan.bound, 100 * gap);
    }
    if (is_best(plan)) return fmt::format("\nno plan with at most {} has a smaller {}\n", removals, objective);
    return fmt::format("\nno {} is below {:.3f} with at most {}: the gap is {:.2f} %\n", objective, *plan.bound,
                       removals, 100 * gap);
}

// That there may be a better plan.
std::string limit(const Plan& plan) {
    if (!plan.limit_reached) return "";
    return "\na limit ended the choice: a better plan may exist; see --time-limit and --expansion-limit\n";
}

// The paper's choice of obstacles can be worse than none. Zones that hold for a time are not asked before removal.
std::string warning(const Plan& plan, const io::PlanContext& context) {
    const std::optional<double> before = value(plan.before, context.asked.mission.rules.objective);
    const std::optional<double> after = value(plan.after, context.asked.mission.rules.objective);
    const bool is_timed = std::ranges::any_of(context.asked.mission.rules.zones, &Zone::has_window);
    if (!before || !after || *after <= *before) return "";
    if (is_timed) return "\nnote: figures before removal are those without the zones that hold for a time\n";
    if (context.asked.mission.is_team()) return "";
    return fmt::format("\nnote: this plan is worse than removing nothing: {} {:.3f} instead of {:.3f}\n",
                       words(context.asked.mission.rules.objective), *after, *before);
}

}  // namespace

std::string plan_table(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    if (context.asked.mission.is_team()) {
        const auto breaches = [](const Agent& agent) { return agent.kind == AgentKind::air || agent.own_breaches > 0; };
        const bool may_remove =
            context.asked.mission.rules.removals > 0 && std::ranges::any_of(context.asked.mission.agents, breaches);
        return heading(context, style) + rules(context) + "\n" + front(context, style) +
               team_table(plan, context, style) +
               (may_remove ? "\n" + removals(plan, context, style) : without_breachers(context.asked.mission)) +
               next(plan, context) + (context.asked.method.explain ? waits(plan, context) : "") +
               ranges_left(plan, context, style) + out_of_range(plan, context, style) + surface(plan, context) +
               bound(plan, context) + limit(plan) + warning(plan, context);
    }
    return heading(context, style) + rules(context) + "\n" + front(context, style) + outcomes(plan, context, style) +
           removals(plan, context, style) + next(plan, context) + waits(plan, context) +
           ranges_left(plan, context, style) + out_of_range(plan, context, style) + surface(plan, context) +
           bound(plan, context) + limit(plan) + warning(plan, context);
}

}  // namespace waybreaker::apps

#include "plan_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace waybreaker::apps {
namespace {

using Row = std::vector<std::string>;

const std::string nothing = "-";

// The first column to the left, the others to the right; the first row is the heading.
std::string aligned(const std::vector<Row>& rows, bool bold) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string table;
    for (const Row& row : rows) {
        std::string line = fmt::format("{:<{}}", row[0], widths[0]);
        for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format("  {:>{}}", row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        table += bold && &row == &rows.front() ? fmt::format("\033[1m{}\033[0m\n", line) : line + "\n";
    }
    return table;
}

std::string text(std::optional<double> value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : nothing;
}

std::string text(Cell c) {
    return fmt::format("{},{}", c.x, c.y);
}

std::string change(std::optional<double> before, std::optional<double> after) {
    if (!before || !after) return "";
    if (*before == *after) return "same";
    if (*before <= 0) return "";
    return fmt::format("{:+.1f} %", 100 * (*after / *before - 1));
}

// One line on the map and the mission.
std::string heading(const io::PlanContext& context, const TableStyle& style) {
    const Map& map = context.map.map;
    std::string line = fmt::format("{}: {} x {} cells", context.map.source, map.width(), map.height());
    if (style.metres) line += fmt::format(" of {:.6g} m", context.map.cell_size);
    line += fmt::format(", {} {}\n", map.obstacles().size(), map.obstacles().size() == 1 ? "obstacle" : "obstacles");
    for (const Agent& agent : context.mission.agents) {
        line += fmt::format("{} agent from {} to {}\n", agent.id, text(agent.start), text(agent.goal));
    }
    return line;
}

std::string outcomes(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::vector<Row> rows{{"", "before", "after", "change"}};
    if (style.metres) rows.front().insert(rows.front().end(), {"before (m)", "after (m)"});
    const auto add_length = [&](const std::string& name, std::optional<double> before, std::optional<double> after) {
        rows.push_back({name, text(before, 3), text(after, 3), change(before, after)});
        if (!style.metres) return;
        for (const std::optional<double>& length : {before, after}) {
            rows.back().push_back(length ? fmt::format("{:.1f}", *length * context.map.cell_size) : nothing);
        }
    };
    const Outcome& before = plan.before;
    const Outcome& after = plan.after;
    const auto add_count = [&](const std::string& name, std::uint64_t Outcome::Ground::*count) {
        const auto was = before.ground.*count;
        const auto is = after.ground.*count;
        rows.push_back({name, std::to_string(was), std::to_string(is), change(double(was), double(is))});
    };
    add_length("path A (ground)", before.ground.length, after.ground.length);
    add_count("nodes expanded", &Outcome::Ground::expanded);
    add_count("nodes generated", &Outcome::Ground::generated);
    if (context.timing_fields) {
        rows.push_back({"search time (ms)", text(before.ground.seconds * 1000, 3), text(after.ground.seconds * 1000, 3),
                        change(before.ground.seconds, after.ground.seconds)});
    }
    add_length("path B (air)", before.air.length, after.air.length);
    add_length("flowtime", before.flowtime, after.flowtime);
    add_length("makespan", before.makespan, after.makespan);
    return aligned(rows, style.bold);
}

std::string removals(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    const auto named = [](const Removal& removal) { return removal.source_id != 0; };
    const bool source_ids = std::any_of(plan.removed.begin(), plan.removed.end(), named);
    std::vector<Row> rows{{"removed", "obstacle", "cells", "hits", "breach cell", "breached at", "entered at"}};
    if (source_ids) rows.front().insert(rows.front().begin() + 2, "OSM id");
    for (const Removal& removal : plan.removed) {
        rows.push_back({std::to_string(rows.size()), std::to_string(removal.obstacle.value),
                        std::to_string(removal.cells), std::to_string(removal.hits), text(removal.at),
                        text(removal.cleared_at, 3), text(removal.entered_at, 3)});
        if (!source_ids) continue;
        rows.back().insert(rows.back().begin() + 2, named(removal) ? std::to_string(removal.source_id) : nothing);
    }
    if (rows.size() > 1) return aligned(rows, style.bold);
    return context.options.removals == 0 ? "nothing removed, as asked for\n"
                                         : "nothing removed: the search ran into no obstacle\n";
}

// The paper's choice of obstacles can be worse than none.
std::string warning(const Plan& plan, const io::PlanContext& context) {
    const bool makespan = context.options.objective == Objective::makespan;
    const std::optional<double> before = makespan ? plan.before.makespan : plan.before.flowtime;
    const std::optional<double> after = makespan ? plan.after.makespan : plan.after.flowtime;
    if (!before || !after || *after <= *before) return "";
    return fmt::format("\nnote: this plan is worse than removing nothing: {} {:.3f} instead of {:.3f}\n",
                       makespan ? "makespan" : "flowtime", *after, *before);
}

}  // namespace

std::string plan_table(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    return heading(context, style) + "\n" + outcomes(plan, context, style) + "\n" + removals(plan, context, style) +
           warning(plan, context);
}

}  // namespace waybreaker::apps

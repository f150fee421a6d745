#include "range_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/range.hpp"
#include "option.hpp"
#include "table.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

constexpr Range ranges{1e-6, 1e12};  // cells, or units of time
const Units range_units{{"km", 1000}, {"m", 1}};

// "900 m", "375 cells": of a flight that takes so long.
std::string distance_text(const Agent& agent, double time, const io::PlanContext& context, const TableStyle& style) {
    const double cells = time * agent.speed;
    return style.metres ? fmt::format("{:.6g} m", cells * context.map.cell_size) : fmt::format("{:.6g} cells", cells);
}

std::string time_text(double time, const io::PlanContext& context) {
    return fmt::format("{:.6g} {}", time, context.asked.in_seconds ? "s" : "units of time");
}

}  // namespace

void add_range_options(CLI::App& command, PlanOptions& options) {
    add_measure(
        command, "--range", options.range, ranges, range_units, "LENGTH",
        "The longest flight of each aircraft from its start to its goal, in cells, or as 900m or 1.2km; to hover "
        "counts as to fly at its speed (default: any)");
    add_measure(command, "--endurance", options.endurance, ranges, time_units, "TIME",
                "The same as a time, in units of time, or as 90s or 15min (default: any)");
    const auto read = [&options](const std::string& given) {
        options.reserve = share_from(given);
        if (!options.reserve || *options.reserve == 1) {
            throw CLI::ValidationError(
                "--reserve", fmt::format("'{}' is not a share from 0 to below 1, such as 0.2 or 20%", shown(given)));
        }
    };
    command
        .add_option_function<std::string>(
            "--reserve", read, "The share of range and endurance that is not planned with, such as 20% (default: 0)")
        ->type_name("SHARE");
}

void set_ranges(const PlanOptions& options, const io::MapFile& map, io::MissionDocument& document) {
    if (!options.range && !options.endurance && !options.reserve) return;
    bool flies = false;
    for (Agent& agent : document.mission.agents) {
        if (agent.kind == AgentKind::ground) continue;
        flies = true;
        if (options.range) agent.range = in_cells(*options.range, map, ranges);
        if (options.endurance) agent.endurance = options.endurance->value;
        agent.reserve = options.reserve.value_or(agent.reserve);
    }
    if (!flies) throw InputError("--range, --endurance and --reserve are for aircraft, and the mission has none");
}

std::string ranges_left(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::string lines;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Agent& agent = context.asked.mission.agents[i];
        const double flown = plan.agents[i].path.back().t - agent.ready_at;
        const auto add = [&](const std::string& left, const std::string& all) {
            const std::string reserve =
                agent.reserve > 0 ? fmt::format(", {:.6g} % are to be in reserve", 100 * agent.reserve) : "";
            lines += fmt::format("{} lands with {} of {} left{}\n", shortened(agent.id), left, all, reserve);
        };
        if (std::isfinite(agent.range)) {
            const double time = agent.range / agent.speed;
            add(distance_text(agent, std::max(time - flown, 0.0), context, style),
                distance_text(agent, time, context, style));
        }
        if (std::isfinite(agent.endurance)) {
            add(time_text(std::max(agent.endurance - flown, 0.0), context), time_text(agent.endurance, context));
        }
    }
    return lines.empty() ? "" : "\n" + lines;
}

std::string out_of_range(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::string lines;
    for (const OutOfRange& far : plan.out_of_range) {
        const auto agent = std::ranges::find(context.asked.mission.agents, far.agent, &Agent::id);
        if (agent == context.asked.mission.agents.end()) continue;
        const bool by_range = agent->range / agent->speed <= agent->endurance;
        const auto figure = [&](double time) {
            return by_range ? distance_text(*agent, time, context, style) : time_text(time, context);
        };
        lines +=
            fmt::format("{} can fly {}{}; obstacle {} and back {} {}\n", shortened(far.agent), by_range ? "" : "for ",
                        figure(far.longest), far.obstacle.value, by_range ? "is" : "takes", figure(far.flight));
    }
    return lines.empty() ? "" : "\n" + lines;
}

}  // namespace waybreaker::apps

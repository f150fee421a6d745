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
constexpr Range recharge_times{1e-6, most_breach_time};
const Units range_units{{"km", 1000}, {"m", 1}};

// What times of an aircraft's flight are said in: how far it flies in a unit of time, or themselves.
struct FlightUnit {
    double size;
    std::string name;
};

FlightUnit distance_unit(const Agent& agent, const io::PlanContext& context, const TableStyle& style) {
    if (style.metres) return {agent.speed * context.map.cell_size, "m"};
    return {agent.speed, "cells"};
}

FlightUnit time_unit_of(const io::PlanContext& context) {
    return {1, context.asked.in_seconds ? "s" : "units of time"};
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
    add_measure(
        command, "--recharge", options.recharge, recharge_times, time_units, "TIME",
        "Aircraft land at bases on the way, and take off so much later with a full battery, in units of time, or "
        "as 90s or 15min; --range and --endurance are then from one landing to the next (default: each flies "
        "once)");
    add_places(command, "--base", options.bases,
               "Where aircraft recharge; more of them with more --base (default: at their starts and goals)");
}

void set_ranges(const PlanOptions& options, const io::MapFile& map, io::MissionDocument& document) {
    if (!options.range && !options.endurance && !options.reserve && !options.recharge && options.bases.empty()) return;
    const auto require = [](bool holds, const char* option, const char* needed) {
        if (!holds) throw InputError(fmt::format("{} needs {}", option, needed));
    };
    bool flies = false;
    for (Agent& agent : document.mission.agents) {
        if (agent.kind == AgentKind::ground) continue;
        flies = true;
        if (options.range) agent.range = in_cells(*options.range, map, ranges);
        if (options.endurance) agent.endurance = options.endurance->value;
        agent.reserve = options.reserve.value_or(agent.reserve);
        if (options.recharge) agent.recharge = options.recharge->value;
        const bool ends = std::isfinite(agent.range) || std::isfinite(agent.endurance);
        require(!options.reserve || agent.reserve == 0 || ends, "--reserve", "--range or --endurance");
        require(!options.recharge || ends, "--recharge", "--range or --endurance");
        require(options.bases.empty() || agent.recharge, "--base", "--recharge");
    }
    if (!flies)
        throw InputError(
            "--range, --endurance, --reserve, --recharge and --base are for aircraft, and the mission has none");
}

std::string ranges_left(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::string lines;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Agent& agent = context.asked.mission.agents[i];
        const std::vector<Recharge>& recharges = plan.agents[i].recharges;
        const double landed = plan.agents[i].path.back().t;
        const double last = recharges.empty() ? agent.flown + landed - agent.ready_at : landed - recharges.back().until;
        const auto add = [&](double all, const FlightUnit& unit) {
            const auto left = [&](double flown) {
                return fmt::format("{:.6g} of {:.6g} {} left", std::max(all - flown, 0.0) * unit.size, all * unit.size,
                                   unit.name);
            };
            for (const Recharge& recharge : recharges) {
                lines += fmt::format("{} recharges at {},{}, from {:.3f} to {:.3f}, with {}\n", shortened(agent.id),
                                     recharge.at.x, recharge.at.y, recharge.from, recharge.until, left(recharge.flown));
            }
            const std::string reserve =
                agent.reserve > 0 ? fmt::format(", {:.6g} % are to be in reserve", 100 * agent.reserve) : "";
            lines += fmt::format("{} lands with {}{}\n", shortened(agent.id), left(last), reserve);
        };
        if (std::isfinite(agent.range)) add(agent.range / agent.speed, distance_unit(agent, context, style));
        if (std::isfinite(agent.endurance)) add(agent.endurance, time_unit_of(context));
    }
    return lines.empty() ? "" : "\n" + lines;
}

std::string out_of_range(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::string lines;
    for (const OutOfRange& far : plan.out_of_range) {
        const auto agent = std::ranges::find(context.asked.mission.agents, far.agent, &Agent::id);
        if (agent == context.asked.mission.agents.end()) continue;
        const bool by_range = agent->range / agent->speed <= agent->endurance;
        const FlightUnit unit = by_range ? distance_unit(*agent, context, style) : time_unit_of(context);
        lines += fmt::format("{} can fly {}{:.6g} {}; obstacle {} and back {} {:.6g} {}\n", shortened(far.agent),
                             by_range ? "" : "for ", far.longest * unit.size, unit.name, far.obstacle.value,
                             by_range ? "is" : "takes", far.flight * unit.size, unit.name);
    }
    return lines.empty() ? "" : "\n" + lines;
}

}  // namespace waybreaker::apps

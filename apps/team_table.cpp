#include "team_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "model/timeline.hpp"
#include "render/caption.hpp"
#include "table.hpp"

namespace waybreaker::apps {
namespace {

double waited(const Itinerary& agent) {
    double all = 0;
    for (const Wait& wait : stands(agent)) all += wait.until - wait.from;
    return all;
}

// How many, and what they count for.
std::string reached(const Plan& plan, const Mission& mission) {
    if (!mission.rules.unreached) return "";
    std::size_t vehicles = 0;
    std::size_t arrived = 0;
    double all = 0;
    double weight = 0;
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        if (plan.agents[i].kind == AgentKind::air) continue;
        ++vehicles;
        all += mission.agents[i].weight;
        if (!plan.agents[i].reached) continue;
        ++arrived;
        weight += mission.agents[i].weight;
    }
    return fmt::format("\n{} of {} ground agents get there by {:g}: {:g} of {:g} by weight\n", arrived, vehicles,
                       *mission.rules.unreached, weight, all);
}

std::string reason(const Wait& wait, const io::MapFile& map, const Rules& rules) {
    const std::string_view name = wait.obstacle ? map.annotations.name_of(wait.obstacle) : std::string_view();
    const std::string named = name.empty() ? "" : fmt::format(" ({})", shortened(name));
    switch (wait.reason) {
        case WaitReason::readiness:
            return ", until it is ready";
        case WaitReason::opening:
            return fmt::format(", until {} has opened {}{}", shortened(wait.agent), wait.obstacle.value, named);
        case WaitReason::rubble:
            return fmt::format(", for the rubble of {}{}", wait.obstacle.value, named);
        case WaitReason::agent:
            return fmt::format(", for {}", shortened(wait.agent));
        case WaitReason::zone:
            if (wait.zone == 0 || wait.zone > rules.zones.size()) break;
            return fmt::format(", for {}", name_of(rules.zones[wait.zone - 1], wait.zone));
        case WaitReason::nothing:
            break;
    }
    return ", though it could go on";
}

}  // namespace

std::string team_table(const Plan& plan, const io::PlanContext& context, const TableStyle& style) {
    std::vector<Row> rows{
        {"agent", "from", "to", "alone", "length", timed("arrival", context), timed("wait", context)}};
    if (context.asked.method.explain) rows.front().push_back(timed("gain", context));
    for (std::size_t i = 0; i < plan.agents.size(); ++i) {
        const Itinerary& agent = plan.agents[i];
        rows.push_back({shortened(agent.id), text(agent.start), text(agent.goal), text(plan.before.routes[i].length, 3),
                        text(plan.after.routes[i].length, 3), agent.reached ? text(agent.path.back().t, 3) : "-",
                        agent.reached ? text(waited(agent), 3) : "-"});
        if (context.asked.method.explain) rows.back().push_back(text(agent.gain, 3));
    }
    const double cell_size = context.map.cell_size;
    const bool seconds = style.metres && times_are_lengths(context);
    std::vector<Row> times{{timed("time", context), "alone", "together", "change"}};
    if (seconds) times.front().emplace_back("together (s)");
    const auto add = [&](std::string_view name, std::optional<double> alone, std::optional<double> together) {
        times.push_back({std::string(name), text(alone, 3), text(together, 3), change(alone, together)});
        if (seconds) times.back().push_back(fmt::format("{:.1f}", together.value_or(0) * cell_size));
    };
    for (const Objective time : render::shown_times(context.asked.mission.rules.objective)) {
        add(render::name_of(time, context.asked.mission), value(plan.before, time), value(plan.after, time));
    }
    return aligned(rows, style.bold) + "\n" + aligned(times, style.bold) + reached(plan, context.asked.mission);
}

std::string waits(const Plan& plan, const io::PlanContext& context) {
    const bool explained = context.asked.method.explain || context.asked.mission.rules.rubble > 0;
    double all = 0;
    std::vector<std::string> lines;
    for (const Itinerary& agent : plan.agents) {
        if (agent.kind != AgentKind::ground || !agent.reached) continue;
        for (const Wait& wait : explained ? agent.waits : stands(agent)) {
            all += wait.until - wait.from;
            lines.push_back(fmt::format("{} agent waits {:.3f} at {:g},{:g}, from {:.3f} to {:.3f}{}\n",
                                        shortened(agent.id), wait.until - wait.from, wait.at.x, wait.at.y, wait.from,
                                        wait.until,
                                        explained ? reason(wait, context.map, context.asked.mission.rules) : ""));
        }
    }
    if (lines.size() > 1 && !context.asked.mission.is_team())
        lines.push_back(fmt::format("it waits {:.3f} in all\n", all));
    return lines.empty() ? "" : fmt::format("\n{}", fmt::join(lines, ""));
}

}  // namespace waybreaker::apps

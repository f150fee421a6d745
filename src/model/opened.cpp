#include "model/opened.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "model/timeline.hpp"
#include "waybreaker/map_edit.hpp"

namespace waybreaker {

OpenedByThemselves::OpenedByThemselves(const Map& map, const Mission& mission) : map_(map), mission_(mission) {
    Rules& rules = mission_.rules;
    if (rules.opened.empty()) return;
    double first_move = std::numeric_limits<double>::infinity();
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::ground) first_move = std::min(first_move, agent.ready_at);
    }
    // Rubble is left of what opens however early.
    const auto never_stands = [&](const TimedOpening& opening) {
        return rules.timing == Timing::ignore || (opening.at <= first_move && rules.rubble == 0);
    };
    std::vector<MapEdit> edits;
    for (const TimedOpening& opening : rules.opened) {
        std::erase(rules.protect, opening.obstacle);
        if (never_stands(opening) && !map.obstacle(opening.obstacle).gone())
            edits.push_back(MapEdit::remove(opening.obstacle));
    }
    // What is gone already does not open.
    std::erase_if(rules.opened, [&](const TimedOpening& opening) {
        return never_stands(opening) || map.obstacle(opening.obstacle).gone();
    });
    if (!edits.empty()) opened_ = map.with(edits);
}

std::optional<ObstacleId> most_waited_for(const Map& map, const Agent& agent, std::span<const Point> path,
                                          std::span<const TimedOpening> openings) {
    const std::vector<Waypoint> driven = timed(path, agent.speed, agent.ready_at);
    std::optional<ObstacleId> most;
    double longest = 0;
    for (const TimedOpening& opening : openings) {
        const auto touched = first_touch(map, opening.obstacle, driven, standing_radius(agent.body));
        if (!touched || opening.at - *touched <= longest) continue;
        longest = opening.at - *touched;
        most = opening.obstacle;
    }
    return most;
}

}  // namespace waybreaker

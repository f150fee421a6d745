#include "mission/entries.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "model/timeline.hpp"

namespace waybreaker {

void add_entries(const Map& map, const Mission& mission, Plan& plan) {
    for (Breach& breach : plan.breaches) {
        breach.entered_at.reset();
        for (std::size_t i = 0; i < plan.agents.size(); ++i) {
            if (plan.agents[i].kind == AgentKind::air) continue;
            const auto entered = first_touch(map, breach.obstacle, plan.agents[i].path, mission.agents[i].body.reach());
            if (entered && (!breach.entered_at || *entered < *breach.entered_at)) breach.entered_at = entered;
        }
        if (breach.entered_at && mission.rules.timing == Timing::enforce)
            breach.entered_at = std::max(*breach.entered_at, breach.cleared_at);
    }
}

}  // namespace waybreaker

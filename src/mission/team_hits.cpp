#include "mission/team_hits.hpp"

#include <algorithm>
#include <limits>

#include "drive/opening.hpp"

namespace waybreaker {

std::vector<std::uint32_t> hits_of_team(const Map& map, const Mission& mission, const Method& method,
                                        const team::Interrupts& interrupts, Searcher& searcher) {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    std::vector<ObstacleId> opened;
    for (const TimedOpening& opening : mission.rules.opened) opened.push_back(opening.obstacle);
    std::vector<std::uint32_t> all(map.obstacles().size() + 1, 0);
    for (const Agent& agent : mission.agents) {
        if (agent.kind != AgentKind::ground) continue;
        const Trip trip{map,
                        agent,
                        search_options(method, agent.body),
                        interrupts.deadline,
                        interrupts.expansions,
                        interrupts.stop};
        SearchOptions counting = trip.by_cells();
        counting.count_hits = true;
        const SearchResult search = searcher.find(OpenedMap(map, opened), agent.start, agent.goal, counting);
        for (std::size_t id = 0; id < search.hits.size(); ++id) all[id] += std::min(search.hits[id], most - all[id]);
    }
    return all;
}

}  // namespace waybreaker

#include "experiment/missions.hpp"

#include <utility>

#include "core/random.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

constexpr int draws_for_a_pair = 1'000'000;
constexpr double bucket_size = 4;  // of MovingAI scenarios, in cells of length

// Different for different maps, so that one seed does not draw the same pairs on all of them.
std::uint64_t fingerprint(const Grid& grid) {
    std::uint64_t hash = Random(std::uint64_t(grid.width()) << 32 | std::uint64_t(grid.height())).next();
    for (int y = 0; y < grid.height(); ++y) {
        for (std::size_t i = 0; i < grid.words_per_row(); ++i) hash = Random(hash ^ grid.row(y)[i]).next();
    }
    return hash;
}

std::pair<Cell, Cell> draw_pair(const Map& map, double min_distance, Random& random) {
    const auto draw = [&] { return Cell{random.below(map.width()), random.below(map.height())}; };
    for (int i = 0; i < draws_for_a_pair; ++i) {
        const Cell start = draw();
        const Cell goal = draw();
        if (distance(start, goal) <= min_distance) continue;
        if (!map.grid().blocked(start) && !map.grid().blocked(goal)) return {start, goal};
    }
    throw InputError("no two free cells that lie far enough apart were found in " + std::to_string(draws_for_a_pair) +
                     " draws: lower --min-distance");
}

bool has_room(const Map& map, const Mission& mission) {
    try {
        validate(map, mission);
    } catch (const InputError&) {
        return false;
    }
    return true;
}

}  // namespace

DrawnMissions draw_missions(const Map& map, const MissionRules& rules) {
    Random random(fingerprint(map.grid()) ^ rules.seed);
    const OpenedMap closed(map);
    Searcher searcher;
    DrawnMissions missions;
    for (int i = 0; i < rules.pairs; ++i) {
        const auto [start, goal] = draw_pair(map, rules.min_distance, random);
        ++missions.drawn;
        const SearchResult way = searcher.find(closed, start, goal, {.planner = Algorithm::theta});
        if (way.status != SearchStatus::found) {
            ++missions.without_way;
        } else if (way.length > (1 + rules.min_detour) * distance(start, goal)) {
            const double octile = searcher.find(closed, start, goal, {.planner = Algorithm::astar}).length;
            missions.kept.push_back({.bucket = int(octile / bucket_size),
                                     .map = {},
                                     .width = map.width(),
                                     .height = map.height(),
                                     .start = start,
                                     .goal = goal,
                                     .optimal_length = octile});
        }
    }
    return missions;
}

std::vector<Mission> teams_of(const Map& map, std::span<const Scenario> pairs, const TeamSize& size,
                              const Rules& rules) {
    std::vector<Mission> teams;
    Mission team;
    team.rules = rules;
    for (const Scenario& pair : pairs) {
        Agent& vehicle = team.agents.emplace_back();
        vehicle.id = std::to_string(team.agents.size());
        vehicle.start = pair.start;
        vehicle.goal = pair.goal;
        if (!has_room(map, team)) team.agents.pop_back();
        if (int(team.agents.size()) < size.vehicles) continue;
        for (int i = 0; i < size.aircraft; ++i) {
            Agent aircraft = team.agents[std::size_t(i % size.vehicles)];
            aircraft.id = "air" + std::to_string(i + 1);
            aircraft.kind = AgentKind::air;
            team.agents.push_back(std::move(aircraft));
        }
        teams.push_back(team);
        team.agents.clear();
    }
    return teams;
}

}  // namespace waybreaker::experiment

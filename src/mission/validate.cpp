// Missions that can be put on a map, and the paper's way to set one up.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/range.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {
namespace {

std::string text(Cell c) {
    return std::to_string(c.x) + "," + std::to_string(c.y);
}

// The nearest cell, in rings around `at`, where the agent can stand.
std::optional<Cell> nearest_place(const OpenedMap& map, Cell at, const Motion& motion) {
    const int rings = std::max(map.width(), map.height());
    for (int ring = 1; ring <= rings; ++ring) {
        std::optional<Cell> best;
        for (int dy = -ring; dy <= ring; ++dy) {
            const int stride = std::abs(dy) == ring ? 1 : 2 * ring;
            for (int dx = -ring; dx <= ring; dx += stride) {
                const Cell c{at.x + dx, at.y + dy};
                if (!map.map().grid().contains(c) || !fits(map, c, motion)) continue;
                if (!best || distance(c, at) < distance(*best, at)) best = c;
            }
        }
        if (best) return best;
    }
    return std::nullopt;
}

void validate_place(const OpenedMap& map, const Agent& agent, Cell at, const std::string& what, const Motion& motion) {
    const std::string where = "the " + agent.id + " agent's " + what + " " + text(at);
    if (!map.map().grid().contains(at)) {
        throw InputError(where + " is off the map: x goes from 0 to " + std::to_string(map.width() - 1) +
                         ", y from 0 to " + std::to_string(map.height() - 1));
    }
    if (agent.kind == AgentKind::air || fits(map, at, motion)) return;
    const ObstacleId obstacle = map.map().obstacle_at(at);
    const std::string reason = obstacle ? " lies inside obstacle " + std::to_string(obstacle.value)
                                        : " leaves no room for a radius of " + number_text(motion.radius);
    const std::optional<Cell> place = nearest_place(map, at, motion);
    throw InputError(where + reason +
                     (place ? "; a free cell near it is " + text(*place) : "; the map has no free cell"));
}

// Precondition: all ids are those of obstacles, and there are weights for all or none.
void validate_forced(const Map& map, const MissionOptions& options) {
    double weight = 0;
    for (auto id = options.force.begin(); id != options.force.end(); ++id) {
        const std::string who = "obstacle " + std::to_string(id->value) + " is to be removed in any case, but ";
        if (std::find(options.force.begin(), id, *id) != id) throw InputError(who + "named twice");
        if (!map.obstacle(*id).destructible) throw InputError(who + "cannot be destroyed");
        if (std::ranges::count(options.protect, *id) > 0) throw InputError(who + "protected as well");
        weight += options.weights.empty() ? 1 : options.weights[id->value];
    }
    if (options.force.size() > std::size_t(options.removals)) {
        throw InputError("at most " + std::to_string(options.removals) + " obstacles may be removed, but " +
                         std::to_string(options.force.size()) + " are to be in any case");
    }
    if (!options.force.empty() && weight > options.budget) {
        throw InputError("the obstacles to be removed in any case weigh " + number_text(weight) +
                         ", more than the budget of " + number_text(options.budget));
    }
}

void validate(const Map& map, const MissionOptions& options) {
    if (options.removals < 0) throw InputError("the number of removals cannot be negative");
    require_range(options.breach_time.per_obstacle, 0, most_breach_time, "the time of a breach");
    require_range(options.breach_time.per_cell, 0, most_breach_time, "the time of a breach for each cell");
    const std::size_t obstacles = map.obstacles().size();
    const auto require_known = [&](ObstacleId id, const std::string& purpose) {
        if (id && id.value <= obstacles) return;
        throw InputError("there is no obstacle " + std::to_string(id.value) + " to " + purpose + ": the map has " +
                         std::to_string(obstacles));
    };
    for (const ObstacleId id : options.protect) require_known(id, "protect");
    for (const ObstacleId id : options.force) require_known(id, "force");
    if (!options.weights.empty() && options.weights.size() != obstacles + 1) {
        throw InputError("weights are needed for all " + std::to_string(obstacles) + " obstacles, by id, not for " +
                         std::to_string(options.weights.size() - 1));
    }
    for (std::size_t id = 1; id < options.weights.size(); ++id) {
        require_range(options.weights[id], least_weight, most_weight, "the weight of obstacle " + std::to_string(id));
    }
    validate_forced(map, options);
    if (!(options.budget >= 0)) throw InputError("the budget cannot be " + number_text(options.budget));
    if (!(options.time_limit > 0)) throw InputError("the time limit must be above 0 seconds");
}

}  // namespace

Mission ground_and_air(Cell start, Cell goal) {
    return {{{.id = "ground", .kind = AgentKind::ground, .start = start, .goal = goal},
             {.id = "air", .kind = AgentKind::air, .start = start, .goal = goal}}};
}

Planner planner_of(const MissionOptions& options) {
    const Motion& motion = options.search.motion;
    const bool own_agent =
        motion.corners == Corners::none && motion.diagonal && (motion.radius == 0.5 || motion.radius == 0);
    const bool possible = options.select == Selection::exact && own_agent;
    return options.search.planner == Planner::optimal && !possible ? Planner::theta : options.search.planner;
}

MissionOptions paper_options(int removals) {
    MissionOptions options;
    options.removals = removals;
    return paper_options(std::move(options));
}

MissionOptions paper_options(MissionOptions options) {
    options.select = Selection::hits;
    options.search.planner = Planner::theta;
    options.timing = Timing::ignore;
    // For one obstacle the paper flies the shortest way past it, which is what `optimal` does.
    options.flight = options.removals == 1 ? FlightRule::optimal : FlightRule::nearest;
    return options;
}

void validate(const Map& map, const Mission& mission, const MissionOptions& options) {
    SearchOptions search = options.search;
    search.planner = planner_of(options);
    validate(search);
    validate(map, options);
    // A point stands wherever its cell is free.
    const Motion motion = search.planner == Planner::optimal ? Motion{} : search.motion;
    int ground_agents = 0;
    int air_agents = 0;
    const OpenedMap closed(map);
    for (const Agent& agent : mission.agents) {
        ++(agent.kind == AgentKind::ground ? ground_agents : air_agents);
        require_range(agent.speed, least_speed, most_speed, "the " + agent.id + " agent's speed");
        validate_place(closed, agent, agent.start, "start", motion);
        validate_place(closed, agent, agent.goal, "goal", motion);
    }
    if (ground_agents != 1 || air_agents != 1) {
        throw InputError("a mission has one ground agent and one air agent, not " + std::to_string(ground_agents) +
                         " and " + std::to_string(air_agents));
    }
}

}  // namespace waybreaker

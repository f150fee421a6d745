#include "live/state.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::live {
namespace {

[[noreturn]] void refuse(ErrorCode code, const std::string& subject, const std::string& what) {
    throw InputError(code, subject, what);
}

void require_obstacle(const Map& map, ObstacleId id, const char* what) {
    if (id.value >= 1 && id.value <= map.obstacles().size()) return;
    refuse(ErrorCode::unknown_obstacle, std::to_string(id.value),
           std::string(what) + " obstacle " + std::to_string(id.value) + ": the map has none of that id");
}

// Whether a breach of that obstacle had begun before the plan was made, which counts on it.
bool had_begun(const Mission& mission, const Plan& plan, const TimedOpening& opening) {
    const auto counted_on = std::ranges::find(mission.rules.opened, opening.obstacle, &TimedOpening::obstacle);
    return counted_on != mission.rules.opened.end() && plan.revised && counted_on->at >= plan.revised->now &&
           counted_on->at > 0;
}

void validate(const Map& map, const Mission& mission, const Plan& plan, const AgentState& agent) {
    const auto planned = std::ranges::find(plan.agents, agent.id, &Itinerary::id);
    if (planned == plan.agents.end())
        refuse(ErrorCode::other, agent.id, "the state names agent " + agent.id + ", which the plan does not have");
    if (agent.passed >= planned->path.size()) {
        refuse(ErrorCode::out_of_range, agent.id,
               "agent " + agent.id + " has passed point " + std::to_string(agent.passed) + " of its path, which has " +
                   std::to_string(planned->path.size()) + ", counted from 0");
    }
    if (agent.at) {
        require_range(agent.at->x, -0.5, map.width() - 0.5, "x of agent " + agent.id);
        require_range(agent.at->y, -0.5, map.height() - 0.5, "y of agent " + agent.id);
    }
    if (agent.goal && !map.grid().contains(*agent.goal))
        refuse(ErrorCode::off_map, agent.id, "the new goal of agent " + agent.id + " is off the map");
    if (agent.flown) {
        require_range(*agent.flown, 0, most_breach_time, "the time that agent " + agent.id + " has flown");
        if (planned->kind == AgentKind::ground)
            refuse(ErrorCode::contradiction, agent.id, "agent " + agent.id + " drives, and is said to have flown");
    }
    const auto has_begun = [&](const TimedOpening& opening) { return had_begun(mission, plan, opening); };
    const bool may_breach = planned->kind == AgentKind::air ||
                            std::ranges::find(plan.breaches, agent.id, &Breach::by) != plan.breaches.end() ||
                            std::ranges::any_of(mission.rules.opened, has_begun);
    if (agent.doing == Doing::breaching && !may_breach)
        refuse(ErrorCode::contradiction, agent.id, "agent " + agent.id + " drives, and is said to breach");
}

}  // namespace

void validate(const Map& map, const Mission& mission, const Plan& plan, const State& state) {
    if (plan.status != PlanStatus::solved || plan.agents.size() != mission.agents.size())
        refuse(ErrorCode::contradiction, "", "only a plan that is solved can be revised");
    require_range(state.now, plan.revised ? plan.revised->now : 0, most_breach_time, "now");
    std::vector<std::string> named;
    for (const AgentState& agent : state.agents) {
        validate(map, mission, plan, agent);
        named.push_back(agent.id);
    }
    std::ranges::sort(named);
    if (const auto twice = std::ranges::adjacent_find(named); twice != named.end())
        refuse(ErrorCode::contradiction, *twice, "the state names agent " + *twice + " twice");
    for (const TimedOpening& opening : state.opened) {
        require_obstacle(map, opening.obstacle, "opened");
        require_range(opening.at, 0, most_breach_time,
                      "the time at which obstacle " + std::to_string(opening.obstacle.value) + " opened");
    }
    for (const TimedOpening& failure : state.failed) {
        require_obstacle(map, failure.obstacle, "failed");
        require_range(failure.at, 0, state.now,
                      "the time at which the breach of obstacle " + std::to_string(failure.obstacle.value) + " failed");
        const std::string id = std::to_string(failure.obstacle.value);
        const bool is_planned =
            std::ranges::find(plan.breaches, failure.obstacle, &Breach::obstacle) != plan.breaches.end();
        if (!is_planned && !had_begun(mission, plan, failure))
            refuse(ErrorCode::contradiction, id, "the breach of obstacle " + id + " failed, and the plan has none");
        if (std::ranges::count(state.failed, failure.obstacle, &TimedOpening::obstacle) > 1)
            refuse(ErrorCode::contradiction, id,
                   "the breach of obstacle " + id +
                       " failed more than once: report the first failure, and what "
                       "happens in the plan after it");
        if (std::ranges::find(state.opened, failure.obstacle, &TimedOpening::obstacle) != state.opened.end())
            refuse(ErrorCode::contradiction, id, "obstacle " + id + " opened, and its breach failed");
    }
    for (const Found& found : state.found) {
        if (found.cells.empty()) refuse(ErrorCode::other, "found", "what was found has no cells");
        const auto is_off = [&](Cell c) { return !map.grid().contains(c); };
        const auto off = std::ranges::find_if(found.cells, is_off);
        if (off != found.cells.end()) {
            refuse(ErrorCode::off_map, "found",
                   "cell " + std::to_string(off->x) + "," + std::to_string(off->y) + " was found, and is off the map");
        }
    }
}

std::vector<Found> found_by(const Map& map, const State& state, std::span<const Stopped> stopped) {
    std::vector<Found> all = state.found;
    for (const auto& [at, body] : stopped) {
        const double reach = body.reach();
        Found block;
        for (int y = int(std::floor(at.y - reach)); y <= int(std::ceil(at.y + reach)); ++y) {
            for (int x = int(std::floor(at.x - reach)); x <= int(std::ceil(at.x + reach)); ++x) {
                const double aside = std::max(std::abs(x - at.x) - 0.5, 0.0);
                const double away = std::max(std::abs(y - at.y) - 0.5, 0.0);
                const bool meets = std::hypot(aside, away) < reach || (aside == 0 && away == 0);
                if (meets && map.grid().contains({x, y}) && !map.grid().blocked({x, y})) block.cells.push_back({x, y});
            }
        }
        if (!block.cells.empty()) all.push_back(std::move(block));
    }
    return all;
}

}  // namespace waybreaker::live

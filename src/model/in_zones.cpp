#include "model/in_zones.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "waybreaker/error.hpp"
#include "waybreaker/map_edit.hpp"
#include "zones/cells.hpp"

namespace waybreaker {
namespace {

AgentKind kind_of(const Zone& zone) {
    return zone.kind == ZoneKind::no_fly ? AgentKind::air : AgentKind::ground;
}

// For all agents of its kind, or none: validate_zones.
bool holds(const Zone& zone, const Mission& mission) {
    return std::ranges::any_of(mission.agents, [&](const Agent& agent) { return holds_for(zone, agent); });
}

// All the time.
std::vector<Zone> those_that_hold(const Mission& mission, ZoneKind kind) {
    std::vector<Zone> zones;
    for (const Zone& zone : mission.rules.zones) {
        if (zone.kind == kind && !zone.has_window() && holds(zone, mission)) zones.push_back(zone);
    }
    return zones;
}

const Agent* first_aircraft(const Mission& mission) {
    const auto found = std::ranges::find(mission.agents, AgentKind::air, &Agent::kind);
    return found == mission.agents.end() ? nullptr : &*found;
}

// The obstacles that reach into zones for vehicles: to remove them would not open what lies inside.
std::vector<ObstacleId> obstacles_in(const Map& map, const Zone& zone) {
    std::set<ObstacleId> ids;
    for (const Cell c : zones::cells_in(zone, map.width(), map.height())) {
        if (const ObstacleId id = map.obstacle_at(c)) ids.insert(id);
    }
    return {ids.begin(), ids.end()};
}

bool opens_by_itself(const Rules& rules, ObstacleId id) {
    return std::ranges::count(rules.opened, id, &TimedOpening::obstacle) > 0;
}

// Whether an aircraft gets to a cell from which an obstacle can be breached.
bool is_in_reach(const Map& map, const Obstacle& obstacle, const Agent& aircraft) {
    // Most lie far from any zone: then one cell beside them is as good as another.
    const Box& box = obstacle.bounds;
    const auto at_side = [](int value, int size) { return std::clamp(value, 0, size - 1); };
    const Cell low{at_side(box.min.x - 1, map.width()), at_side(box.min.y - 1, map.height())};
    const Cell high{at_side(box.max.x + 1, map.width()), at_side(box.max.y + 1, map.height())};
    const Airspace& air = aircraft.airspace;
    const auto reaches = [&](Cell c) { return air.allows(c) && std::isfinite(air.length(aircraft.begin(), c)); };
    if (!air.comes_near(low, high)) return reaches(low);
    return std::ranges::any_of(map.boundary(obstacle.id), reaches);
}

// Of each, as from a place where two zones touch there are ways to both sides: one that another cannot fly.
bool is_in_reach_of_all(const Map& map, const Obstacle& obstacle, const Mission& mission) {
    return std::ranges::all_of(mission.agents, [&](const Agent& agent) {
        return agent.kind == AgentKind::ground || is_in_reach(map, obstacle, agent);
    });
}

class ZoneRules {
  public:
    ZoneRules(const Map& map, const Mission& mission) : map_(map), mission_(mission) {}

    void validate() const {
        validate_polygons(zones());
        for (std::size_t i = 0; i < zones().size(); ++i) validate_agents(i);
        for (std::size_t i = 0; i < zones().size(); ++i) {
            if (!holds(zones()[i], mission_)) continue;
            zones()[i].kind == ZoneKind::no_fly ? validate_no_fly(i) : validate_keep_out(i);
        }
        validate_flights();
    }

  private:
    const std::vector<Zone>& zones() const { return mission_.rules.zones; }
    std::string name(std::size_t zone) const { return name_of(zones()[zone], zone + 1); }

    void validate_agents(std::size_t zone) const {
        const Zone& given = zones()[zone];
        const auto refuse = [&](const std::string& id, const std::string& why) {
            throw InputError(ErrorCode::contradiction, id, name(zone) + " " + why);
        };
        for (const std::string& id : given.agents) {
            const auto agent = std::ranges::find(mission_.agents, id, &Agent::id);
            if (agent == mission_.agents.end()) refuse(id, "is for the agent '" + id + "', which the mission has not");
            if (agent->kind == kind_of(given)) continue;
            const bool flies = agent->kind == AgentKind::air;
            refuse(id, std::string("is one ") + (flies ? "to keep out of" : "not to fly in") + ", but the agent '" +
                           id + "' " + (flies ? "flies" : "drives"));
        }
        if (given.agents.empty()) return;
        for (const Agent& agent : mission_.agents) {
            if (agent.kind != kind_of(given) || std::ranges::count(given.agents, agent.id) > 0) continue;
            refuse(agent.id, std::string("is for some of the ") +
                                 (agent.kind == AgentKind::air ? "aircraft" : "ground agents") +
                                 " only, and not for '" + agent.id +
                                 "': such zones cannot be planned with yet; leave out 'agents', or name all of them");
        }
    }

    [[noreturn]] void refuse_place(std::size_t zone, const Agent& agent, const std::string& what) const {
        throw InputError(
            ErrorCode::no_room, agent.id,
            "the " + agent.id + " agent's " + what + " lies in " + name(zone) + "; move it, or leave the zone out");
    }

    // Whether the zone holds at a time when an agent that starts there cannot have left yet. One that is under way is
    // at its start when it is ready.
    bool has_to_start_in(std::size_t zone, const Agent& agent) const {
        const Zone& given = zones()[zone];
        const bool begins_late = given.has_window() && given.from > agent.ready_at;
        return !begins_late && (agent.approach.empty() || given.until > agent.ready_at);
    }
    // Whether it holds when an agent is at its goal, whenever it comes.
    bool has_to_end_in(std::size_t zone, const Agent& agent) const {
        const Zone& given = zones()[zone];
        const bool leaves = agent.kind == AgentKind::ground && mission_.rules.at_goal == AtGoal::leave;
        return !given.has_window() || (std::isinf(given.until) && !leaves);
    }

    void validate_no_fly(std::size_t zone) const {
        const Airspace air(std::span(&zones()[zone], 1), map_.width(), map_.height());
        for (const Agent& agent : mission_.agents) {
            if (agent.kind != AgentKind::air) continue;
            if (has_to_start_in(zone, agent) && !air.allows(agent.begin()))
                refuse_place(zone, agent, "start " + text(agent.begin()));
            if (has_to_end_in(zone, agent) && !air.allows(agent.goal))
                refuse_place(zone, agent, "goal " + text(agent.goal));
        }
    }

    void validate_keep_out(std::size_t zone) const {
        const std::vector<Cell> cells = zones::cells_in(zones()[zone], map_.width(), map_.height());
        for (const Agent& agent : mission_.agents) {
            if (agent.kind != AgentKind::ground) continue;
            const auto touches = [&](Cell at) {
                return std::ranges::any_of(cells, [&](Cell c) { return is_touched(c, at, agent.body); });
            };
            if (has_to_start_in(zone, agent) && touches(agent.start))
                refuse_place(zone, agent, "start " + text(agent.start));
            if (has_to_end_in(zone, agent) && touches(agent.goal))
                refuse_place(zone, agent, "goal " + text(agent.goal));
        }
        if (zones()[zone].has_window()) return;  // before and after, what it opens is of use
        const Rules& rules = mission_.rules;
        for (const ObstacleId id : obstacles_in(map_, zones()[zone])) {
            const auto refuse = [&](const std::string& who) {
                throw InputError(ErrorCode::contradiction, std::to_string(id.value),
                                 "obstacle " + std::to_string(id.value) + who + " reaches into " + name(zone) +
                                     ", which vehicles keep out of; leave one of them out");
            };
            if (std::ranges::count(rules.force, id) > 0) refuse(", which must be removed,");
        }
    }

    // Whether an agent that stands at a cell reaches into another: its open disc, in thousandths of half a cell.
    static bool is_touched(Cell c, Cell at, const Body& body) {
        if (c == at) return true;
        const auto away = [](int a, int b) {
            const std::int64_t apart = std::abs(std::int64_t{a} - b);
            return std::max<std::int64_t>(2 * apart - 1, 0) * 1000;
        };
        const std::int64_t x = away(c.x, at.x);
        const std::int64_t y = away(c.y, at.y);
        const std::int64_t reach = 2 * body.thousandths();
        return x < reach && y < reach && x * x + y * y < reach * reach;
    }

    // All aircraft have a way, to each other as well.
    void validate_flights() const {
        const Agent* first = first_aircraft(mission_);
        const Airspace air(those_that_hold(mission_, ZoneKind::no_fly), map_.width(), map_.height());
        if (first == nullptr || air.is_open()) return;
        for (const Agent& agent : mission_.agents) {
            if (agent.kind != AgentKind::air) continue;
            const auto require_way = [&](Point from, Point to, const std::string& between) {
                if (std::isfinite(air.length(from, to))) return;
                throw InputError(ErrorCode::contradiction, agent.id,
                                 "the zones leave no way to fly " + between + "; leave one of them out");
            };
            require_way(
                agent.begin(), agent.goal,
                "from the " + agent.id + " agent's start " + text(agent.begin()) + " to its goal " + text(agent.goal));
            require_way(first->begin(), agent.begin(),
                        "from the start of the " + first->id + " agent to that of the " + agent.id + " agent");
        }
        if (mission_.rules.force.empty()) return;
        Mission flown = mission_;
        set_airspaces(map_, flown);
        for (const ObstacleId id : mission_.rules.force) {
            if (is_in_reach_of_all(map_, map_.obstacle(id), flown)) continue;
            throw InputError(ErrorCode::contradiction, std::to_string(id.value),
                             "obstacle " + std::to_string(id.value) +
                                 " must be removed, but the zones leave no cell beside it to breach it from");
        }
    }

    static std::string text(Point p) {
        const auto rounded = [](double v) {
            std::string digits = std::to_string(v);
            while (digits.back() == '0') digits.pop_back();
            if (digits.back() == '.') digits.pop_back();
            return digits;
        };
        return rounded(p.x) + "," + rounded(p.y);
    }

    const Map& map_;
    const Mission& mission_;
};

}  // namespace

void validate_polygons(const std::vector<Zone>& zones) {
    std::size_t corners = 0;
    for (std::size_t i = 0; i < zones.size(); ++i) {
        for (const std::vector<Point>& ring : zones[i].polygon) corners += ring.size();
        if (corners > most_zone_corners)
            throw InputError(ErrorCode::too_large, "zones",
                             "the zones have more than " + std::to_string(most_zone_corners) +
                                 " corners together; simplify their polygons");
        validate(zones[i], i + 1);
    }
}

bool holds_for(const Zone& zone, const Agent& agent) {
    return agent.kind == kind_of(zone) && (zone.agents.empty() || std::ranges::count(zone.agents, agent.id) > 0);
}

void validate_zones(const Map& map, const Mission& mission) {
    if (!mission.rules.zones.empty()) ZoneRules(map, mission).validate();
}

void set_airspaces(const Map& map, Mission& mission) {
    const Airspace air(those_that_hold(mission, ZoneKind::no_fly), map.width(), map.height());
    for (Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air) agent.airspace = air;
    }
}

std::optional<Map> closed_to_vehicles(const Map& map, const Mission& mission) {
    std::set<Cell> closed;
    for (const Zone& zone : those_that_hold(mission, ZoneKind::keep_out)) {
        for (const Cell c : zones::cells_in(zone, map.width(), map.height())) {
            const ObstacleId id = map.obstacle_at(c);
            if (!id || opens_by_itself(mission.rules, id)) closed.insert(c);
        }
    }
    if (closed.empty()) return std::nullopt;
    return map.with({MapEdit::add({closed.begin(), closed.end()}, {.destructible = false})});
}

InZones::InZones(const Map& map, const Mission& mission) : map_(map), mission_(mission) {
    const auto is_free = [](const Agent& agent) { return agent.airspace.is_open(); };
    if (mission.rules.zones.empty() && std::ranges::all_of(mission.agents, is_free)) return;
    closed_ = closed_to_vehicles(map, mission);
    zoned_ = mission;
    set_airspaces(map, *zoned_);
    Rules& rules = zoned_->rules;
    rules.zones.clear();
    std::set<ObstacleId> kept;
    for (const Zone& zone : those_that_hold(mission, ZoneKind::keep_out)) {
        for (const ObstacleId id : obstacles_in(map, zone)) {
            if (!opens_by_itself(rules, id)) kept.insert(id);
        }
    }
    if (const Agent* scout = first_aircraft(*zoned_); scout != nullptr && !scout->airspace.is_open()) {
        for (const Obstacle& obstacle : map.obstacles()) {
            if (obstacle.gone() || !obstacle.destructible || kept.contains(obstacle.id)) continue;
            if (opens_by_itself(rules, obstacle.id)) continue;
            if (!is_in_reach_of_all(map, obstacle, *zoned_)) kept.insert(obstacle.id);
        }
    }
    for (const ObstacleId id : rules.protect) kept.insert(id);
    rules.protect.assign(kept.begin(), kept.end());
    std::erase_if(rules.opened, [this](const TimedOpening& opening) {
        return closed_ && closed_->obstacle(opening.obstacle).gone();
    });
}

}  // namespace waybreaker

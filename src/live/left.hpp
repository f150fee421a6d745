// What is left of a mission under way: which obstacles are open, who is where, and what the rules still allow.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "live/base.hpp"
#include "live/position.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::live {

// A plan and what is reported of it.
struct Report {
    const Map& map;          // as the plan knows it
    const Mission& mission;  // aircraft with their airspaces
    const Plan& plan;
    const State& state;
    double decided;  // until then agents keep to the plan

    const AgentState* of(const std::string& agent) const;
};

// Where each agent is, in the order of the mission.
std::vector<Position> positions_of(const Report& report);

// What has become of a breach of the plan.
struct Outlook {
    bool failed = false;
    std::optional<double> opens;  // when it does, made already or begun by `decided`; empty: it is still to come
};
// Of each breach of the plan, in its order.
std::vector<Outlook> outlooks_of(const Report& report, std::span<const Position> positions);

// Of an air agent: until then it keeps to its flight, which is `decided`, or the end of a breach or of a stay at a base
// that has begun by then.
double bound_until(const Report& report, std::size_t agent, const Position& position);

// The zones that hold for some of these agents, for those alone.
std::vector<Zone> zones_for(std::vector<Zone> zones, std::span<const Agent> agents);

// The mission that is left, but for where its agents start. `outlooks`: as the breaches of the plan.
Mission left_of(const Report& report, std::span<const Outlook> outlooks);

}  // namespace waybreaker::live

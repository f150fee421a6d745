// A mission without windows that stands for one with windows.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "mission/zone_stays.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// What is imposed on a mission in place of windows, and its plans.
struct WindowNode {
    std::vector<Agent> agents;    // some set out later, or begin at an entry of a zone
    std::vector<bool> permanent;  // by zone: whether it holds all the time
    std::vector<Plan> plans = {};
    double reached = std::numeric_limits<double>::infinity();
    std::optional<ZoneBreach> breach = {};  // of the first plan

    // The mission to be planned: zones that are imposed hold all the time, others with a window never.
    Mission mission_in(const Mission& asked) const;
    // Agents that begin at an entry have flown there, as their approach says.
    void begin_as_asked(const Mission& asked, Plan& plan) const;

    bool is_at_entry(const Mission& asked, std::size_t agent) const;
    bool is_anybody_late(const Mission& asked) const;
    bool imposes_the_same(const WindowNode& other) const;

    // Where the agent of a breach of one of its plans sets out so late that it is at the zone when that is over. Empty
    // if it does not help, or it cannot stand where it begins.
    std::optional<WindowNode> put_off(const Mission& asked, const ZoneBreach& late) const;
};

}  // namespace waybreaker

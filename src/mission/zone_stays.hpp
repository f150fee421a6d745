// When agents are in zones, from a plan alone.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "zones/stretches.hpp"

namespace waybreaker {

// A time for which an agent is in a zone.
struct Stay {
    double from = 0;      // units of time
    double until = 0;     // infinity: it stays for ever
    double driven = 0;    // by then, from the beginning of its path, in cells
    bool entered = true;  // else it begins there
    bool left = true;     // else it ends there
};

// In order and apart from each other. `radius`: of a ground agent; `stays`: at the end of its path, for ever.
std::vector<Stay> stays_in(const zones::Closed& zone, std::span<const Waypoint> path, double radius, bool stays);

// A zone with a window that an agent is in while it holds.
struct ZoneBreach {
    std::size_t zone = 0;   // in Rules::zones
    std::size_t agent = 0;  // in Mission::agents
    double at = 0;          // units of time
    Stay stay = {};
};

// Knows the zones of a mission that have a window.
class ZoneWatch {
  public:
    // The mission must outlive it. REQUIRES: valid zones.
    ZoneWatch(const Map& map, const Mission& mission);

    // The first in time, without those in `passed`, by place in Rules::zones: empty if there is none. What agents do
    // before they are ready is not asked of those that are under way. REQUIRES: the plan's agents are the mission's.
    std::optional<ZoneBreach> first_breach(const Plan& plan, const std::vector<bool>& passed) const;

    // Of one agent on another path: the first in time.
    std::optional<ZoneBreach> first_breach(std::size_t agent, std::span<const Waypoint> path) const;

    // Of an agent that a zone holds for, on such a path. `stays`: at its end, for ever.
    std::vector<Stay> stays(std::size_t zone, std::size_t agent, std::span<const Waypoint> path, bool stays) const;
    bool holds_for(std::size_t zone, std::size_t agent) const;

  private:
    // The first of an agent on that path in that zone, if there is one.
    void add_first_breach(std::size_t zone, std::size_t agent, std::span<const Waypoint> path,
                          std::vector<ZoneBreach>& breaches) const;

    const Mission& mission_;
    std::map<std::size_t, zones::Closed> closed_;  // by zone; of those that have a window
};

}  // namespace waybreaker

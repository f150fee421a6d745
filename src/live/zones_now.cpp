#include "live/zones_now.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/in_zones.hpp"
#include "waybreaker/map_edit.hpp"
#include "zones/cells.hpp"

namespace waybreaker::live {

Mission in_airspace_at(const Map& map, Mission mission, double time) {
    std::vector<Zone> zones = mission.rules.zones;
    std::erase_if(mission.rules.zones, [time](const Zone& zone) { return !zone.holds_at(time); });
    for (Zone& zone : mission.rules.zones) {
        zone.from = 0;
        zone.until = Zone().until;
    }
    set_airspaces(map, mission);
    mission.rules.zones = std::move(zones);
    return mission;
}

Closed closed_at(const Map& map, const Mission& mission, double time) {
    Closed result{map, closed_to_vehicles(map, mission), {}};
    std::vector<Zone> now;
    for (const Zone& zone : mission.rules.zones) {
        if (zone.kind == ZoneKind::keep_out && zone.has_window() && zone.holds_at(time)) now.push_back(zone);
    }
    // Where several overlap, a cell is that of the last to be over.
    std::ranges::stable_sort(now, std::ranges::greater(), &Zone::until);
    for (const Zone& zone : now) {
        std::vector<Cell> cells = zones::cells_in(zone, map.width(), map.height());
        std::erase_if(cells, [&](Cell c) { return result.map().grid().blocked(c); });
        if (cells.empty()) continue;
        result.closed = result.map().with({MapEdit::add(std::move(cells), {.destructible = false})});
        const ObstacleId id{std::uint32_t(result.map().obstacles().size())};
        if (std::isfinite(zone.until)) result.openings.push_back({id, zone.until});
    }
    return result;
}

}  // namespace waybreaker::live

#include "io/plan_csv.hpp"

#include <cmath>
#include <optional>

#include "io/csv_field.hpp"
#include "io/map_frame.hpp"
#include "io/shortest_text.hpp"

namespace waybreaker::io {
namespace {

std::string decimals(double value, double per_unit) {
    return shortest_text(std::round(value * per_unit) / per_unit);
}

constexpr double square_millimetres = 1e6;

// What the air agent opens at that point of its path, at the end of its stay: the obstacle and its area.
std::string breach_at(const Plan& plan, const MapFile& map, const Itinerary& agent, std::size_t i) {
    const Waypoint& point = agent.path[i];
    if (agent.kind != AgentKind::air || (i + 1 < agent.path.size() && agent.path[i + 1] == point)) return ",";
    for (const Breach& breach : plan.breaches) {
        if (!breach.by.empty() && breach.by != agent.id) continue;
        if (point == Waypoint{double(breach.at.x), double(breach.at.y), breach.cleared_at}) {
            return std::to_string(breach.obstacle.value) + "," +
                   (map.has_metres() ? decimals(map.square_metres(breach.cells), square_millimetres) : "");
        }
    }
    return ",";
}

}  // namespace

std::string plan_csv(const Plan& plan, const MapFile& map, const site::ToLonLat& to_lon_lat, const ExportUnits& units) {
    constexpr double micrometres = 1e6;  // as ROS paths have them: a cell may measure less than a millimetre
    constexpr double degrees = 1e9;
    const MapFrame frame(map);
    std::string text = "agent,kind,t,x,y,map_x,map_y,lon,lat,breaches,area_m2,time_unit,map_crs\n";
    std::string same = ",";
    same.append(time_unit(units)).append(",").append(csv_field(units.crs)).append("\n");
    for (const Itinerary& agent : plan.agents) {
        const bool air = agent.kind == AgentKind::air;
        for (std::size_t i = 0; i < agent.path.size(); ++i) {
            const Waypoint& point = agent.path[i];
            const Point place = frame.metres({point.x, point.y});
            text += csv_field(agent.id) + (air ? ",air," : ",ground,") + shortest_text(point.t) + "," +
                    shortest_text(point.x) + "," + shortest_text(point.y) + "," + decimals(place.x, micrometres) + "," +
                    decimals(place.y, micrometres) + ",";
            if (to_lon_lat) {
                const auto [lon, lat] = to_lon_lat({point.x, point.y});
                text += decimals(lon, degrees) + "," + decimals(lat, degrees) + ",";
            } else {
                text += ",,";
            }
            text += breach_at(plan, map, agent, i) + same;
        }
    }
    return text;
}

}  // namespace waybreaker::io

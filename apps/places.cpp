#include "places.hpp"

#include <fmt/format.h>

#include "geotiff/georeference.hpp"
#include "io/map_frame.hpp"
#include "io/place_reason.hpp"

namespace waybreaker::apps {

std::string place_text(Cell cell, const PlanOptions& options, const io::MapFile& map) {
    const Point centre(cell.x, cell.y);
    if (options.lon_lat && map.georeference) {
        const auto [lon, lat] = geotiff::ToLonLat(*map.georeference)(centre.x, centre.y);
        return fmt::format("{:.6f},{:.6f} (cell {},{})", lon, lat, cell.x, cell.y);
    }
    if (options.map_metres) {
        const Point metres = io::MapFrame(map).metres(centre);
        return fmt::format("{:.10g},{:.10g} (cell {},{})", metres.x, metres.y, cell.x, cell.y);
    }
    return fmt::format("{},{}", cell.x, cell.y);
}

std::string why_misplaced(const Misplaced& agent, const PlanOptions& options, const io::MapFile& map) {
    const bool opens = map.ros && io::is_in_unknown(agent, map);
    const std::string reason =
        opens ? "lies in unknown space, which --unknown-free opens" : io::place_reason(agent, map);
    return fmt::format("{} {} {}; {}{}", agent.what_for, place_text(agent.at, options, map), reason, agent.remedy,
                       agent.nearest ? " " + place_text(*agent.nearest, options, map) : "");
}

}  // namespace waybreaker::apps

#include "exports/plan_gpx.hpp"

#include <fmt/format.h>

#include "exports/utc_time.hpp"
#include "exports/xml_document.hpp"

namespace waybreaker::exports {
namespace {

// Degrees to a tenth of a millimetre, never with an exponent. Longitudes of GPX end below 180.
std::string degrees(double value) {
    const std::string text = fmt::format("{:.9f}", value);
    return text == "180.000000000" ? "-180.000000000" : text;
}

pugi::xml_node append_point(pugi::xml_node parent, const char* name, const PlacedPlan& placed, Point at, double t) {
    const auto [lon, lat] = placed.to_lon_lat(at);
    pugi::xml_node point = parent.append_child(name);
    point.append_attribute("lat").set_value(fmt::format("{:.9f}", lat).c_str());
    point.append_attribute("lon").set_value(degrees(lon).c_str());
    append_text(point, "time", utc_text(placed.starts_at, t));
    return point;
}

void append_metadata(pugi::xml_node gpx, const PlacedPlan& placed) {
    pugi::xml_node metadata = gpx.append_child("metadata");
    append_text(metadata, "name", placed.map.name());
    if (const std::string& source = placed.map.annotations.attribution; !source.empty())
        metadata.append_child("copyright").append_attribute("author").set_value(characters_of_xml(source).c_str());
    append_text(metadata, "time", utc_text(placed.starts_at, 0));
}

void append_way_point(pugi::xml_node gpx, const PlacedPlan& placed, const Breach& breach) {
    const Point at{double(breach.at.x), double(breach.at.y)};
    pugi::xml_node point = append_point(gpx, "wpt", placed, at, breach.cleared_at);
    append_text(point, "name", obstacle_name(placed, breach.obstacle));
    append_text(point, "desc",
                fmt::format("{} opens obstacle {} from here", breached_by(placed.plan, breach), breach.obstacle.value));
    append_text(point, "type", "breach");
}

void append_trk(pugi::xml_node gpx, const PlacedPlan& placed, const Itinerary& agent) {
    pugi::xml_node track = gpx.append_child("trk");
    append_text(track, "name", agent.id);
    append_text(track, "type", agent.kind == AgentKind::air ? "air" : "ground");
    pugi::xml_node segment = track.append_child("trkseg");
    const Waypoint* last = nullptr;
    for (const Waypoint& point : agent.path) {
        if (last == nullptr || *last != point) append_point(segment, "trkpt", placed, {point.x, point.y}, point.t);
        last = &point;
    }
}

}  // namespace

std::string plan_gpx(const PlacedPlan& placed) {
    require_place(placed, "GPX");
    pugi::xml_document document;
    pugi::xml_node gpx = document.append_child("gpx");
    gpx.append_attribute("version").set_value("1.1");
    gpx.append_attribute("creator").set_value("waybreaker");
    gpx.append_attribute("xmlns").set_value("http://www.topografix.com/GPX/1/1");
    append_metadata(gpx, placed);
    for (const Breach& breach : placed.plan.breaches) append_way_point(gpx, placed, breach);
    for (const Itinerary& agent : placed.plan.agents) append_trk(gpx, placed, agent);
    return document_text(document);
}

}  // namespace waybreaker::exports

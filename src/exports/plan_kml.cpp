#include "exports/plan_kml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "exports/utc_time.hpp"
#include "exports/xml_document.hpp"
#include "io/lon_lat_json.hpp"
#include "io/shortest_text.hpp"
#include "site/outline.hpp"

namespace waybreaker::exports {
namespace {

using Json = nlohmann::ordered_json;

// Colours are alpha, blue, green, red.
void append_style(pugi::xml_node document, const char* id, const char* line, int width, const char* fill) {
    pugi::xml_node style = document.append_child("Style");
    style.append_attribute("id").set_value(id);
    pugi::xml_node strokes = style.append_child("LineStyle");
    append_text(strokes, "color", line);
    append_text(strokes, "width", std::to_string(width));
    append_text(style.append_child("PolyStyle"), "color", fill);
}

pugi::xml_node append_folder(pugi::xml_node document, const char* name) {
    pugi::xml_node folder = document.append_child("Folder");
    append_text(folder, "name", name);
    return folder;
}

struct Span {
    std::optional<double> begin = {};
    std::optional<double> end = {};
};

void append_span(pugi::xml_node placemark, const PlacedPlan& placed, const Span& span) {
    pugi::xml_node time = placemark.append_child("TimeSpan");
    if (span.begin) append_text(time, "begin", utc_text(placed.starts_at, *span.begin));
    if (span.end) append_text(time, "end", utc_text(placed.starts_at, *span.end));
}

pugi::xml_node append_placemark(pugi::xml_node folder, const PlacedPlan& placed, const std::string& name,
                                const std::string& description, const Span& span, const std::string& style) {
    pugi::xml_node placemark = folder.append_child("Placemark");
    append_text(placemark, "name", name);
    append_text(placemark, "description", description);
    append_span(placemark, placed, span);
    append_text(placemark, "styleUrl", fmt::format("#{}", style));
    return placemark;
}

std::string position(const Json& lon_lat) {
    return fmt::format("{:.9f},{:.9f}", lon_lat[0].get<double>(), lon_lat[1].get<double>());
}

void append_polygon(pugi::xml_node parent, const Json& rings) {
    pugi::xml_node polygon = parent.append_child("Polygon");
    for (std::size_t i = 0; i < rings.size(); ++i) {
        std::string coordinates;
        for (const Json& place : rings[i]) coordinates += position(place) + " ";
        pugi::xml_node boundary = polygon.append_child(i == 0 ? "outerBoundaryIs" : "innerBoundaryIs");
        append_text(boundary.append_child("LinearRing"), "coordinates", coordinates);
    }
}

void append_area(pugi::xml_node placemark, const Json& geometry) {
    const Json& coordinates = geometry["coordinates"];
    if (geometry["type"] == "Polygon") return append_polygon(placemark, coordinates);
    pugi::xml_node all = placemark.append_child("MultiGeometry");
    for (const Json& rings : coordinates) append_polygon(all, rings);
}

void append_obstacle(pugi::xml_node folder, const PlacedPlan& placed, const Breach& breach) {
    const std::string name = obstacle_name(placed, breach.obstacle);
    const Json area = io::polygons_json(placed.to_lon_lat, site::outline(placed.map.map, breach.obstacle));
    const std::string what = fmt::format("obstacle {}, {} cells", breach.obstacle.value, breach.cells);
    append_area(append_placemark(folder, placed, name, what, {.begin = 0, .end = breach.cleared_at}, "standing"), area);
    append_area(append_placemark(folder, placed, name, what + ", open", {.begin = breach.cleared_at}, "opened"), area);
}

void append_breach(pugi::xml_node folder, const PlacedPlan& placed, const Breach& breach) {
    const Span stay{begun_at(placed.plan, breach), breach.cleared_at};
    const std::string what =
        fmt::format("{} opens obstacle {} from here", breached_by(placed.plan, breach), breach.obstacle.value);
    pugi::xml_node placemark =
        append_placemark(folder, placed, obstacle_name(placed, breach.obstacle), what, stay, "breach");
    const Point at{double(breach.at.x), double(breach.at.y)};
    append_text(placemark.append_child("Point"), "coordinates", position(io::position_json(placed.to_lon_lat, at)));
}

void append_track(pugi::xml_node folder, const PlacedPlan& placed, const Itinerary& agent) {
    const bool flies = agent.kind == AgentKind::air && placed.altitude.has_value();
    const char* const kind = agent.kind == AgentKind::air ? "air" : "ground";
    pugi::xml_node placemark = folder.append_child("Placemark");
    append_text(placemark, "name", agent.id);
    append_text(placemark, "styleUrl", fmt::format("#{}", kind));
    pugi::xml_node track = placemark.append_child("gx:Track");
    append_text(track, "altitudeMode", flies ? "relativeToGround" : "clampToGround");
    for (const Waypoint& point : agent.path) append_text(track, "when", utc_text(placed.starts_at, point.t));
    const std::string height = io::shortest_text(flies ? *placed.altitude : 0);
    for (const Waypoint& point : agent.path) {
        const auto [lon, lat] = placed.to_lon_lat({point.x, point.y});
        append_text(track, "gx:coord", fmt::format("{:.9f} {:.9f} {}", lon, lat, height));
    }
}

// A folder for them, where there are any.
void append_zones(pugi::xml_node document, const PlacedPlan& placed) {
    if (placed.zones.empty()) return;
    pugi::xml_node folder = append_folder(document, "zones");
    for (std::size_t i = 0; i < placed.zones.size(); ++i) {
        const Zone& zone = placed.zones[i];
        site::Polygon closed = zone.polygon;
        for (site::Ring& ring : closed) ring.push_back(ring.front());
        const std::string kind(to_string(zone.kind));
        pugi::xml_node placemark = folder.append_child("Placemark");
        append_text(placemark, "name", zone.name.empty() ? fmt::format("zone {}", i + 1) : zone.name);
        append_text(placemark, "description",
                    zone.agents.empty() ? kind : fmt::format("{} for {}", kind, fmt::join(zone.agents, ", ")));
        if (zone.has_window()) {
            Span span{.begin = zone.from};
            if (std::isfinite(zone.until)) span.end = zone.until;
            append_span(placemark, placed, span);
        }
        append_text(placemark, "styleUrl", fmt::format("#{}", kind));
        append_area(placemark, io::polygons_json(placed.to_lon_lat, {closed}));
    }
}

}  // namespace

std::string plan_kml(const PlacedPlan& placed) {
    require_place(placed, "KML");
    pugi::xml_document file;
    pugi::xml_node kml = file.append_child("kml");
    kml.append_attribute("xmlns").set_value("http://www.opengis.net/kml/2.2");
    kml.append_attribute("xmlns:gx").set_value("http://www.google.com/kml/ext/2.2");
    pugi::xml_node document = kml.append_child("Document");
    append_text(document, "name", placed.map.name());
    append_text(document, "description", placed.map.annotations.attribution);
    append_style(document, "ground", "ffb4460f", 4, "00ffffff");
    append_style(document, "air", "ff1f8ce6", 3, "00ffffff");
    append_style(document, "standing", "ff2020c8", 2, "a02020c8");
    append_style(document, "opened", "ff30a030", 2, "4030a030");
    append_style(document, "breach", "ff1f8ce6", 2, "00ffffff");
    for (const ZoneKind kind : {ZoneKind::no_fly, ZoneKind::keep_out}) {
        const char* const id = to_string(kind).data();
        if (std::ranges::count(placed.zones, kind, &Zone::kind) > 0)
            append_style(document, id, "ff6e1f9c", 2, "306e1f9c");
    }
    const pugi::xml_node agents = append_folder(document, "agents");
    const pugi::xml_node breaches = append_folder(document, "breaches");
    const pugi::xml_node obstacles = append_folder(document, "obstacles");
    for (const Itinerary& agent : placed.plan.agents) append_track(agents, placed, agent);
    for (const Breach& breach : placed.plan.breaches) {
        append_breach(breaches, placed, breach);
        append_obstacle(obstacles, placed, breach);
    }
    append_zones(document, placed);
    return document_text(file);
}

}  // namespace waybreaker::exports

#include "exports/plan_vda5050.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "exports/utc_time.hpp"
#include "io/map_frame.hpp"
#include "io/path_parts.hpp"
#include "io/sha256.hpp"
#include "site/outline.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::exports {
namespace {

using Message = nlohmann::ordered_json;

Message place_json(const io::MapFrame& frame, Point cell) {
    constexpr double micrometres = 1e6;
    const Point metres = frame.metres(cell);
    const auto rounded = [&](double value) { return std::round(value * micrometres) / micrometres; };
    return {{"x", rounded(metres.x)}, {"y", rounded(metres.y)}};
}

std::string map_id(const io::MapFile& map) {
    return std::filesystem::path(map.source).stem().string();
}

std::string short_digest(const Message& message) {
    return io::sha256_digest(message.dump(-1, ' ', false, Message::error_handler_t::replace))
        .substr(std::string_view("sha256:").size(), 16);
}

void require_serial_number(const std::string& id) {
    constexpr std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.:-";
    if (!id.empty() && id.find_first_not_of(allowed) == std::string::npos) return;
    throw InputError(fmt::format(
        "agent '{}': serial numbers of VDA 5050 have letters from A to Z, digits, and _ . : - only; rename the agent",
        id));
}

// What all messages begin with.
Message header(const PlacedPlan& placed, const std::string& vehicle, std::size_t number, double sent_at) {
    return {{"headerId", number},
            {"timestamp", utc_text(placed.starts_at, sent_at)},
            {"version", "3.0.0"},
            {"manufacturer", "waybreaker"},
            {"serialNumber", vehicle}};
}

// A zone for each piece of the obstacle; a yard that it encloses belongs to it.
Message release_zones(const PlacedPlan& placed, const Mission& mission, const io::MapFrame& frame) {
    Message zones = Message::array();
    for (const ObstacleId obstacle : io::openings_of(mission, placed.plan)) {
        const std::vector<site::Polygon> pieces = site::outline(placed.map.map, obstacle);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Message vertices = Message::array();
            const site::Ring& ring = pieces[i].front();
            for (std::size_t k = 0; k + 1 < ring.size(); ++k) vertices.push_back(place_json(frame, ring[k]));
            zones.push_back({{"zoneId", fmt::format("obstacle-{}{}", obstacle.value,
                                                    pieces.size() == 1 ? "" : fmt::format("-{}", i + 1))},
                             {"zoneType", "RELEASE"},
                             {"zoneDescriptor", obstacle_name(placed, obstacle)},
                             {"vertices", std::move(vertices)},
                             {"releaseLossBehavior", "STOP"}});
        }
    }
    return zones;
}

// What the vehicle keeps out of, by its outline.
void append_blocked_zones(const PlacedPlan& placed, const Itinerary& vehicle, const io::MapFrame& frame,
                          Message& zones) {
    require_no_hole(placed, vehicle, "VDA 5050");
    for (std::size_t i = 0; i < placed.zones.size(); ++i) {
        const Zone& zone = placed.zones[i];
        if (!holds_for(zone, vehicle)) continue;
        Message vertices = Message::array();
        for (const Point corner : zone.polygon.front()) vertices.push_back(place_json(frame, corner));
        Message blocked{{"zoneId", fmt::format("zone-{}", i + 1)}, {"zoneType", "BLOCKED"}};
        if (zone.has_window()) {
            blocked["zoneDescriptor"] = name_of(zone, i + 1);  // and its times, which a zone cannot have
        } else if (!zone.name.empty()) {
            blocked["zoneDescriptor"] = zone.name;
        }
        blocked["vertices"] = std::move(vertices);
        zones.push_back(std::move(blocked));
    }
}

// Ends the order of the plan before, of which the vehicle may have driven any part.
Message cancel_order(const PlacedPlan& placed, const Itinerary& vehicle, const std::string& next_order) {
    Message message = header(placed, vehicle.id, 0, vehicle.path.front().t);
    message["actions"] = Message::array({{{"actionType", "cancelOrder"},
                                          {"actionId", next_order + "-after-cancel"},
                                          {"blockingType", "NONE"},
                                          {"actionParameters", Message::array()}}});
    return message;
}

// The way of one vehicle: a node where it turns or waits, an edge for each straight move.
class Way {
  public:
    Way(const PlacedPlan& placed, const Itinerary& vehicle, const io::MapFrame& frame)
        : placed_(placed), vehicle_(vehicle), frame_(frame) {
        for (const Waypoint& point : vehicle.path) {
            const Point at{point.x, point.y};
            if (places_.empty() || places_.back() != at) places_.push_back(at);
            node_of_.push_back(places_.size() - 1);
        }
    }

    // The first order, then its updates.
    std::vector<Message> orders(const std::vector<io::PathPart>& parts) const {
        std::vector<Message> all;
        if (stays(parts)) all.push_back(order(0, 0, 0, vehicle_.path.front().t));
        for (const io::PathPart& part : parts) {
            all.push_back(order(all.size(), node_of_[part.first], node_of_[part.last], vehicle_.path[part.first].t));
            if (!part.openings.empty()) all.back()["orderDescription"] = description(part);
        }
        const std::string id = "waybreaker-" + short_digest(all);
        for (Message& one : all) one["orderId"] = id;
        return all;
    }

  private:
    // Whether its first order lets it go nowhere. What may be driven at once belongs to that order otherwise.
    bool stays(const std::vector<io::PathPart>& parts) const {
        if (parts.empty() || !parts[0].openings.empty()) return true;
        if (vehicle_.path[parts[0].first].t > vehicle_.path.front().t) return true;
        const std::optional<std::size_t> decision = io::decision_point(placed_.plan, vehicle_.id);
        return decision && node_of_[*decision] == 0;
    }

    static std::string description(const io::PathPart& part) {
        std::vector<std::uint32_t> ids;
        for (const ObstacleId obstacle : part.openings) ids.push_back(obstacle.value);
        return fmt::format("to be sent when open: obstacle {}", fmt::join(ids, ", "));
    }

    // From a node on; released up to another.
    Message order(std::size_t update, std::size_t from, std::size_t released, double sent_at) const {
        Message message = header(placed_, vehicle_.id, update, sent_at);
        message["orderId"] = "";
        message["orderUpdateId"] = update;
        Message nodes = Message::array();
        Message edges = Message::array();
        for (std::size_t i = from; i < places_.size(); ++i) {
            nodes.push_back(node(i, i <= released));
            if (i > from) edges.push_back(edge(i, i <= released));
        }
        message["nodes"] = std::move(nodes);
        message["edges"] = std::move(edges);
        return message;
    }

    Message node(std::size_t i, bool released) const {
        Message position = place_json(frame_, places_[i]);
        position["mapId"] = map_id(placed_.map);
        return {{"nodeId", fmt::format("{}-node-{}", vehicle_.id, i)},
                {"sequenceId", 2 * i},
                {"released", released},
                {"nodePosition", std::move(position)},
                {"actions", Message::array()}};
    }

    // To node i. Its trajectory is the straight line, which is what has been planned.
    Message edge(std::size_t i, bool released) const {
        const Message line{{"degree", 1},
                           {"knotVector", {0.0, 0.0, 1.0, 1.0}},
                           {"controlPoints", {place_json(frame_, places_[i - 1]), place_json(frame_, places_[i])}}};
        return {{"edgeId", fmt::format("{}-edge-{}", vehicle_.id, i)},
                {"sequenceId", 2 * i - 1},
                {"released", released},
                {"maximumSpeed", vehicle_.speed * placed_.map.cell_size},
                {"trajectory", line},
                {"actions", Message::array()}};
    }

    const PlacedPlan& placed_;
    const Itinerary& vehicle_;
    const io::MapFrame& frame_;
    std::vector<Point> places_ = {};
    std::vector<std::size_t> node_of_ = {};  // each point of the path
};

}  // namespace

std::string plan_vda5050(const PlacedPlan& placed, const Mission& mission) {
    if (!placed.map.has_metres()) {
        throw InputError(
            fmt::format("{}: VDA 5050 counts in metres, but the map does not say how large a cell is: take a "
                        "GeoTIFF or a ROS map, or plan with --cell-size METRES",
                        placed.map.source));
    }
    const io::MapFrame frame(placed.map);
    const Message openings = release_zones(placed, mission, frame);
    Message zone_sets = Message::array();
    Message actions = Message::array();
    Message orders = Message::array();
    for (std::size_t i = 0; i < placed.plan.agents.size(); ++i) {
        const Itinerary& vehicle = placed.plan.agents[i];
        if (vehicle.kind != AgentKind::ground) continue;
        require_serial_number(vehicle.id);
        Message zone_set = header(placed, vehicle.id, 0, 0);
        Message zones = openings;
        append_blocked_zones(placed, vehicle, frame, zones);
        const std::string id = fmt::format("{}-openings-{}", map_id(placed.map), short_digest(zones));
        zone_set["zoneSet"] = {{"mapId", map_id(placed.map)}, {"zoneSetId", id}, {"zones", std::move(zones)}};
        zone_sets.push_back(std::move(zone_set));
        std::vector<Message> own =
            Way(placed, vehicle, frame).orders(io::path_parts(placed.map.map, mission, placed.plan, i));
        if (placed.plan.revised) actions.push_back(cancel_order(placed, vehicle, own.front().at("orderId")));
        std::ranges::move(own, std::back_inserter(orders));
    }
    const Message all{
        {"zoneSets", std::move(zone_sets)}, {"instantActions", std::move(actions)}, {"orders", std::move(orders)}};
    return all.dump(2, ' ', false, Message::error_handler_t::replace) + "\n";
}

}  // namespace waybreaker::exports

#include "exports/plan_qgc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "io/lon_lat_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::exports {
namespace {

using Json = nlohmann::ordered_json;

// Coordinate frames of MAVLink.
constexpr int no_place = 2;
constexpr int above_take_off = 3;

constexpr int altitude_above_take_off = 1;  // QGroundControl's own word for it
constexpr int any_autopilot = 0;
constexpr int multicopter = 2;

class Flight {
  public:
    Flight(const PlacedPlan& placed, const Itinerary& aircraft, const MavAction& breach)
        : placed_(placed), aircraft_(aircraft), breach_(breach) {
        for (const Breach& one : placed.plan.breaches) {
            if (breached_by(placed.plan, one) == aircraft.id) breaches_.push_back(&one);
        }
    }

    Json items() {
        constexpr double ground_speed = 1;
        constexpr double same_throttle = -1;
        const std::vector<Waypoint>& path = aircraft_.path;
        go_to(path.front());
        append(MavCommand::nav_takeoff, {});
        append(MavCommand::do_change_speed, {ground_speed, speed(), same_throttle});
        for (std::size_t i = 0; i < path.size();) {
            std::size_t last = i;
            while (last + 1 < path.size() && path[last + 1].x == path[i].x && path[last + 1].y == path[i].y) ++last;
            if (i != 0) {
                go_to(path[i]);
                append(MavCommand::nav_waypoint, {});
            }
            stay(path[i].t, path[last]);
            i = last + 1;
        }
        append(MavCommand::nav_land, {});
        return std::move(items_);
    }

    // What it keeps out of, as the fence has it: by its outline.
    Json fences() const {
        Json fences = Json::array();
        for (const Zone& zone : placed_.zones) {
            if (!holds_for(zone, aircraft_)) continue;
            Json corners = Json::array();
            for (const Point corner : zone.polygon.front()) corners.push_back(lat_lon({corner.x, corner.y, 0}));
            fences.push_back({{"inclusion", false}, {"polygon", std::move(corners)}, {"version", 1}});
        }
        return fences;
    }

    Json home() const { return {lat_lon(aircraft_.path.front())[0], lat_lon(aircraft_.path.front())[1], 0}; }

    double speed() const { return aircraft_.speed * placed_.map.cell_size; }

  private:
    Json lat_lon(const Waypoint& point) const {
        const Json lon_lat = io::position_json(placed_.to_lon_lat, {point.x, point.y});
        return {lon_lat[1], lon_lat[0]};
    }

    void go_to(const Waypoint& point) { place_ = lat_lon(point); }

    // `given`: the first parameters. A command that flies ends in the place, and has no yaw of its own.
    void append(MavCommand command, const std::vector<double>& given) {
        const bool flies = int(command) <= int(MavCommand::nav_last);
        const double altitude = command == MavCommand::nav_land ? 0 : *placed_.altitude;
        Json params = Json::array({0, 0, 0, 0, 0, 0, 0});
        if (flies) params = Json::array({0, 0, 0, nullptr, place_[0], place_[1], altitude});
        std::ranges::copy(given, params.begin());
        Json item{{"autoContinue", true},          {"command", int(command)},
                  {"doJumpId", items_.size() + 1}, {"frame", flies ? above_take_off : no_place},
                  {"params", std::move(params)},   {"type", "SimpleItem"}};
        if (flies) {
            item["AMSLAltAboveTerrain"] = nullptr;
            item["Altitude"] = altitude;
            item["AltitudeMode"] = altitude_above_take_off;
        }
        items_.push_back(std::move(item));
    }

    void loiter(double seconds) {
        if (seconds > 0) append(MavCommand::nav_loiter_time, {seconds});
    }

    // What is breached from here, one after the other, and whatever else the aircraft stays for.
    void stay(double from, const Waypoint& until) {
        for (const Breach* breach : breaches_) {
            if (breach->at.x != until.x || breach->at.y != until.y) continue;
            if (breach->cleared_at < from || breach->cleared_at > until.t) continue;
            const double begun = begun_at(placed_.plan, *breach);
            loiter(begun - from);
            append(MavCommand(breach_.command), breach_.params);
            loiter(breach->cleared_at - begun);
            from = breach->cleared_at;
        }
        loiter(until.t - from);
    }

    const PlacedPlan& placed_;
    const Itinerary& aircraft_;
    const MavAction& breach_;
    std::vector<const Breach*> breaches_ = {};
    Json place_ = {};
    Json items_ = Json::array();
};

std::string flight_text(const PlacedPlan& placed, const Itinerary& aircraft, const MavAction& breach) {
    require_no_hole(placed, aircraft, "QGroundControl");
    Flight flight(placed, aircraft, breach);
    const Json mission{{"version", 2},
                       {"firmwareType", any_autopilot},
                       {"vehicleType", multicopter},
                       {"globalPlanAltitudeMode", altitude_above_take_off},
                       {"cruiseSpeed", flight.speed()},
                       {"hoverSpeed", flight.speed()},
                       {"plannedHomePosition", flight.home()},
                       {"items", flight.items()}};
    // Readers reject a file without fence and rally points, even where there are none.
    const Json file{{"fileType", "Plan"},
                    {"version", 1},
                    {"groundStation", "waybreaker"},
                    {"mission", mission},
                    {"geoFence", {{"version", 2}, {"circles", Json::array()}, {"polygons", flight.fences()}}},
                    {"rallyPoints", {{"version", 2}, {"points", Json::array()}}}};
    return file.dump(2) + "\n";
}

// From landing to landing: a file has one take-off and one landing.
std::vector<Itinerary> flights_of(const Itinerary& aircraft) {
    std::vector<Itinerary> flights;
    double from = 0;
    const auto add_until = [&](double until) {
        Itinerary& flight = flights.emplace_back(aircraft);
        std::erase_if(flight.path, [&](const Waypoint& point) { return point.t < from || point.t > until; });
    };
    for (const Recharge& recharge : aircraft.recharges) {
        add_until(recharge.from);
        from = recharge.until;
    }
    add_until(std::numeric_limits<double>::infinity());
    return flights;
}

std::string name_for(const std::string& path, const std::string& id) {
    std::string word = id;
    const auto is_plain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
    };
    std::ranges::replace_if(
        word, [&](char c) { return !is_plain(c); }, '_');
    std::filesystem::path name(path);
    name.replace_filename(fmt::format("{}-{}{}", name.stem().string(), word, name.extension().string()));
    return name.string();
}

}  // namespace

std::vector<io::OutputFile> plan_qgc(const PlacedPlan& placed, const std::string& path, const MavAction& breach) {
    require_place(placed, "QGroundControl");
    if (!placed.altitude)
        throw InputError("QGroundControl needs to know how high aircraft fly; give --altitude METRES");
    if (placed.plan.revised) {
        throw InputError(
            "QGroundControl: flights begin with the take-off, and the aircraft of this revised plan are under way; "
            "--vda5050, --gpx and --kml take revised plans");
    }
    std::vector<const Itinerary*> aircraft;
    for (const Itinerary& agent : placed.plan.agents) {
        if (agent.kind == AgentKind::air) aircraft.push_back(&agent);
    }
    if (aircraft.empty() && !placed.plan.agents.empty())
        throw InputError("QGroundControl plans flights, and the plan has no aircraft");
    std::vector<io::OutputFile> files;
    std::set<std::string> names;
    for (const Itinerary* one : aircraft) {
        const std::vector<Itinerary> flights = flights_of(*one);
        const bool is_one = aircraft.size() == 1 && flights.size() == 1;
        if (!is_one && path == "-") {
            throw InputError(
                "QGroundControl has a file for each aircraft, and for each of its flights; name one, not standard "
                "output");
        }
        for (std::size_t i = 0; i < flights.size(); ++i) {
            std::string name = aircraft.size() == 1 ? path : name_for(path, one->id);
            if (flights.size() > 1) name = name_for(name, std::to_string(i + 1));
            if (!names.insert(name).second)
                throw InputError(fmt::format("two aircraft have ids that {} would stand for; rename one", name));
            files.push_back({std::move(name), flight_text(placed, flights[i], breach)});
        }
    }
    return files;
}

}  // namespace waybreaker::exports

#include "server/routes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/obstacles_json.hpp"
#include "io/plan_file.hpp"
#include "server/answers.hpp"
#include "server/problem.hpp"
#include "server/service.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

void give(httplib::Response& response, const std::string& body, const std::string& type = json_type) {
    response.status = ok;
    response.set_content(body, type);
}

PlanRequest plan_request(const std::string& body) {
    try {
        return parse_plan_request(body);
    } catch (const InputError& error) {
        throw Problem(bad_request, error.what());
    }
}

Connectivity connectivity_of(const httplib::Request& request) {
    if (!request.has_param("connectivity")) return Connectivity::four;
    const std::string word = request.get_param_value("connectivity");
    if (word != "4" && word != "8") throw Problem(bad_request, "connectivity is neither 4 nor 8");
    return word == "8" ? Connectivity::eight : Connectivity::four;
}

// "text/event-stream", where JSON would do as well only if it is named first.
bool wants_events(const httplib::Request& request) {
    return request.get_header_value("Accept").starts_with("text/event-stream");
}

using Answer = std::string (*)(const Task&, MissionPlanner&, const std::stop_token&);

// A route whose answer a worker plans.
Route planned(const std::string& name, Answer answer, MapShelf& shelf, Desk& desk, double seconds) {
    const auto handle = [answer, &shelf, &desk, seconds](const Call& call, httplib::Response& response) {
        const Task task{shelf.take(call.map), plan_request(call.body), seconds};
        const Work work = [answer, task](MissionPlanner& planner, const std::stop_token& stop) {
            return answer(task, planner, stop);
        };
        if (wants_events(call.request)) return desk.stream(work, response, call.ended);
        give(response, desk.wait_for(work, call.client_is_there));
    };
    return {"POST", "/api/v1/maps/{id}/" + name, Route::Body::json, false, handle};
}

Route upload(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call, httplib::Response& response) {
        const MapShelf::Upload added = shelf.add(call.body, connectivity_of(call.request));
        give(response, map_json(added.id, *added.map));
        if (!added.is_new) return;
        response.status = created;
        response.set_header("Location", "/api/v1/maps/" + added.id);
    };
    return {"POST", "/api/v1/maps", Route::Body::bytes, false, handle};
}

Route check_route(MapShelf& shelf, Desk& desk) {
    const auto handle = [&](const Call& call, httplib::Response& response) {
        const Work work = [map = shelf.take(call.map), plan = call.body](MissionPlanner&, const std::stop_token&) {
            return check_answer(*map, plan);
        };
        give(response, desk.wait_for(work, call.client_is_there));
    };
    return {"POST", "/api/v1/maps/{id}/check", Route::Body::json, false, handle};
}

Route export_route(MapShelf& shelf, Desk& desk) {
    const auto handle = [&](const Call& call, httplib::Response& response) {
        const std::string format = call.request.get_param_value("format");
        if (!is_export_format(format)) {
            throw Problem(bad_request, "format is none of json, geojson, csv, ros-path, xml, svg, png");
        }
        const Work work = [map = shelf.take(call.map), plan = call.body, format](MissionPlanner&,
                                                                                 const std::stop_token&) {
            return export_answer(*map, plan, format).body;
        };
        give(response, desk.wait_for(work, call.client_is_there), media_type_of(format));
    };
    return {"POST", "/api/v1/maps/{id}/export", Route::Body::json, false, handle};
}

Route get(const std::string& path, bool open, std::function<void(const Call&, httplib::Response&)> handle) {
    return {"GET", path, Route::Body::none, open, std::move(handle)};
}

std::string metrics_text(const MapShelf& shelf, const Desk& desk, const Metrics& metrics) {
    const auto maps = shelf.list();
    const auto loaded = std::count_if(maps.begin(), maps.end(), [](const auto& entry) { return entry.loaded; });
    return metrics.text({.waiting = desk.waiting(), .running = desk.running(), .maps = std::size_t(loaded)});
}

}  // namespace

std::optional<std::string> Route::id_in(const std::string& asked) const {
    const std::size_t place = path.find("{id}");
    if (place == std::string::npos) return asked == path ? std::optional(std::string()) : std::nullopt;
    const std::string before = path.substr(0, place);
    const std::string after = path.substr(place + 4);
    if (asked.size() < path.size() - 4 || !asked.starts_with(before) || !asked.ends_with(after)) return std::nullopt;
    const std::string id = asked.substr(place, asked.size() - (path.size() - 4));
    return MapShelf::is_id(id) ? std::optional(id) : std::nullopt;
}

std::vector<Route> routes(MapShelf& shelf, Desk& desk, const Metrics& metrics, const Limits& limits) {
    std::vector<Route> all;
    all.push_back(get("/healthz", true,
                      [](const Call&, httplib::Response& response) { give(response, "{\"status\": \"ok\"}\n"); }));
    all.push_back(get("/metrics", false, [&](const Call&, httplib::Response& response) {
        give(response, metrics_text(shelf, desk, metrics), "text/plain; version=0.0.4; charset=utf-8");
    }));
    all.push_back(get("/api/v1/openapi.json", true,
                      [](const Call&, httplib::Response& response) { give(response, openapi_json()); }));
    all.push_back(get("/api/v1/maps", false,
                      [&](const Call&, httplib::Response& response) { give(response, maps_json(shelf.list())); }));
    all.push_back(get("/api/v1/maps/{id}", false, [&](const Call& call, httplib::Response& response) {
        give(response, map_json(call.map, *shelf.take(call.map)));
    }));
    all.push_back(get("/api/v1/maps/{id}/obstacles", false, [&](const Call& call, httplib::Response& response) {
        give(response, io::obstacles_json(shelf.take(call.map)->file));
    }));
    all.push_back(upload(shelf));
    all.push_back(planned("plan", plan_answer, shelf, desk, limits.seconds));
    all.push_back(planned("front", front_answer, shelf, desk, limits.seconds));
    all.push_back(planned("compare", compare_answer, shelf, desk, limits.seconds));
    all.push_back(check_route(shelf, desk));
    all.push_back(export_route(shelf, desk));
    return all;
}

}  // namespace waybreaker::server

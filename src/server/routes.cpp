#include "server/routes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

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
        give(response, desk.wait_for(work));
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
        const SharedMap map = shelf.take(call.map);
        give(response, desk.wait_for([map, &call](MissionPlanner&, const std::stop_token&) {
            return check_answer(*map, call.body);
        }));
    };
    return {"POST", "/api/v1/maps/{id}/check", Route::Body::json, false, handle};
}

Route export_route(MapShelf& shelf, Desk& desk) {
    const auto handle = [&](const Call& call, httplib::Response& response) {
        const std::string format = call.request.get_param_value("format");
        if (!is_export_format(format)) {
            throw Problem(bad_request, "format is none of json, geojson, csv, ros-path, xml, svg, png");
        }
        const SharedMap map = shelf.take(call.map);
        const std::string body = desk.wait_for([map, &call, &format](MissionPlanner&, const std::stop_token&) {
            return export_answer(*map, call.body, format).body;
        });
        give(response, body, media_type_of(format));
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

std::string Route::pattern() const {
    std::string text;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path.compare(i, 4, "{id}") == 0) {
            text += "([A-Za-z0-9._-]{1,100})";
            i += 3;
        } else {
            text += path[i] == '.' ? "\\." : std::string(1, path[i]);
        }
    }
    return text;
}

bool Route::fits(const std::string& text) const {
    const std::size_t id = path.find("{id}");
    if (id == std::string::npos) return text == path;
    const std::string rest = path.substr(id + 4);
    if (text.size() < id + rest.size() || !text.starts_with(path.substr(0, id)) || !text.ends_with(rest)) return false;
    return MapShelf::is_id(text.substr(id, text.size() - id - rest.size()));
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
        give(response, obstacles_json(shelf.take(call.map)->file.map));
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

#include "server/routes.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/background_json.hpp"
#include "io/obstacles_json.hpp"
#include "server/answers.hpp"
#include "server/gzip.hpp"
#include "server/map_edits.hpp"
#include "server/problem.hpp"
#include "server/service.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

void give(httplib::Response& response, const std::string& body, const std::string& type = json_type) {
    response.status = ok;
    response.set_content(body, type);
}

// The same of what may be long, compressed for who takes it.
void give_packed(const Call& call, httplib::Response& response, const std::string& body,
                 const std::string& type = json_type) {
    constexpr std::size_t packet = 1400;  // what fits one is sent as fast either way
    constexpr int quick = 1;
    response.set_header("Vary", "Accept-Encoding");
    if (body.size() < packet || !accepts_gzip(call.request.get_header_value("Accept-Encoding"))) {
        return give(response, body, type);
    }
    give(response, gzip(body, quick), type);
    response.set_header("Content-Encoding", "gzip");
}

template <class Parse>
auto read_request(Parse parse) try {
    return parse();
} catch (const InputError& error) {
    throw Problem(bad_request, error.what());
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

using Answer = std::string (*)(const Task&, const Workplace&);

// A route whose answer a worker plans.
Route planned(const std::string& name, Answer answer, MapShelf& shelf, Desk& desk, double seconds) {
    const auto handle = [answer, &shelf, &desk, seconds](const Call& call, httplib::Response& response) {
        const Task task{shelf.take(call.map), read_request([&call] { return parse_plan_request(call.body); }), seconds};
        const Work work = [answer, task](const Workplace& place) { return answer(task, place); };
        if (wants_events(call.request)) return desk.stream(work, response, call.ended);
        give(response, desk.wait_for(work, call.client_is_there));
    };
    return {"POST", "/api/v1/maps/{id}/" + name, Route::Body::json, false, handle};
}

void give_upload(const MapShelf::Upload& added, httplib::Response& response) {
    give(response, map_json(added.id, *added.map));
    if (!added.is_new) return;
    response.status = created;
    response.set_header("Location", "/api/v1/maps/" + added.id);
}

Route upload(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call, httplib::Response& response) {
        give_upload(shelf.add(call.body, connectivity_of(call.request)), response);
    };
    return {"POST", "/api/v1/maps", Route::Body::bytes, false, handle};
}

Route edits_route(MapShelf& shelf, Desk& desk) {
    const auto handle = [&](const Call& call, httplib::Response& response) {
        const SharedMap map = shelf.take(call.map);
        const MapEdits edits = read_request([&call] { return parse_map_edits(call.body); });
        const auto added = std::make_shared<MapShelf::Upload>();
        const Work work = [&shelf, map, edits, added](const Workplace&) {
            *added = shelf.keep(edited_map(*map, edits));
            return std::string();
        };
        desk.wait_for(work, call.client_is_there);
        give_upload(*added, response);
    };
    return {"POST", "/api/v1/maps/{id}/edits", Route::Body::json, false, handle};
}

Route file_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call, httplib::Response& response) {
        const SharedMap map = shelf.take(call.map);
        if (map->bytes.empty()) throw Problem(unprocessable, call.map + " is a ROS map: two files, not one");
        give(response, map->bytes, "application/octet-stream");
        response.set_header("Content-Disposition", "attachment; filename=\"" + file_name(call.map, *map) + "\"");
    };
    return {"GET", "/api/v1/maps/{id}/file", Route::Body::none, false, handle};
}

Route delete_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call, httplib::Response& response) {
        shelf.remove(call.map);
        response.status = no_content;
    };
    return {"DELETE", "/api/v1/maps/{id}", Route::Body::none, false, handle};
}

Route check_route(MapShelf& shelf, Desk& desk) {
    const auto handle = [&](const Call& call, httplib::Response& response) {
        const Work work = [map = shelf.take(call.map), plan = call.body](const Workplace&) {
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
        const Work work = [map = shelf.take(call.map), plan = call.body, format](const Workplace&) {
            return export_answer(*map, plan, format).body;
        };
        give_packed(call, response, desk.wait_for(work, call.client_is_there), media_type_of(format));
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
        give_packed(call, response, io::obstacles_json(shelf.take(call.map)->file));
    }));
    all.push_back(get("/api/v1/maps/{id}/background", false, [&](const Call& call, httplib::Response& response) {
        give_packed(call, response, io::background_json(shelf.take(call.map)->file.background));
    }));
    all.push_back(file_route(shelf));
    all.push_back(upload(shelf));
    all.push_back(edits_route(shelf, desk));
    all.push_back(delete_route(shelf));
    all.push_back(planned("plan", plan_answer, shelf, desk, limits.seconds));
    all.push_back(planned("front", front_answer, shelf, desk, limits.seconds));
    all.push_back(planned("compare", compare_answer, shelf, desk, limits.seconds));
    all.push_back(check_route(shelf, desk));
    all.push_back(export_route(shelf, desk));
    return all;
}

}  // namespace waybreaker::server

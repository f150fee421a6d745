#include "server/routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/background_json.hpp"
#include "io/obstacles_json.hpp"
#include "server/answers.hpp"
#include "server/gzip.hpp"
#include "server/map_edits.hpp"
#include "server/problem.hpp"
#include "server/problem_kind.hpp"
#include "server/service.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

Response given(Body body, const std::string& type = json_type) {
    return {.type = type, .body = std::move(body)};
}

// The same of what may be long, compressed for who takes it.
Response packed(const std::string& accept_encoding, std::string body, const std::string& type = json_type) {
    constexpr std::size_t packet = 1400;  // what fits one is sent as fast either way
    constexpr int quick = 1;
    const bool pack = body.size() >= packet && accepts_gzip(accept_encoding);
    Response response = given(pack ? gzip(body, quick) : std::move(body), type);
    response.headers.add("Vary", "Accept-Encoding");
    if (pack) response.headers.add("Content-Encoding", "gzip");
    return response;
}

std::string accepted_encodings(const Call& call) {
    return call.request.headers.get("Accept-Encoding");
}

template <class Parse>
auto read_request(Parse parse) try {
    return parse();
} catch (const InputError& error) {
    throw Problem(bad_request, error.what());
}

Connectivity connectivity_of(const Request& request) {
    const std::string word = request.query.find("connectivity").value_or("4");
    if (word != "4" && word != "8") throw Problem(bad_request, "connectivity is neither 4 nor 8");
    return word == "8" ? Connectivity::eight : Connectivity::four;
}

// "text/event-stream", where JSON would do as well only if it is named first.
bool wants_events(const Request& request) {
    return request.headers.get("Accept").starts_with("text/event-stream");
}

using PlanAnswer = std::string (*)(const Task&, const Workplace&);

// A route whose answer a worker plans.
Route planned(const std::string& name, PlanAnswer answer, MapShelf& shelf, double seconds) {
    const auto handle = [answer, &shelf, seconds](const Call& call) -> Answer {
        const Task task{shelf.take(call.map), read_request([&call] { return parse_plan_request(call.request.body); }),
                        seconds};
        return Later{.work = [answer, task](const Workplace& place) { return given(answer(task, place)); },
                     .events = wants_events(call.request)};
    };
    return {"POST", "/api/v1/maps/{id}/" + name, Route::Body::json, false, handle};
}

Response given_upload(const MapShelf::Upload& added) {
    Response response = given(map_json(added.id, *added.map));
    if (!added.is_new) return response;
    response.status = created;
    response.headers.add("Location", "/api/v1/maps/" + added.id);
    return response;
}

Route upload(MapShelf& shelf) {
    const auto handle = [&shelf](Call call) -> Answer {
        const Connectivity connectivity = connectivity_of(call.request);
        return given_upload(shelf.add(std::move(call.request.body), connectivity));
    };
    return {"POST", "/api/v1/maps", Route::Body::bytes, false, handle};
}

Route edits_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        const SharedMap map = shelf.take(call.map);
        const MapEdits edits = read_request([&call] { return parse_map_edits(call.request.body); });
        return Later{
            [&shelf, map, edits](const Workplace&) { return given_upload(shelf.keep(edited_map(*map, edits))); }};
    };
    return {"POST", "/api/v1/maps/{id}/edits", Route::Body::json, false, handle};
}

Route file_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        const SharedMap map = shelf.take(call.map);
        if (map->bytes.empty())
            throw Problem(unprocessable, call.map + " is a ROS map: two files, not one", "map-of-many-files");
        Response response = given({map, map->bytes}, "application/octet-stream");
        response.headers.add("Content-Disposition", "attachment; filename=\"" + file_name(call.map, *map) + "\"");
        return response;
    };
    return {"GET", "/api/v1/maps/{id}/file", Route::Body::none, false, handle};
}

Route delete_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        shelf.remove(call.map);
        return Response{.status = no_content};
    };
    return {"DELETE", "/api/v1/maps/{id}", Route::Body::none, false, handle};
}

Route check_route(MapShelf& shelf) {
    const auto handle = [&shelf](Call call) -> Answer {
        return Later{[map = shelf.take(call.map), plan = std::move(call.request.body)](const Workplace&) {
            return given(check_answer(*map, plan));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/check", Route::Body::json, false, handle};
}

Route export_route(MapShelf& shelf) {
    const auto handle = [&shelf](Call call) -> Answer {
        const std::string format = call.request.query.get("format");
        if (!is_export_format(format)) {
            throw Problem(bad_request, "format is none of json, geojson, csv, ros-path, xml, svg, png");
        }
        return Later{[map = shelf.take(call.map), plan = std::move(call.request.body), format,
                      encodings = accepted_encodings(call)](const Workplace&) {
            return packed(encodings, export_answer(*map, plan, format).body, media_type_of(format));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/export", Route::Body::json, false, handle};
}

Route get(const std::string& path, std::function<Answer(Call)> handle) {
    return {"GET", path, Route::Body::none, false, std::move(handle)};
}

// Something that everybody may have, and that is there already.
Route ready(const std::string& path, const std::string& document) {
    const auto body = std::make_shared<const std::string>(document);
    const auto handle = [body](const Call&) { return given({body, *body}); };
    return {"GET", path, Route::Body::none, true, handle, true};
}

Response described(const std::string& problem) {
    const ProblemKind* const kind = kind_of(problem);
    if (kind == nullptr) throw Problem(not_found, "there is no problem of that name");
    return given(fmt::format("{}\n\n{}. {}\n", kind->name, kind->title, kind->remedy), "text/plain; charset=utf-8");
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

std::vector<Route> routes(MapShelf& shelf, const Desk& desk, const Metrics& metrics, const Limits& limits) {
    std::vector<Route> all;
    all.push_back(ready("/healthz", "{\"status\": \"ok\"}\n"));
    all.push_back(ready("/api/v1/openapi.json", openapi_json()));
    all.push_back(get("/metrics", [&](const Call&) {
        return given(metrics_text(shelf, desk, metrics), "text/plain; version=0.0.4; charset=utf-8");
    }));
    all.push_back(
        {"GET", "/problems/{id}", Route::Body::none, true, [](const Call& call) { return described(call.map); }, true});
    all.push_back(get("/api/v1/maps", [&](const Call&) { return given(maps_json(shelf.list())); }));
    all.push_back(
        get("/api/v1/maps/{id}", [&](const Call& call) { return given(map_json(call.map, *shelf.take(call.map))); }));
    all.push_back(get("/api/v1/maps/{id}/obstacles", [&](const Call& call) {
        return packed(accepted_encodings(call), io::obstacles_json(shelf.take(call.map)->file));
    }));
    all.push_back(get("/api/v1/maps/{id}/background", [&](const Call& call) {
        return packed(accepted_encodings(call), io::background_json(shelf.take(call.map)->file.background));
    }));
    all.push_back(file_route(shelf));
    all.push_back(upload(shelf));
    all.push_back(edits_route(shelf));
    all.push_back(delete_route(shelf));
    all.push_back(planned("plan", plan_answer, shelf, limits.seconds));
    all.push_back(planned("front", front_answer, shelf, limits.seconds));
    all.push_back(planned("compare", compare_answer, shelf, limits.seconds));
    all.push_back(check_route(shelf));
    all.push_back(export_route(shelf));
    return all;
}

}  // namespace waybreaker::server

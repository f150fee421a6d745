#include "server/routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/background_json.hpp"
#include "io/obstacles_json.hpp"
#include "mapfile/digest.hpp"
#include "server/answers.hpp"
#include "server/entity_tag.hpp"
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

// An answer about a map: at once if it is in memory, else by a worker, who reads it first.
Answer of_map(MapShelf& shelf, const std::string& id, std::function<Response(const SharedMap&)> answer) {
    if (const SharedMap map = shelf.at_hand(id)) return answer(map);
    return Later{[&shelf, id, answer = std::move(answer)](const Workplace&) { return answer(shelf.take(id)); }};
}

// A map that work to come needs: it stays, if it is in memory, and is read by the worker otherwise. Throws Problem if
// there is none.
class NeededMap {
  public:
    NeededMap(MapShelf& shelf, const std::string& id) : shelf_(&shelf), id_(id), map_(shelf.at_hand(id)) {}
    SharedMap take() const { return map_ ? map_ : shelf_->take(id_); }

  private:
    MapShelf* shelf_;
    std::string id_;
    SharedMap map_;
};

// Whatever changes answers about a map but the map itself: another version of the service.
const std::string& edition() {
    static const std::string digest = mapfile::sha256_digest(openapi_json());
    return digest;
}

// A tag of what `part` of the service says of a map.
std::string tag_of(const ShelvedMap& map, const std::string& part) {
    return entity_tag(mapfile::sha256_digest(fmt::format("{} {} {} {} {} {}", map.file.digest, int(map.connectivity),
                                                         part, edition(), map.file.title, map.file.attribution)));
}

// What a client can keep and ask for again.
Answer tagged(const Call& call, MapShelf& shelf, const std::string& part,
              std::function<Response(const SharedMap&)> answer) {
    return of_map(shelf, call.map, [headers = call.request.headers, part, answer](const SharedMap& map) {
        const std::string tag = tag_of(*map, part);
        if (has_already(headers, tag)) return not_changed(tag);
        Response response = answer(map);
        add_tag(response, tag);
        return response;
    });
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
        const NeededMap map(shelf, call.map);
        const PlanRequest request = read_request([&call] { return parse_plan_request(call.request.body); });
        const Work work = [answer, map, request, seconds](const Workplace& place) {
            return given(answer({map.take(), request, seconds}, place));
        };
        return Later{.work = work, .events = wants_events(call.request)};
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
        return Later{[&shelf, connectivity, bytes = std::move(call.request.body)](const Workplace&) mutable {
            return given_upload(shelf.add(std::move(bytes), connectivity));
        }};
    };
    return {"POST", "/api/v1/maps", Route::Body::bytes, false, handle};
}

Route edits_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        const NeededMap needed(shelf, call.map);
        const MapEdits edits = read_request([&call] { return parse_map_edits(call.request.body); });
        return Later{[&shelf, needed, edits](const Workplace&) {
            const SharedMap map = needed.take();
            return given_upload(shelf.add([&](const MapLimits& limits) { return edited_map(*map, edits, limits); }));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/edits", Route::Body::json, false, handle};
}

Route file_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        return tagged(call, shelf, "file", [id = call.map](const SharedMap& map) {
            if (map->bytes.empty()) {
                throw Problem(unprocessable, id + " is a ROS map: two files, not one", "map-of-many-files");
            }
            Response response = given({map, map->bytes}, "application/octet-stream");
            response.headers.add("Content-Disposition", "attachment; filename=\"" + file_name(id, *map) + "\"");
            return response;
        });
    };
    return {"GET", "/api/v1/maps/{id}/file", Route::Body::none, false, handle};
}

// A number in the query.
std::size_t number_of(const Request& request, const std::string& name, std::size_t otherwise, std::size_t least,
                      std::size_t most) {
    const std::optional<std::string> text = request.query.find(name);
    if (!text) return otherwise;
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (error != std::errc() || end != text->data() + text->size() || value < least || value > most) {
        throw Problem(bad_request, fmt::format("{} is no number from {} to {}", name, least, most));
    }
    return value;
}

Route obstacles_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        constexpr std::size_t most = 100'000;
        const std::size_t after = number_of(call.request, "after", 0, 0, max_cells);
        const std::size_t limit = number_of(call.request, "limit", most, 1, most);
        return tagged(call, shelf, fmt::format("obstacles {} {}", after, limit),
                      [after, limit, encodings = accepted_encodings(call)](const SharedMap& map) {
                          return packed(encodings, io::obstacles_part(map->file, after, limit).json);
                      });
    };
    return {"GET", "/api/v1/maps/{id}/obstacles", Route::Body::none, false, handle};
}

Route background_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        return tagged(call, shelf, "background", [encodings = accepted_encodings(call)](const SharedMap& map) {
            return packed(encodings, io::background_json(map->file.background));
        });
    };
    return {"GET", "/api/v1/maps/{id}/background", Route::Body::none, false, handle};
}

Route map_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        return tagged(call, shelf, "map", [id = call.map](const SharedMap& map) { return given(map_json(id, *map)); });
    };
    return {"GET", "/api/v1/maps/{id}", Route::Body::none, false, handle};
}

Route delete_route(MapShelf& shelf) {
    const auto handle = [&shelf](const Call& call) -> Answer {
        shelf.remove(call.map);
        return Response{.status = no_content};
    };
    return {"DELETE", "/api/v1/maps/{id}", Route::Body::none, false, handle};
}

// Read, JSON takes forty times its bytes.
void require_plan_size(const Request& request) {
    constexpr std::size_t most = std::size_t{4} << 20;
    if (request.body.size() <= most) return;
    throw Problem(too_large, "a plan has at most " + std::to_string(most) + " bytes");
}

Route check_route(MapShelf& shelf) {
    const auto handle = [&shelf](Call call) -> Answer {
        require_plan_size(call.request);
        return Later{[map = NeededMap(shelf, call.map), plan = std::move(call.request.body)](const Workplace&) {
            return given(check_answer(*map.take(), plan));
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
        require_plan_size(call.request);
        return Later{[map = NeededMap(shelf, call.map), plan = std::move(call.request.body), format,
                      encodings = accepted_encodings(call)](const Workplace&) {
            return packed(encodings, export_answer(*map.take(), plan, format).body, media_type_of(format));
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
    return metrics.text({.waiting = desk.waiting(),
                         .running = desk.running(),
                         .maps = std::size_t(loaded),
                         .map_bytes = shelf.memory()});
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

std::vector<Route> routes(MapShelf& shelf, const Desk& desk, const Metrics& metrics, const ServiceLimits& limits) {
    std::vector<Route> all;
    all.push_back(ready("/healthz", "{\"status\": \"ok\"}\n"));
    all.push_back(ready("/api/v1/openapi.json", openapi_json()));
    all.push_back(ready("/api/v1/mission.schema.json", mission_schema()));
    all.push_back(get("/metrics", [&](const Call&) {
        return given(metrics_text(shelf, desk, metrics), "text/plain; version=0.0.4; charset=utf-8");
    }));
    all.push_back(
        {"GET", "/problems/{id}", Route::Body::none, true, [](const Call& call) { return described(call.map); }, true});
    all.push_back(get("/api/v1/maps", [&](const Call&) { return given(maps_json(shelf.list())); }));
    all.push_back(map_route(shelf));
    all.push_back(obstacles_route(shelf));
    all.push_back(background_route(shelf));
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

#include "service/routes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "http/entity_tag.hpp"
#include "http/gzip.hpp"
#include "http/problem.hpp"
#include "io/background_json.hpp"
#include "io/obstacles_json.hpp"
#include "mapfile/digest.hpp"
#include "service/answers.hpp"
#include "service/edited_map.hpp"
#include "service/plan_events.hpp"
#include "service/problem_kind.hpp"
#include "service/responses.hpp"
#include "service/service.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

// A body that may be long: compressed if the client accepts gzip.
http::Response compressible_response(const std::string& accept_encoding, std::string body,
                                     const std::string& type = json_type) {
    constexpr std::size_t packet = 1400;  // bytes; compressing what fits one packet saves no time
    constexpr int quick = 1;
    const bool pack = body.size() >= packet && http::accepts_gzip(accept_encoding);
    http::Response response = ok_response(pack ? http::gzip(body, quick) : std::move(body), type);
    response.headers.add("Vary", "Accept-Encoding");
    if (pack) response.headers.add("Content-Encoding", "gzip");
    return response;
}

std::string accepted_encodings(const Call& call) {
    return call.request.headers.get("Accept-Encoding");
}

// Responds at once if the map is in memory; else a worker loads it first.
Answer of_map(MapStore& store, const std::string& id, std::function<http::Response(const SharedMap&)> answer) {
    if (const SharedMap map = store.if_loaded(id)) return answer(map);
    return Deferred{[&store, id, answer = std::move(answer)](const http::Worker&) { return answer(store.load(id)); }};
}

// A map that deferred work needs: kept if it is in memory, otherwise loaded by the worker. Throws Problem if there is
// no such map.
class NeededMap {
  public:
    NeededMap(MapStore& store, const std::string& id) : store_(&store), id_(id), map_(store.if_loaded(id)) {}
    SharedMap load() const { return map_ ? map_ : store_->load(id_); }

  private:
    MapStore* store_;
    std::string id_;
    SharedMap map_;
};

// Identifies the version of the service, which entity tags must depend on.
const std::string& edition() {
    static const std::string digest = mapfile::sha256_digest(openapi_json());
    return digest;
}

// The entity tag of one part of a map's documents.
std::string tag_of(const StoredMap& map, const std::string& part) {
    return http::entity_tag(
        mapfile::sha256_digest(fmt::format("{} {} {} {} {} {}", map.file.digest, int(map.connectivity), part, edition(),
                                           map.file.annotations.title, map.file.annotations.attribution)));
}

// A response that clients can cache and revalidate.
Answer tagged(const Call& call, MapStore& store, const std::string& part,
              const std::function<http::Response(const SharedMap&)>& answer) {
    return of_map(store, call.id, [headers = call.request.headers, part, answer](const SharedMap& map) {
        const std::string tag = tag_of(*map, part);
        if (http::has_already(headers, tag)) return http::not_changed(tag);
        http::Response response = answer(map);
        http::add_tag(response, tag);
        return response;
    });
}

Connectivity connectivity_of(const http::Request& request) {
    const std::string word = request.query.find("connectivity").value_or("4");
    if (word != "4" && word != "8") throw http::Problem(http::bad_request, "connectivity is neither 4 nor 8");
    return word == "8" ? Connectivity::eight : Connectivity::four;
}

// Whether "text/event-stream" is the first type the client accepts.
bool wants_events(const http::Request& request) {
    return request.headers.get("Accept").starts_with("text/event-stream");
}

using PlanAnswer = std::string (*)(const Task&, const http::Worker&);

// A route whose response a worker plans.
Route plan_route(const std::string& name, PlanAnswer answer, MapStore& store, PlannerPool& planners, double seconds) {
    const auto handle = [answer, &store, &planners, seconds](const Call& call) -> Answer {
        const NeededMap map(store, call.id);
        const request::PlanRequest request =
            read_request([&call] { return request::parse_plan_request(call.request.body); });
        const auto last = std::make_shared<LastReport>();
        const http::Work work = [answer, map, request, &planners, seconds, last](const http::Worker& worker) {
            const auto report = [last](const Progress& progress) { last->set(progress); };
            return ok_response(answer({map.load(), request, planners, seconds, report}, worker));
        };
        Deferred deferred{.work = work};
        if (wants_events(call.request))
            deferred.progress = [last](const http::Job& job) { return progress_event(job, last->get()); };
        return deferred;
    };
    return {"POST", "/api/v1/maps/{id}/" + name, http::BodyType::json, false, handle};
}

Route upload_route(MapStore& store) {
    const auto handle = [&store](Call call) -> Answer {
        const Connectivity connectivity = connectivity_of(call.request);
        http::Work work = [&store, connectivity, bytes = std::move(call.request.body)](const http::Worker&) mutable {
            return upload_response(store.add(std::move(bytes), connectivity));
        };
        return Deferred{.work = std::move(work), .lane = Lane::uploading};
    };
    return {"POST", "/api/v1/maps", http::BodyType::bytes, false, handle};
}

Route edits_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        const NeededMap needed(store, call.id);
        const request::MapEdits edits = read_request([&call] { return request::parse_map_edits(call.request.body); });
        http::Work work = [&store, needed, edits](const http::Worker&) {
            const SharedMap map = needed.load();
            return upload_response(store.add([&](const MapLimits& limits) { return edited_map(*map, edits, limits); }));
        };
        return Deferred{.work = std::move(work), .lane = Lane::uploading};
    };
    return {"POST", "/api/v1/maps/{id}/edits", http::BodyType::json, false, handle};
}

Route file_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        return tagged(call, store, "file", [id = call.id](const SharedMap& map) {
            if (map->bytes.empty()) {
                throw http::Problem(http::unprocessable, id + " is a ROS map: two files, not one", "map-of-many-files");
            }
            http::Response response = ok_response({map, map->bytes}, "application/octet-stream");
            response.headers.add("Content-Disposition", "attachment; filename=\"" + file_name(id, *map) + "\"");
            return response;
        });
    };
    return {"GET", "/api/v1/maps/{id}/file", http::BodyType::none, false, handle};
}

Route obstacles_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        constexpr std::size_t most = 100'000;
        const std::size_t after = number_of(call.request, "after", 0, 0, max_cells);
        const std::size_t limit = number_of(call.request, "limit", most, 1, most);
        return tagged(call, store, fmt::format("obstacles {} {}", after, limit),
                      [after, limit, encodings = accepted_encodings(call)](const SharedMap& map) {
                          return compressible_response(encodings, io::obstacles_part(map->file, after, limit).json);
                      });
    };
    return {"GET", "/api/v1/maps/{id}/obstacles", http::BodyType::none, false, handle};
}

Route background_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        return tagged(call, store, "background", [encodings = accepted_encodings(call)](const SharedMap& map) {
            return compressible_response(encodings, io::background_json(map->file.annotations.background));
        });
    };
    return {"GET", "/api/v1/maps/{id}/background", http::BodyType::none, false, handle};
}

Route map_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        return tagged(call, store, "map",
                      [id = call.id](const SharedMap& map) { return ok_response(map_json(id, *map)); });
    };
    return {"GET", "/api/v1/maps/{id}", http::BodyType::none, false, handle};
}

Route delete_route(MapStore& store) {
    const auto handle = [&store](const Call& call) -> Answer {
        store.remove(call.id);
        return http::Response{.status = http::no_content};
    };
    return {"DELETE", "/api/v1/maps/{id}", http::BodyType::none, false, handle};
}

Route check_route(MapStore& store) {
    const auto handle = [&store](Call call) -> Answer {
        require_size(call.request, "a plan");
        return Deferred{[map = NeededMap(store, call.id), plan = std::move(call.request.body)](const http::Worker&) {
            return ok_response(check_answer(*map.load(), plan));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/check", http::BodyType::json, false, handle};
}

Route revise_route(MapStore& store, PlannerPool& planners, double seconds) {
    const auto handle = [&store, &planners, seconds](Call call) -> Answer {
        require_size(call.request, "a plan with a state");
        return Deferred{[map = NeededMap(store, call.id), body = std::move(call.request.body), &planners,
                         seconds](const http::Worker& worker) {
            const request::RevisionRequest asked =
                read_request([&body] { return request::parse_revision_request(body); });
            return ok_response(revise_answer(map.load(), asked, planners, seconds, worker));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/revise", http::BodyType::json, false, handle};
}

Route export_route(MapStore& store) {
    const auto handle = [&store](Call call) -> Answer {
        const std::string format = call.request.query.get("format");
        if (!is_export_format(format)) {
            throw http::Problem(http::bad_request,
                                "format is none of json, geojson, csv, ros-path, xml, svg, png, html, reach");
        }
        require_size(call.request, "a plan");
        return Deferred{[map = NeededMap(store, call.id), plan = std::move(call.request.body), format,
                         encodings = accepted_encodings(call)](const http::Worker&) {
            return compressible_response(encodings, export_answer(*map.load(), plan, format).body,
                                         media_type_of(format));
        }};
    };
    return {"POST", "/api/v1/maps/{id}/export", http::BodyType::json, false, handle};
}

Route get(const std::string& path, std::function<Answer(Call)> handle) {
    return {"GET", path, http::BodyType::none, false, std::move(handle)};
}

// A public document that is ready to send.
Route ready(const std::string& path, std::string_view document) {
    const auto body = std::make_shared<const std::string>(document);
    const auto handle = [body](const Call&) { return ok_response({body, *body}); };
    return {"GET", path, http::BodyType::none, true, handle, true};
}

http::Response described(const std::string& problem) {
    const ProblemKind* const kind = kind_of(problem);
    if (kind == nullptr) throw http::Problem(http::not_found, "there is no problem of that name");
    return ok_response(fmt::format("{}\n\n{}. {}\n", kind->name, kind->title, kind->remedy),
                       "text/plain; charset=utf-8");
}

}  // namespace

std::vector<Route> routes(MapStore& store, PlannerPool& planners, const ServiceLimits& limits) {
    std::vector<Route> all;
    all.push_back(ready("/healthz", "{\"status\": \"ok\"}\n"));
    all.push_back(ready("/api/v1/openapi.json", openapi_json()));
    all.push_back(ready("/api/v1/mission.schema.json", mission_schema()));
    all.push_back({"GET", "/problems/{id}", http::BodyType::none, true,
                   [](const Call& call) { return described(call.id); }, true});
    all.push_back(get("/api/v1/maps", [&](const Call&) { return ok_response(maps_json(store.list())); }));
    all.push_back(map_route(store));
    all.push_back(obstacles_route(store));
    all.push_back(background_route(store));
    all.push_back(file_route(store));
    all.push_back(upload_route(store));
    all.push_back(edits_route(store));
    all.push_back(delete_route(store));
    all.push_back(plan_route("plan", plan_answer, store, planners, limits.seconds));
    all.push_back(plan_route("front", front_answer, store, planners, limits.seconds));
    all.push_back(plan_route("compare", compare_answer, store, planners, limits.seconds));
    all.push_back(check_route(store));
    all.push_back(revise_route(store, planners, limits.seconds));
    all.push_back(export_route(store));
    return all;
}

}  // namespace waybreaker::service

#include "server/import_routes.hpp"

#include <string>
#include <utility>

#include "server/import_request.hpp"
#include "server/problem.hpp"
#include "server/responses.hpp"

namespace waybreaker::server {
namespace {

std::string name_of(const Request& request) {
    std::string name = request.query.find("name").value_or("source");
    if (!SourceStore::is_name(name)) {
        throw Problem(bad_request, "name has other characters than letters, digits, dots, dashes and underscores");
    }
    return name;
}

Route send_route(SourceStore& sources) {
    const auto handle = [&sources](Call call) -> Answer {
        return Deferred{[&sources, name = name_of(call.request),
                         bytes = std::move(call.request.body)](const Worker& worker) mutable {
            const SourceStore::Added added = sources.add(std::move(bytes), name, worker.stop);
            return kept_response(source_json(added.id, *added.source), "/api/v1/sources/" + added.id, added.is_new);
        }};
    };
    return {"POST", "/api/v1/sources", Route::Body::bytes, false, handle};
}

Route describe_route(SourceStore& sources) {
    const auto handle = [&sources](const Call& call) -> Answer {
        return ok_response(source_json(call.id, *sources.find(call.id)));
    };
    return {"GET", "/api/v1/sources/{id}", Route::Body::none, false, handle};
}

Route forget_route(SourceStore& sources) {
    const auto handle = [&sources](const Call& call) -> Answer {
        sources.remove(call.id);
        return Response{.status = no_content};
    };
    return {"DELETE", "/api/v1/sources/{id}", Route::Body::none, false, handle};
}

Route import_route(SourceStore& sources, MapStore& maps) {
    const auto handle = [&sources, &maps](const Call& call) -> Answer {
        const ImportRequest asked = read_request([&call] { return parse_import_request(call.request.body); });
        return Deferred{[&maps, asked, source = sources.find(asked.source)](const Worker& worker) {
            return upload_response(
                maps.add([&](const MapLimits& limits) { return imported_map(*source, asked, limits, worker.stop); }));
        }};
    };
    return {"POST", "/api/v1/imports", Route::Body::json, false, handle};
}

}  // namespace

std::vector<Route> import_routes(SourceStore& sources, MapStore& maps) {
    return {send_route(sources), describe_route(sources), forget_route(sources), import_route(sources, maps)};
}

}  // namespace waybreaker::server

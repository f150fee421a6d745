#include "service/import_routes.hpp"

#include <string>
#include <utility>

#include "http/problem.hpp"
#include "mapfile/map_reader.hpp"
#include "service/import_request.hpp"
#include "service/memory_account.hpp"
#include "service/responses.hpp"

namespace waybreaker::service {
namespace {

std::string name_of(const http::Request& request) {
    std::string name = request.query.find("name").value_or("source");
    if (!SourceStore::is_name(name)) {
        throw http::Problem(http::bad_request,
                            "name has other characters than letters, digits, dots, dashes and underscores");
    }
    return name;
}

Route send_route(SourceStore& sources) {
    const auto handle = [&sources](Call call) -> Answer {
        http::Work work = [&sources, name = name_of(call.request),
                           bytes = std::move(call.request.body)](const http::Worker& worker) mutable {
            const SourceStore::Added added = sources.add(std::move(bytes), name, worker.stop);
            return kept_response(source_json(added.id, *added.source), "/api/v1/sources/" + added.id, added.is_new);
        };
        return Deferred{.work = std::move(work), .lane = Lane::importing};
    };
    return {"POST", "/api/v1/sources", http::BodyType::bytes, false, handle};
}

Route describe_route(SourceStore& sources) {
    const auto handle = [&sources](const Call& call) -> Answer {
        return ok_response(source_json(call.id, *sources.find(call.id)));
    };
    return {"GET", "/api/v1/sources/{id}", http::BodyType::none, false, handle};
}

Route forget_route(SourceStore& sources) {
    const auto handle = [&sources](const Call& call) -> Answer {
        sources.remove(call.id);
        return http::Response{.status = http::no_content};
    };
    return {"DELETE", "/api/v1/sources/{id}", http::BodyType::none, false, handle};
}

// Read back, so that it equals an upload of the file that the command would write.
StoredMap stored(std::string tiff, const MapLimits& limits) {
    const MemoryAccount::Scope none(nullptr);  // the limits count the map
    io::MapFile file = mapfile::parse_map(tiff, "the map", Connectivity::four, {}, limits);
    return {.file = std::move(file), .bytes = std::move(tiff)};
}

Route import_route(const Importer& importer, SourceStore& sources, MapStore& maps) {
    const auto handle = [&](const Call& call) -> Answer {
        const ImportRequest asked = read_request([&call] { return parse_import_request(call.request.body); });
        http::Work work = [&, asked, source = sources.find(asked.source)](const http::Worker& worker) {
            return upload_response(maps.add([&](const MapLimits& limits) {
                return stored(
                    importer.import(source->name, source->bytes, source->extract, asked, limits.cells, worker.stop),
                    limits);
            }));
        };
        return Deferred{.work = std::move(work), .lane = Lane::importing};
    };
    return {"POST", "/api/v1/imports", http::BodyType::json, false, handle};
}

}  // namespace

std::vector<Route> import_routes(const Importer& importer, SourceStore& sources, MapStore& maps) {
    return {send_route(sources), describe_route(sources), forget_route(sources), import_route(importer, sources, maps)};
}

}  // namespace waybreaker::service

#include "service/overlay_route.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "http/problem.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/map_writer.hpp"
#include "mapfile/relabelled_map.hpp"
#include "service/memory_account.hpp"
#include "service/responses.hpp"
#include "service/source_store.hpp"

namespace waybreaker::service {
namespace {

constexpr double widest = 10000;  // metres, as of the command

site::OverlayUse use_of(const http::Request& request) {
    const std::string word = request.query.get("as");
    const auto* const found = std::ranges::find(site::overlay_use_words, word);
    if (found != site::overlay_use_words.end()) return site::OverlayUse(found - site::overlay_use_words.begin());
    throw http::Problem(http::bad_request, fmt::format("as is none of {}", fmt::join(site::overlay_use_words, ", ")));
}

double width_of(const http::Request& request) {
    const std::optional<std::string> text = request.query.find("width");
    if (!text) return 0;
    double width = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), width);
    if (error == std::errc() && end == text->data() + text->size() && width > 0 && width <= widest) return width;
    throw http::Problem(http::bad_request, fmt::format("width is no number of metres up to {}", widest));
}

city::OverlaySource overlay_of(const http::Request& request) {
    const std::string name = request.query.find("name").value_or("overlay");
    if (!SourceStore::is_name(name)) {
        throw http::Problem(http::bad_request,
                            "name has other characters than letters, digits, dots, dashes and underscores");
    }
    return {.file = name, .use = use_of(request), .width = width_of(request)};
}

// Read back, so that it equals an upload of the file that the command would write.
StoredMap overlaid(const StoredMap& map, Importer::Overlay read, const city::OverlaySource& source,
                   const MapLimits& limits) {
    const MemoryAccount::Scope none(nullptr);  // the limits count the map
    const io::MapFile things = mapfile::parse_map(std::move(read.tiff), source.file);
    if (things.map.obstacles().empty()) {
        throw http::Problem(http::unprocessable, fmt::format("{}: {}", source.file, fmt::join(read.notes, "; ")),
                            "unfit-request");
    }
    const site::Overlay overlay{.name = source.file.substr(0, source.file.find('.')),
                                .use = source.use,
                                .things = site::label_layer(things.map, things.annotations)};
    std::vector<std::string> notes = std::move(read.notes);
    if (std::string doubt = site::doubt(map.file.annotations, overlay); !doubt.empty()) {
        notes.push_back(std::move(doubt));
    }
    std::string bytes =
        mapfile::write_map(mapfile::with_overlay(map.file, overlay), "overlaid.tif").files.front().bytes;
    io::MapFile file = mapfile::parse_map(bytes, "the map", map.connectivity, {}, limits);
    file.notes = std::move(notes);
    return {.file = std::move(file), .connectivity = map.connectivity, .bytes = std::move(bytes)};
}

}  // namespace

Route overlay_route(const Importer& importer, MapStore& maps) {
    const auto handle = [&](Call call) -> Answer {
        const city::OverlaySource source = overlay_of(call.request);
        maps.if_loaded(call.id);  // throws now if there is no such map
        http::Work work = [&, source, id = call.id, data = std::move(call.request.body)](const http::Worker& worker) {
            const SharedMap map = maps.load(id);
            if (!map->file.georeference) {
                throw http::Problem(http::unprocessable,
                                    "the map does not say where on Earth it lies, so that nothing can be laid over it",
                                    "unfit-request");
            }
            Importer::Overlay read = importer.overlay(source, data, map->file, worker.stop);
            return upload_response(
                maps.add([&](const MapLimits& limits) { return overlaid(*map, std::move(read), source, limits); }));
        };
        return Deferred{.work = std::move(work), .lane = Lane::importing};
    };
    return {"POST", "/api/v1/maps/{id}/overlays", http::BodyType::bytes, false, handle};
}

}  // namespace waybreaker::service

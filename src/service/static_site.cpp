#include "service/static_site.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "http/problem.hpp"
#include "io/map_document.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/map_info.hpp"
#include "service/answers.hpp"
#include "service/map_store.hpp"
#include "studio/studio_files.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

// Tells the page that it plans by itself; and what it may do, as the service says in a header.
constexpr auto head =
    "<meta name=\"waybreaker-site\" content=\"maps.json\" />\n"
    "    <meta name=\"description\" content=\"Which obstacles should an aircraft remove so that a ground robot arrives "
    "sooner? Drag the start, and this page plans.\" />\n"
    "    <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self' "
    "'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; worker-src 'self'; base-uri "
    "'none'; form-action 'none'\" />\n  ";

SiteFile page() {
    std::string text(studio::site_page().front().bytes);
    text.insert(text.find("</head>"), head);
    return {"index.html", std::move(text)};
}

// The version is that of all that the page reads: another one, and browsers fetch everything anew.
SiteFile service_worker(const std::vector<SiteFile>& files) {
    nlohmann::ordered_json kept = nlohmann::ordered_json::array({"./"});
    std::string digests;
    for (const SiteFile& file : files) {
        digests += file.path + " " + mapfile::sha256_digest(file.bytes) + "\n";
        if (!file.path.starts_with("maps/") && file.path != "index.html") kept.push_back(file.path);
    }
    constexpr std::size_t scheme = 7;  // "sha256:"
    constexpr std::size_t digits = 16;
    const std::string version = mapfile::sha256_digest(digests).substr(scheme, digits);
    return {"service-worker.js", fmt::format("const version = \"{}\";\nconst files = {};\n\n{}", version, kept.dump(),
                                             studio::service_worker())};
}

SharedMap loaded(MapStore& store, const std::string& id) {
    try {
        return store.load(id);
    } catch (const http::Problem& problem) {
        throw InputError(fmt::format("{}: {}; take it out of the folder of maps", id, problem.what()));
    }
}

}  // namespace

std::vector<SiteFile> static_site(const std::string& maps, std::string_view wasm,
                                  const std::function<void(const std::string& map)>& begin) {
    const ServiceLimits limits;
    MemoryBudget budget(limits.memory);
    MapStore store(maps, limits, budget);
    const std::vector<MapStore::Entry> entries = store.list();
    std::vector<SiteFile> files{page()};
    for (const studio::File& file : studio::site_page().subspan(1)) {
        files.push_back({std::string(file.path.substr(1)), std::string(file.bytes)});
    }
    files.push_back({"studio.wasm", std::string(wasm)});
    files.push_back({"maps.json", maps_json(entries)});
    for (const MapStore::Entry& entry : entries) {
        if (begin) begin(entry.id);
        const SharedMap map = loaded(store, entry.id);
        const io::MapPlace place{.georeference = mapfile::georeference_json(map->file),
                                 .frame_crs = mapfile::frame_crs(map->file)};
        files.push_back(
            {"maps/" + entry.id + ".json", io::map_document(entry.id, {map->file, map->connectivity, place})});
        if (!map->bytes.empty()) files.push_back({"maps/" + entry.id, map->bytes});
    }
    files.push_back(service_worker(files));
    return files;
}

}  // namespace waybreaker::service

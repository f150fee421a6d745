#include "server/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "io/digest.hpp"
#include "server/gzip.hpp"
#include "server/header_list.hpp"
#include "server/problem.hpp"
#include "studio/studio_files.hpp"

namespace waybreaker::server {
namespace {

// Scripts, styles and pictures of this server alone; nothing is asked of others, and nobody frames it.
constexpr auto policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct Served {
    std::string type;
    std::string bytes;
    std::string packed;
    std::string tag;  // of both, so a weak one
};

Served served(const studio::File& file) {
    constexpr int smallest = 9;
    const std::string bytes(file.bytes);
    return {std::string(file.type), bytes, gzip(bytes, smallest), fmt::format("\"{}\"", io::sha256_digest(bytes))};
}

// Whether an If-None-Match header names the tag, strong or weak.
bool names(const std::string& header, const std::string& tag) {
    const std::vector<std::string> items = header_list(header);
    return std::any_of(items.begin(), items.end(),
                       [&](const std::string& item) { return item == "*" || item == tag || item == "w/" + tag; });
}

Response given(const std::shared_ptr<const Served>& file, const Fields& headers) {
    Response response;
    response.headers = {{"Content-Security-Policy", policy},
                        {"Cache-Control", "no-cache"},  // kept, but asked about each time
                        {"ETag", "W/" + file->tag},
                        {"Vary", "Accept-Encoding"}};
    if (names(headers.get("If-None-Match"), file->tag)) {
        response.status = not_modified;
        return response;
    }
    const bool packed = accepts_gzip(headers.get("Accept-Encoding"));
    if (packed) response.headers.add("Content-Encoding", "gzip");
    response.type = file->type;
    response.body = {file, packed ? file->packed : file->bytes};
    return response;
}

}  // namespace

std::vector<Route> page_routes() {
    std::vector<Route> routes;
    for (const studio::File& file : studio::files()) {
        const auto handle = [ready = std::make_shared<const Served>(served(file))](const Call& call) {
            return given(ready, call.request.headers);
        };
        routes.push_back({"GET", std::string(file.path), Route::Body::none, true, handle, true});
    }
    return routes;
}

}  // namespace waybreaker::server

#include "service/page.hpp"

#include <memory>

#include "http/entity_tag.hpp"
#include "http/gzip.hpp"
#include "http/problem.hpp"
#include "mapfile/digest.hpp"
#include "studio/studio_files.hpp"

namespace waybreaker::service {
namespace {

// Scripts, styles and images of this server only; no requests to others, no framing.
constexpr auto policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct Served {
    std::string type;
    std::string bytes;
    std::string packed;
    std::string tag;
};

Served served(const studio::File& file) {
    constexpr int smallest = 9;
    const std::string bytes(file.bytes);
    return {std::string(file.type), bytes, http::gzip(bytes, smallest),
            http::entity_tag(mapfile::sha256_digest(bytes))};
}

http::Response given(const std::shared_ptr<const Served>& file, const http::Fields& headers) {
    http::Response response;
    response.headers = {{"Content-Security-Policy", policy},
                        {"Cache-Control", "no-cache"},  // cached, but revalidated each time
                        {"ETag", file->tag},
                        {"Vary", "Accept-Encoding"}};
    if (http::has_already(headers, file->tag)) {
        response.status = http::not_modified;
        return response;
    }
    const bool packed = http::accepts_gzip(headers.get("Accept-Encoding"));
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
        routes.push_back({"GET", std::string(file.path), http::BodyType::none, true, handle, true});
    }
    return routes;
}

}  // namespace waybreaker::service

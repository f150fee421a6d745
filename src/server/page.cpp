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

void replace_header(httplib::Response& response, const char* name, const std::string& value) {
    response.headers.erase(name);
    response.set_header(name, value);
}

void give(const Served& file, const httplib::Request& request, httplib::Response& response) {
    replace_header(response, "Content-Security-Policy", policy);
    replace_header(response, "Cache-Control", "no-cache");  // kept, but asked about each time
    response.set_header("ETag", "W/" + file.tag);
    response.set_header("Vary", "Accept-Encoding");
    if (names(request.get_header_value("If-None-Match"), file.tag)) {
        response.status = not_modified;
        return;
    }
    const bool packed = accepts_gzip(request.get_header_value("Accept-Encoding"));
    if (packed) response.set_header("Content-Encoding", "gzip");
    response.status = ok;
    response.set_content(packed ? file.packed : file.bytes, file.type);
}

}  // namespace

std::vector<Route> page_routes() {
    std::vector<Route> routes;
    for (const studio::File& file : studio::files()) {
        const auto handle = [ready = std::make_shared<const Served>(served(file))](const Call& call,
                                                                                   httplib::Response& response) {
            give(*ready, call.request, response);
        };
        routes.push_back({"GET", std::string(file.path), Route::Body::none, true, handle});
    }
    return routes;
}

}  // namespace waybreaker::server

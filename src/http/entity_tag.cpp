#include "http/entity_tag.hpp"

#include <algorithm>

#include "http/header_list.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {

std::string entity_tag(const std::string& digest) {
    return "W/\"" + digest + "\"";
}

bool has_already(const Fields& headers, const std::string& tag) {
    const std::vector<std::string> items = header_list(headers.get("If-None-Match"));
    const std::string strong = tag.substr(2);
    // header_list() returns lower case.
    return std::any_of(items.begin(), items.end(),
                       [&](const std::string& item) { return item == "*" || item == strong || item == "w/" + strong; });
}

Response not_changed(const std::string& tag) {
    Response response{.status = not_modified};
    add_tag(response, tag);
    return response;
}

void add_tag(Response& response, const std::string& tag) {
    response.headers.set("ETag", tag);
    response.headers.set("Cache-Control", "private, no-cache");
}

}  // namespace waybreaker::http

#include "service/responses.hpp"

#include <utility>

#include "service/answers.hpp"

namespace waybreaker::service {

http::Response ok_response(http::Body body, const std::string& type) {
    return {.type = type, .body = std::move(body)};
}

http::Response kept_response(std::string body, const std::string& location, bool is_new) {
    http::Response response = ok_response(std::move(body));
    if (!is_new) return response;
    response.status = http::created;
    response.headers.add("Location", location);
    return response;
}

http::Response upload_response(const MapStore::Upload& added) {
    return kept_response(map_json(added.id, *added.map), "/api/v1/maps/" + added.id, added.is_new);
}

}  // namespace waybreaker::service

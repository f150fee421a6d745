#include "service/responses.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
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

std::size_t number_of(const http::Request& request, const std::string& name, std::size_t otherwise, std::size_t least,
                      std::size_t most) {
    const std::optional<std::string> text = request.query.find(name);
    if (!text) return otherwise;
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (error != std::errc() || end != text->data() + text->size() || value < least || value > most) {
        throw http::Problem(http::bad_request, fmt::format("{} is no number from {} to {}", name, least, most));
    }
    return value;
}

void require_size(const http::Request& request, const std::string& what) {
    constexpr std::size_t most = std::size_t{4} << 20;
    if (request.body.size() <= most) return;
    throw http::Problem(http::too_large, what + " has at most " + std::to_string(most) + " bytes");
}

}  // namespace waybreaker::service

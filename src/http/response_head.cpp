#include "http/response_head.hpp"

#include <fmt/chrono.h>

#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

// The current time in HTTP's format (RFC 9110, 5.6.7).
std::string date() {
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    return fmt::format("{:%a, %d %b %Y %H:%M:%S} GMT", fmt::gmtime(now));
}

}  // namespace

std::string response_head(const Response& response, const Delivery& delivery) {
    std::string head = fmt::format("HTTP/1.1 {} {}\r\n", response.status, title_of(response.status));
    const auto add = [&head](std::string_view name, std::string_view value) {
        head.append(name).append(": ").append(value).append("\r\n");
    };
    add("Date", date());
    for (const auto& [name, value] : response.headers) add(name, value);
    for (const auto& [name, value] : delivery.usual) {
        if (response.headers.count(name) == 0) add(name, value);
    }
    if (!response.type.empty()) add("Content-Type", response.type);
    if (delivery.length == Delivery::Length::chunks) add("Transfer-Encoding", "chunked");
    // Responses without a body have no length either (RFC 9110, 8.6).
    const bool has_body = response.status != no_content && response.status != not_modified;
    if (delivery.length == Delivery::Length::known && has_body) {
        add("Content-Length", std::to_string(response.body.bytes().size()));
    }
    if (delivery.last) {
        add("Connection", "close");
    } else {
        add("Keep-Alive", fmt::format("timeout={}", delivery.idle.count()));
    }
    return head + "\r\n";
}

}  // namespace waybreaker::http

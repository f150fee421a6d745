#include "http/problem.hpp"

#include <fmt/format.h>

#include <map>

namespace waybreaker::http {

Problem body_too_large(std::size_t most, std::string_view when) {
    constexpr unsigned megabyte = 20;  // binary digits
    const std::string size =
        most >> megabyte > 0 ? fmt::format("{} MB", most >> megabyte) : fmt::format("{} bytes", most);
    return {too_large,
            fmt::format("the body has more than {}{}, the most that this server takes (--max-upload)", size, when)};
}

std::string title_of(int status) {
    static const std::map<int, std::string> titles{{ok, "OK"},
                                                   {created, "Created"},
                                                   {no_content, "No Content"},
                                                   {not_modified, "Not Modified"},
                                                   {bad_request, "Bad Request"},
                                                   {unauthorized, "Unauthorized"},
                                                   {forbidden, "Forbidden"},
                                                   {not_found, "Not Found"},
                                                   {method_not_allowed, "Method Not Allowed"},
                                                   {conflict, "Conflict"},
                                                   {request_timeout, "Request Timeout"},
                                                   {target_too_long, "URI Too Long"},
                                                   {expectation_failed, "Expectation Failed"},
                                                   {head_too_large, "Request Header Fields Too Large"},
                                                   {version_unknown, "HTTP Version Not Supported"},
                                                   {too_large, "Content Too Large"},
                                                   {unsupported_type, "Unsupported Media Type"},
                                                   {misdirected, "Misdirected Request"},
                                                   {unprocessable, "Unprocessable Content"},
                                                   {client_gone, "Client Closed Request"},
                                                   {internal_error, "Internal Server Error"},
                                                   {not_implemented, "Not Implemented"},
                                                   {unavailable, "Service Unavailable"},
                                                   {insufficient_storage, "Insufficient Storage"}};
    const auto title = titles.find(status);
    return title == titles.end() ? "Error" : title->second;
}

}  // namespace waybreaker::http

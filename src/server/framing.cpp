#include "server/framing.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "server/header_list.hpp"

namespace waybreaker::server {
namespace {

bool is_token(std::string_view text) {
    constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               marks.find(c) != std::string_view::npos;
    });
}

bool is_count(std::string_view text) {
    constexpr std::size_t most_digits = 18;
    return !text.empty() && text.size() <= most_digits &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool says(const httplib::Request& request, const char* header, const std::string& word) {
    const auto range = request.headers.equal_range(header);
    return std::any_of(range.first, range.second, [&](const auto& line) {
        const std::vector<std::string> items = header_list(line.second);
        return std::find(items.begin(), items.end(), word) != items.end();
    });
}

}  // namespace

void check_framing(const httplib::Request& request) {
    const auto count = [&](const char* header) { return request.get_header_value_count(header); };
    const bool tokens = std::all_of(request.headers.begin(), request.headers.end(),
                                    [](const auto& line) { return is_token(line.first); });
    if (!tokens) throw Problem(bad_request, "a header has a name that is none");
    if (count("Host") > 1 || (count("Host") == 0 && request.version == "HTTP/1.1")) {
        throw Problem(bad_request, "a request has one Host header");
    }
    if (count("Content-Length") > 1 || count("Transfer-Encoding") > 1 ||
        (count("Content-Length") == 1 && count("Transfer-Encoding") == 1)) {
        throw Problem(bad_request, "the length of the body is said twice");
    }
    if (count("Content-Length") == 1 && !is_count(request.get_header_value("Content-Length"))) {
        throw Problem(bad_request, "Content-Length is not a number");
    }
    if (count("Transfer-Encoding") == 1 &&
        header_list(request.get_header_value("Transfer-Encoding")) != std::vector<std::string>{"chunked"}) {
        throw Problem(not_implemented, "the only Transfer-Encoding taken is chunked");
    }
}

std::uint64_t body_length(const httplib::Request& request) {
    const std::string text = request.get_header_value("Content-Length");
    std::uint64_t length = 0;
    std::from_chars(text.data(), text.data() + text.size(), length);
    return length;
}

bool may_be_followed(const httplib::Request& request) {
    try {
        check_framing(request);
    } catch (const Problem&) {
        return false;
    }
    return request.version == "HTTP/1.1" && !request.has_header("Transfer-Encoding") && !request.has_header("Expect") &&
           !says(request, "Connection", "close");
}

}  // namespace waybreaker::server

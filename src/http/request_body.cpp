#include "http/request_body.hpp"

#include <string>
#include <vector>

#include "http/gzip.hpp"
#include "http/header_list.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

bool is_gzip(const std::string& coding) {
    return coding == "gzip" || coding == "x-gzip";
}

std::vector<std::string> codings_of(const Request& request) {
    return header_list(request.headers.get("Content-Encoding"));
}

// Pages of other sites can send only a few media types without a CORS preflight; these are not accepted.
void require_type(const Request& head, const std::string& wanted) {
    const std::string given = head.headers.get("Content-Type");
    if (same_word(trimmed(std::string_view(given).substr(0, given.find(';'))), wanted)) return;
    throw Problem(unsupported_type, "the body must be sent as " + wanted);
}

}  // namespace

void require_body(const Request& head, std::optional<std::uint64_t> length, BodyType wanted, std::size_t most) {
    const std::string expected = head.headers.get("Expect");
    if (!expected.empty() && !same_word(expected, "100-continue")) {
        throw Problem(expectation_failed, "the only Expect taken is 100-continue");
    }
    if (wanted == BodyType::none) return;
    require_type(head, wanted == BodyType::json ? "application/json" : "application/octet-stream");
    const std::vector<std::string> codings = codings_of(head);
    if (codings.size() > 1 || (codings.size() == 1 && !is_gzip(codings[0]) && codings[0] != "identity")) {
        throw Problem(unsupported_type, "the only Content-Encoding taken is gzip");
    }
    if (length.value_or(0) > most) throw body_too_large(most);
}

void unpack(Request& request, std::size_t most) {
    const std::vector<std::string> codings = codings_of(request);
    if (!codings.empty() && is_gzip(codings[0])) request.body = gunzip(request.body, most);
}

}  // namespace waybreaker::http

// Problem: why a request fails, as a problem document (RFC 9457) says it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace waybreaker::http {

// HTTP status codes the server gives.
enum Status : int {
    ok = 200,
    created = 201,
    no_content = 204,
    not_modified = 304,
    bad_request = 400,
    unauthorized = 401,
    forbidden = 403,
    not_found = 404,
    method_not_allowed = 405,
    conflict = 409,
    request_timeout = 408,
    too_large = 413,
    target_too_long = 414,
    unsupported_type = 415,
    expectation_failed = 417,
    misdirected = 421,
    unprocessable = 422,
    head_too_large = 431,
    client_gone = 499,  // as other servers log it; never sent
    internal_error = 500,
    not_implemented = 501,
    unavailable = 503,
    version_unknown = 505,
    insufficient_storage = 507,
};

// Thrown by request handlers; what() is one line for a person.
class Problem : public std::runtime_error {
  public:
    // `kind` names it where the status does not say enough; who makes the response knows the kinds.
    Problem(Status status, const std::string& detail, std::string_view kind = "")
        : std::runtime_error(detail), status_(status), kind_(kind) {}
    Status status() const { return status_; }
    std::string_view kind() const { return kind_; }

  private:
    Status status_;
    std::string_view kind_;
};

// A body of more than `most` bytes, as people count them. `when`: " when it is unpacked".
Problem body_too_large(std::size_t most, std::string_view when = "");

// The name of a status, "Not Found".
std::string title_of(int status);

}  // namespace waybreaker::http

// Requests that a server must refuse, in the order of the standards that say so. Each is one request's bytes, up to
// where the fault shows, and the status of the response.
#pragma once

#include <string>
#include <vector>

namespace waybreaker::http {

struct Malformed {
    std::string why;
    std::string bytes;
    int status;
};

std::vector<Malformed> malformed_requests();

}  // namespace waybreaker::http

// Requests that no server should take, in the order of the standards that say so. Each is one request's bytes, up to
// where it can be seen to be wrong, and the status that it gets.
#pragma once

#include <string>
#include <vector>

namespace waybreaker::server {

struct Malformed {
    std::string why;
    std::string bytes;
    int status;
};

std::vector<Malformed> malformed_requests();

}  // namespace waybreaker::server

// Target: the address in the first line of a request (RFC 9112, 3.2; RFC 3986), and the names of hosts.
#pragma once

#include <string>
#include <string_view>

#include "server/message.hpp"

namespace waybreaker::server {

bool is_digit(char c);
bool is_letter_or_digit(char c);

// "localhost:8080", "[::1]", or nothing: a name and maybe a port, but no user.
bool is_host(std::string_view text);

// Throws Problem if a request with that method cannot have it.
void check_target(std::string_view method, std::string_view target);

struct Target {
    std::string host;  // of an address that names it: "http://localhost/maps"; it then holds instead of the Host header
    std::string path;  // decoded
    Fields query;      // decoded
};
// Precondition: it was checked.
Target target_of(std::string_view target);

}  // namespace waybreaker::server

// Target: the address in the first line of a request (RFC 9112, 3.2; RFC 3986), and the names of hosts.
#pragma once

#include <string>
#include <string_view>

#include "http/message.hpp"

namespace waybreaker::http {

bool is_digit(char c);
bool is_letter_or_digit(char c);

// "localhost:8080", "[::1]" or empty: a name and an optional port, but no user.
bool is_host(std::string_view text);

// Throws Problem if the target is not valid for that method.
void check_target(std::string_view method, std::string_view target);

struct Target {
    std::string host;  // of an absolute target ("http://localhost/maps"), which overrides the Host header
    std::string path;  // decoded
    Fields query;      // decoded
};
// Precondition: the target was checked.
Target target_of(std::string_view target);

}  // namespace waybreaker::http

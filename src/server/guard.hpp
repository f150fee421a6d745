// Guard: which requests are allowed. Pure functions of their headers.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::server {

// Whether an address is reachable from this machine only.
bool is_loopback(const std::string& address);

// Whether a Host header names this machine. A page of another site can make its own name resolve to this machine (DNS
// rebinding), but the browser still sends that name.
bool names_loopback(std::string_view host);

// Whether an Origin header is that of a page served by this host.
bool same_site(std::string_view origin, std::string_view host);

// Whether an Authorization header holds the token. Constant time.
bool brings_token(std::string_view authorization, std::string_view token);

}  // namespace waybreaker::server

// Guard: which requests are allowed. Pure functions of their headers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::http {

// Whether an address is reachable from this machine only.
bool is_loopback(const std::string& address);

// Whether a Host header names this machine. A page of another site can make its own name resolve to this machine (DNS
// rebinding), but the browser still sends that name.
bool names_loopback(std::string_view host);
// Whether it is one of these names, whatever its port.
bool names_one_of(std::string_view host, const std::vector<std::string>& names);
// Whether it is an address, which no page of another site has for its name.
bool is_address(std::string_view host);

// Whether a text can be the name of a host, without a port.
bool is_host_name(std::string_view name);
// Whether clients can send a text as a token.
bool is_bearer_token(std::string_view token);

// Whether an Origin header is that of a page served by this host.
bool same_site(std::string_view origin, std::string_view host);

// Whether an Authorization header holds the token. Constant time.
bool brings_token(std::string_view authorization, std::string_view token);

}  // namespace waybreaker::http

// Guard: who may ask. Pure functions of what a request says of itself.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::server {

// Whether only programs of this machine reach an address.
bool is_loopback(const std::string& address);

// Whether a Host header names this machine. A page of another site can make its own name lead here (DNS rebinding), but
// its browser still says that name.
bool names_loopback(std::string_view host);

// Whether an Origin header is that of a page that this host served.
bool same_site(std::string_view origin, std::string_view host);

// Whether an Authorization header brings the token. Takes as long whatever it holds.
bool brings_token(std::string_view authorization, std::string_view token);

}  // namespace waybreaker::server

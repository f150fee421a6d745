// Entity tags (RFC 9110, 8.8.3): a client that has the current response gets status 304 instead.
#pragma once

#include <string>

#include "http/message.hpp"

namespace waybreaker::http {

// The tag for a digest of what the response depends on. Weak, as the response may be compressed or not.
std::string entity_tag(const std::string& digest);

// Whether the request names the tag in If-None-Match.
bool has_already(const Fields& headers, const std::string& tag);

// The response to such a request.
Response not_changed(const std::string& tag);
// Lets a client cache the response, and revalidate it each time.
void add_tag(Response& response, const std::string& tag);

}  // namespace waybreaker::http

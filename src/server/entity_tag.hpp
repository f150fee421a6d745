// Entity tags (RFC 9110, 8.8.3): who has an answer already is told so, with status 304.
#pragma once

#include <string>

#include "server/message.hpp"

namespace waybreaker::server {

// Of an answer that is a given text's, or a file's of that digest: a weak one, as it may be packed or not.
std::string entity_tag(const std::string& digest);

// Whether the request names the tag in If-None-Match.
bool has_already(const Fields& headers, const std::string& tag);

// What is told then.
Response not_changed(const std::string& tag);
// Lets a client keep the response, and ask each time whether it still holds.
void add_tag(Response& response, const std::string& tag);

}  // namespace waybreaker::server

// Framing: where a request ends (RFC 9112, 6), told by its headers alone. httplib believes what they say first; who
// sends requests one after the other could hide one in another's body.
#pragma once

#include <httplib.h>

#include <cstdint>
#include <string>

#include "server/problem.hpp"

namespace waybreaker::server {

// Throws Problem if the headers contradict each other, or say what is not understood.
void check_framing(const httplib::Request& request);

// Bytes of the body, 0 if there is none or it comes in chunks. Precondition: the framing is sound.
std::uint64_t body_length(const httplib::Request& request);

// Whether another request may come on the same connection: the framing is sound, both sides are at HTTP/1.1, and
// nobody asks for its end. It also ends after chunks, for only httplib knows how many it has read, and where the body
// waits to be asked for (Expect), for it may never come.
bool may_be_followed(const httplib::Request& request);

}  // namespace waybreaker::server

// Request bodies: which media types, encodings and lengths are accepted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "http/message.hpp"

namespace waybreaker::http {

// What a request may bring.
enum class BodyType { none, json, bytes };

// Throws Problem if the body that the head announces is not acceptable. `length` is empty for a chunked body.
void require_body(const Request& head, std::optional<std::uint64_t> length, BodyType wanted, std::size_t most);

// Decompresses the body (RFC 9110, 8.4). Throws Problem if it is not what the head says.
void unpack(Request& request, std::size_t most);

}  // namespace waybreaker::http

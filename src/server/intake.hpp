// Intake: what bodies may come as.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "server/message.hpp"
#include "server/routes.hpp"

namespace waybreaker::server {

// Throws Problem if the body that a head announces is not to be taken. `length`: of it, unless it comes in chunks.
void require_body(const Request& head, std::optional<std::uint64_t> length, Route::Body wanted, std::size_t most);

// The body as it was before it was compressed (RFC 9110, 8.4). Throws Problem if it is not what the head says.
void unpack(Request& request, std::size_t most);

}  // namespace waybreaker::server

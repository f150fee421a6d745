// Server-sent events, in the format of the HTML standard.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::http {

// `data` may have several lines. `id`: what a client that comes again names as Last-Event-ID; empty: none.
std::string server_event(std::string_view name, std::string_view data, std::string_view id = "");
// What clients skip: shows that the other side is still there.
inline constexpr std::string_view empty_event = ":\n\n";

}  // namespace waybreaker::http

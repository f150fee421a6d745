// Server-sent events, in the format of the HTML standard.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::http {

// `data` may have several lines.
std::string server_event(std::string_view name, std::string_view data);

}  // namespace waybreaker::http

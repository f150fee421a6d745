// The page (src/studio) as routes. It holds no data and needs no token to be had; what it may do is said by a policy of
// its own.
#pragma once

#include <vector>

#include "server/routes.hpp"

namespace waybreaker::server {

std::vector<Route> page_routes();

}  // namespace waybreaker::server

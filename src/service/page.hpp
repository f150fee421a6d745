// The page (src/studio) as routes. It holds no data, so it needs no token; it has a security policy of its own.
#pragma once

#include <vector>

#include "service/route.hpp"

namespace waybreaker::service {

std::vector<Route> page_routes();

}  // namespace waybreaker::service

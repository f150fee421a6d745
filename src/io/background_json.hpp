// A map's background for programs that draw it: `GET /maps/{id}/background` of the service.
#pragma once

#include <string>

#include "site/background.hpp"

namespace waybreaker::io {

// {"features": [{"kind": "street", "class": "primary", "name": "Friedrichstraße", "shape": "line",
//                "points": [[[0.25, 17], [40, 17.5]], ...]}, ...]}
// In cell units with two decimals; a list of points for each line, ring or point, see site/background.hpp.
std::string background_json(const site::Background& background);

}  // namespace waybreaker::io

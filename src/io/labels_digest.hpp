// What stands for the digest of a file where a map comes from none: equal maps have equal digests.
#pragma once

#include <string>

#include "waybreaker/map.hpp"

namespace waybreaker::io {

// Of a map from labels (docs/c.md): cells, obstacles, and what is known of them.
std::string labels_digest(const Map& map);

}  // namespace waybreaker::io

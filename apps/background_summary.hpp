// What lies around a map's obstacles, in a few words.
#pragma once

#include <string>
#include <vector>

#include "site/background.hpp"

namespace waybreaker::apps {

// Such as "73 streets", "1 railway"; nothing of what there is none of.
std::vector<std::string> background_summary(const site::Background& background);

}  // namespace waybreaker::apps

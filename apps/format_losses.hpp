// What a map's format does not hold, told on standard error.
#pragma once

#include <string>
#include <vector>

namespace waybreaker::apps {

void tell_losses(const std::string& path, const std::vector<std::string>& losses);

}  // namespace waybreaker::apps

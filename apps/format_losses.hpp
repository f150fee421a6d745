// Reports on standard error what a map's format does not hold.
#pragma once

#include <string>
#include <vector>

namespace waybreaker::apps {

void report_losses(const std::string& path, const std::vector<std::string>& losses);

}  // namespace waybreaker::apps

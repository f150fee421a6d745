#include "format_losses.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace waybreaker::apps {

void report_losses(const std::string& path, const std::vector<std::string>& losses) {
    for (const std::string& loss : losses) {
        std::fputs(fmt::format("waybreaker: note: {}: {}\n", path, loss).c_str(), stderr);
    }
}

}  // namespace waybreaker::apps

#include "note.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace waybreaker::apps {

void note(const std::string& about, const std::string& text) {
    std::fputs(fmt::format("waybreaker: note: {}: {}\n", about, text).c_str(), stderr);
}

void warn(const std::string& text) {
    std::fputs(fmt::format("waybreaker: warning: {}\n", text).c_str(), stderr);
}

}  // namespace waybreaker::apps

// Version: what this program was built from.
#pragma once

#include <string>

namespace waybreaker::apps {

// "0.1.0+4f2c81d09ab3", the release and the commit; cmake/version.cmake says what of sources that differ from it, or
// know none.
std::string version();

}  // namespace waybreaker::apps

// Numbers as text.
#pragma once

#include <string>

namespace waybreaker::io {

// The shortest text that gives the same number back.
std::string shortest_text(double value);

}  // namespace waybreaker::io

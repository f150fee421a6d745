// What the user should know though nothing failed: a line on standard error beside the output.
#pragma once

#include <string>

namespace waybreaker::apps {

// `about` is the file that the note is about.
void note(const std::string& about, const std::string& text);

// That the result may not be what was meant.
void warn(const std::string& text);

}  // namespace waybreaker::apps

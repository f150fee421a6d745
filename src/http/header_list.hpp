// Headers whose value is a list (RFC 9110, 5.6.1): "gzip, br;q=0.5".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::http {

// Without surrounding blanks.
std::string_view trimmed(std::string_view text);

// Case-insensitive comparison.
bool same_word(std::string_view one, std::string_view other);

// Its items, in lower case.
std::vector<std::string> header_list(std::string_view value);

}  // namespace waybreaker::http

// Answers compressed with gzip, for clients that take it (RFC 9110, 12.5.3).
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::server {

// Whether an Accept-Encoding header takes gzip; one that is missing takes nothing.
bool accepts_gzip(std::string_view accept_encoding);

// `level`: 1 is quick, 9 is small. The same bytes give the same bytes.
std::string gzip(std::string_view bytes, int level);

// Throws Problem if that is not gzip, or has more bytes than `most` unpacked.
std::string gunzip(std::string_view packed, std::size_t most);

}  // namespace waybreaker::server

// Compression with gzip, for clients that accept it (RFC 9110, 12.5.3).
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::http {

// Whether an Accept-Encoding header accepts gzip; a missing one does not.
bool accepts_gzip(std::string_view accept_encoding);

// `level`: 1 (fastest) to 9 (smallest). Deterministic.
std::string gzip(std::string_view bytes, int level);

// Throws Problem if it is not gzip, or decompresses to more than `most` bytes.
std::string gunzip(std::string_view packed, std::size_t most);

}  // namespace waybreaker::http

// SHA-256 (FIPS 180-4) without a library, for programs that embed the documents. Map files, which can be large, are
// digested by OpenSSL (mapfile/digest.hpp), six times as fast.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::io {

// "sha256:<hex>", what `sha256sum` prints for the same bytes.
std::string sha256_digest(std::string_view bytes);

}  // namespace waybreaker::io

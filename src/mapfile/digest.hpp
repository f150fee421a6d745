// "sha256:<hex>", what `sha256sum` prints for the same bytes.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::mapfile {

std::string sha256_digest(std::string_view bytes);

}  // namespace waybreaker::mapfile

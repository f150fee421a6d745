// The map that every server has, with or without a folder: the bytes of data/berlin-mitte.tif (defined by the build).
#pragma once

#include <string_view>

namespace waybreaker::server {

inline constexpr std::string_view built_in_name = "berlin-mitte.tif";
std::string_view built_in_map();

}  // namespace waybreaker::server

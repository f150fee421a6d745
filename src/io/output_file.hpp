// Output files are written whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::io {

// Writes to a temporary neighbour and renames it over `path`; "-" is standard output. Throws InputError naming path and
// cause.
void write_whole(const std::string& path, std::string_view bytes);

// All bytes of a file. Throws InputError naming path and cause (a folder, no permission, over `limit` bytes).
std::string read_whole(const std::string& path, std::size_t limit = std::size_t{1} << 31);

}  // namespace waybreaker::io

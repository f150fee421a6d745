// Files are read whole and written whole or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace waybreaker::io {

// Writes to a temporary neighbour and renames it over `path`, so that no reader and no failure ever sees half a file;
// what a symbolic link points to is replaced, not the link. "-" is standard output; devices and pipes are written as
// they are. Throws InputError naming path and cause.
void write_whole(const std::string& path, std::string_view bytes);

// All bytes of a file. Throws InputError naming path and cause (a folder, no permission, over `limit` bytes).
std::string read_whole(const std::string& path, std::size_t limit = std::size_t{1} << 31);

}  // namespace waybreaker::io

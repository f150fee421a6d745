// Reads whole files, and writes them atomically.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace waybreaker::io {

// A file as it is to be written.
struct OutputFile {
    std::string path;  // "-" is standard output
    std::string bytes;
};

// Writes to a temporary neighbour and renames it over `path`, so that no reader and no failure ever sees half a file;
// what a symbolic link points to is replaced, not the link. "-" is standard output; devices and pipes are written as
// they are. Throws InputError naming path and cause.
void write_whole(const std::string& path, std::string_view bytes);

// Whether that means standard input: "-" does.
bool is_standard_input(const std::string& path);

// What errors call it.
std::string input_name(const std::string& path);

// Called with the first bytes, up to head_size, before the rest is read; throws InputError to reject the file.
using HeadCheck = std::function<void(std::string_view head)>;
inline constexpr std::size_t head_size = std::size_t{1} << 16;

// All bytes of a file, a pipe or a device; "-" is standard input. Throws InputError naming path and cause (a folder, no
// permission, over `limit` bytes).
std::string read_whole(const std::string& path, std::size_t limit = std::size_t{1} << 31,
                       const HeadCheck& check_head = {});

}  // namespace waybreaker::io

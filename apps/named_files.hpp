// Which option or argument names which file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/map_file.hpp"
#include "io/output_file.hpp"

namespace waybreaker::apps {

// Options and the files they name; empty where none is given.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

// Throws InputError if two of them are standard input.
void validate_inputs(const NamedFiles& inputs);

// Throws InputError if the name ends as files of a format do, and not in one of these: `import -o city.geojson`.
// Endings of no format are accepted. `remedy` tells how to make such a file all the same.
void require_ending(const std::string& option, const std::string& path, const std::vector<std::string_view>& endings,
                    const std::string& remedy = "");

// Throws InputError if one writes what is read.
void keep_inputs(const NamedFiles& outputs, const NamedFiles& inputs);

// What a map was read from: its file, and the image that a ROS map names.
NamedFiles files_of_map(const std::string& path, const io::MapFile& map);

// Writes each file whole. Throws InputError before the first if one was read.
void write_beside(const std::vector<io::OutputFile>& files, const NamedFiles& inputs);

// Throws InputError if two options write the same file, or one writes what is read, or a name ends as the files of
// another option do: `--svg plan.png`.
void validate_outputs(const NamedFiles& outputs, const NamedFiles& inputs);

}  // namespace waybreaker::apps

// Which option or argument names which file.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace waybreaker::apps {

// Options and the files they name; empty where none is given.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

// Throws InputError if two of them are standard input.
void validate_inputs(const NamedFiles& inputs);

// Throws InputError if one writes what is read.
void keep_inputs(const NamedFiles& outputs, const NamedFiles& inputs);

// Throws InputError if two options write the same file, or one writes what is read, or a name ends as the files of
// another option do: `--svg plan.png`.
void validate_outputs(const NamedFiles& outputs, const NamedFiles& inputs);

}  // namespace waybreaker::apps

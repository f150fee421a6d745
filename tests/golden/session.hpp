// Sessions: what one types at a shell and what comes back, byte for byte.
//
//     Prose is for the reader.
//     $ waybreaker plan wall.map --start 0,0 --goal 9,9
//     | a line of standard output
//     ! a line of standard error
//     = 2
//     $ for x in 1 2; do     # a command may go on
//     >     echo $x
//     > done
//
// The exit status stands there unless it is 0; a last line without newline ends in the mark "<no newline>".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace waybreaker::golden {

struct Step {
    std::string prose;    // before the command
    std::string command;  // for bash; may have several lines
    std::string result;   // lines with their marks
};

struct Session {
    std::vector<Step> steps;
    std::string epilogue;  // prose after the last step
};

Session read_session(const std::filesystem::path& file);
void write_session(const std::filesystem::path& file, const Session& session);

// Runs a step in `folder` with the folder of the tested command first in PATH; gives back the result it should have.
std::string run(const Step& step, const std::filesystem::path& folder, const std::filesystem::path& command_folder);

}  // namespace waybreaker::golden

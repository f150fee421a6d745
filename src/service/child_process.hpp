// Child process: another program, to which we say something, and which answers. It has no file of ours, and it ends
// when it has answered or a stop is asked for, whatever it does.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/limits.hpp"

namespace waybreaker::service {

struct ChildEnd {
    std::string said;  // on its standard output
    int status = 0;    // as waitpid has it; it may have been killed after it said all
    bool stopped = false;
};

// Starts the program with its arguments, writes `input` to its standard input and reads what it says until that ends;
// kills it at a stop, or when it says more than `most`. Throws std::runtime_error if it cannot be started.
ChildEnd run_child(const std::vector<std::string>& command, std::span<const std::string_view> input, std::size_t most,
                   const StopToken& stop);

}  // namespace waybreaker::service

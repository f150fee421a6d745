// The one exception of the library: the caller handed in something it can mend.
//
// "No path" and "no plan" are values, not errors; a broken invariant of ours asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace waybreaker {

// Bad input. what() is one line for a person: what is wrong, where (file and line, or the option), and the remedy.
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}

    // "FILE:LINE: message", the form editors can jump to. Lines count from 1; 0 means the file as a whole.
    InputError(const std::string& file, std::size_t line, const std::string& message)
        : std::runtime_error((line > 0 ? file + ":" + std::to_string(line) : file) + ": " + message) {}
};

// It is larger than it may be.
class SizeError : public InputError {
  public:
    using InputError::InputError;
};

}  // namespace waybreaker

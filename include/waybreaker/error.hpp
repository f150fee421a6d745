// Errors: the caller handed in something it can mend. As an exception, InputError, and as a value, Error.
//
// "No path" and "no plan" are values, not errors; a broken invariant of ours asserts.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "waybreaker/words.hpp"

namespace waybreaker {

enum class ErrorCode {
    other,
    out_of_range,      // a number; `subject` is what it is of
    off_map,           // a place; `subject` is the id of the agent, if it is one's
    no_room,           // an agent does not fit where it is to start or to end; `subject` is its id
    unknown_obstacle,  // `subject` is the id that no obstacle has
    contradiction,     // rules, options or agents that exclude each other
    too_large,         // a map, or the number of agents
    file,              // a file or document is not as it should be; `subject` is its name, and the line where known
    option,            // an option of a front end; `subject` is its name
};
template <>
inline constexpr std::array<std::string_view, 9> words_of<ErrorCode>{
    "other", "out_of_range", "off_map", "no_room", "unknown_obstacle", "contradiction", "too_large", "file", "option"};

// What is wrong, for a program (`code`, `subject`) and for a person: `detail` is one line that says what it is and what
// mends it. Of a file and of an option it does not name the subject, which front ends put before it in their own words.
struct Error {
    ErrorCode code = ErrorCode::other;
    std::string subject = {};  // may be empty
    std::string detail = {};
};

// Bad input. what() is one line for a person: what is wrong, where, and the remedy.
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& message) : InputError(ErrorCode::other, "", message) {}
    InputError(ErrorCode code, std::string subject, const std::string& message)
        : InputError(Error{code, std::move(subject), message}, message) {}

    // "FILE:LINE: message", the form editors can jump to. Lines count from 1; 0 means the file as a whole.
    InputError(const std::string& file, std::size_t line, const std::string& message)
        : InputError(ErrorCode::file, line > 0 ? file + ":" + std::to_string(line) : file, ": ", message) {}

    const Error& error() const { return error_; }

  protected:
    // what() is the subject, and the detail after it.
    InputError(ErrorCode code, const std::string& subject, const char* between, const std::string& detail)
        : InputError(Error{code, subject, detail}, subject + between + detail) {}

  private:
    InputError(Error error, const std::string& message) : std::runtime_error(message), error_(std::move(error)) {}

    Error error_;
};

// An option that front ends spell in their own ways: "wall-width" is --wall-width of the command. What was given for it
// begins the detail: "0.5: cells have 1 m".
class OptionError : public InputError {
  public:
    OptionError(const std::string& option, const std::string& detail)
        : InputError(ErrorCode::option, option, " ", detail) {}
};

// It is larger than it may be.
class SizeError : public InputError {
  public:
    explicit SizeError(const std::string& message) : InputError(ErrorCode::too_large, "", message) {}
    SizeError(const std::string& file, std::size_t line, const std::string& message)
        : InputError(ErrorCode::too_large, line > 0 ? file + ":" + std::to_string(line) : file, ": ", message) {}
};

}  // namespace waybreaker

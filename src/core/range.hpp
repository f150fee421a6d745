// Range checks for input, so that everything computed from it stays finite.
#pragma once

#include <sstream>
#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker {

// As people write it: "1e-320", not three hundred digits.
inline std::string number_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

// Throws InputError, "WHAT must be from 0 to 10, not nan", unless least <= value <= most.
inline void require_range(double value, double least, double most, const std::string& what) {
    if (value >= least && value <= most) return;
    throw InputError(
        ErrorCode::out_of_range, what,
        what + " must be from " + number_text(least) + " to " + number_text(most) + ", not " + number_text(value));
}

// The same of an enum, which a program can make of any number.
template <class Enum>
void require_enumerator(Enum value, Enum last, const std::string& what) {
    require_range(double(value), 0, double(last), what);
}

}  // namespace waybreaker

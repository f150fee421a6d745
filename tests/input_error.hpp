// Expected errors of bad input.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "waybreaker/error.hpp"

namespace waybreaker {

// The message of the InputError that `act` throws, which must be one line of printable characters; "" if it throws
// none.
template <class Act>
std::string input_error(Act act) {
    try {
        act();
    } catch (const InputError& error) {
        const std::string message = error.what();
        for (const char c : message) EXPECT_TRUE(c >= ' ' || c < 0) << "not one printable line: " << message;
        return message;
    }
    return "";
}

}  // namespace waybreaker

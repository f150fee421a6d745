// Failure: what a client learns of an exception, and what the log does.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::service {

struct Failure {
    int status;
    std::string detail;
    std::string cause = {};      // for the log, where the client must not see it
    std::string_view kind = {};  // of the problem; empty: the default of its status
};

// Of the exception being handled.
Failure current_failure();

}  // namespace waybreaker::service

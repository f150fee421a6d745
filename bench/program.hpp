// What the main() of every benchmark program does.
#pragma once

#include <cstdio>
#include <exception>

namespace waybreaker::bench {

// Runs it; what goes wrong becomes one line and exit status 1.
template <class Body>
int program(const char* name, Body body) {
    try {
        body();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
        return 1;
    }
}

}  // namespace waybreaker::bench

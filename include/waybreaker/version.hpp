// The version of these headers.
//
//     static_assert(WAYBREAKER_VERSION >= 200);  // 0.2.0 or later
#pragma once

#define WAYBREAKER_VERSION_MAJOR 0
#define WAYBREAKER_VERSION_MINOR 2
#define WAYBREAKER_VERSION_PATCH 0
#define WAYBREAKER_VERSION_STRING "0.2.0"

// Two digits each for minor and patch: 0.2.0 is 200, 1.12.3 is 11203.
#define WAYBREAKER_VERSION \
    (WAYBREAKER_VERSION_MAJOR * 10000 + WAYBREAKER_VERSION_MINOR * 100 + WAYBREAKER_VERSION_PATCH)

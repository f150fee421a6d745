// What one client, or all of them, may ask of the server.
#pragma once

#include <cstddef>

namespace waybreaker::server {

// A quarter of the machine's memory.
std::size_t default_memory();

struct ServiceLimits {
    std::size_t upload_bytes = std::size_t{32} << 20;  // of a request's body
    std::size_t map_cells = std::size_t{4096} * 4096;  // of an uploaded map
    std::size_t maps = 32;                             // held in memory
    std::size_t memory = default_memory();             // bytes that maps may take, all together
    double seconds = 30;                               // of one plan
    double patience = 10;                   // seconds for a request to come whole, and for an answer to be taken
    double idle = 30;                       // seconds that a connection may be without a request
    unsigned workers = 2;                   // plans at a time
    std::size_t queue = 16;                 // plans that wait
    std::size_t connections = 256;          // at a time; of more, those that ask nothing or dawdle are closed
    std::size_t connections_of_client = 0;  // 0: half of them, but all for clients of this machine
};

}  // namespace waybreaker::server

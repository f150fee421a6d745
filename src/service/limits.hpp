// Limits on what clients may use.
#pragma once

#include <cstddef>

namespace waybreaker::service {

// Half of the machine's memory.
std::size_t default_memory();

struct ServiceLimits {
    std::size_t upload_bytes = std::size_t{32} << 20;  // of a request's body
    std::size_t map_cells = std::size_t{4096} * 4096;  // of an uploaded map
    std::size_t maps = 32;                             // held in memory
    std::size_t memory = default_memory();             // bytes of all that is at work or kept
    std::size_t live_missions = 100;                   // at a time
    double seconds = 30;                               // of one plan
    double timeout = 10;                    // seconds for a request to arrive, and for a response to be taken
    double idle = 30;                       // seconds a connection may be idle
    unsigned workers = 2;                   // plans at a time
    std::size_t queue = 16;                 // waiting plans; and waiting uploads, waiting imports
    std::size_t connections = 256;          // at a time; beyond that, idle and slow ones are closed
    std::size_t connections_of_client = 0;  // 0: half of `connections`, all for clients on this machine
};

}  // namespace waybreaker::service

// Reach: by when each cell is reached from hubs, such as hospitals, before the openings of a plan and with them.
#pragma once

#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker {

struct Reach {
    bool inbound = false;  // agents drive from the cell to a hub
    std::vector<Cell> hubs = {};
    // By cell, row by row: when an agent gets there, or from there to a hub, that sets out when it is ready; in units
    // of time, waits for openings included; infinity where there is no way.
    std::vector<float> before = {};
    std::vector<float> after = {};
};

}  // namespace waybreaker

// Cells side by side in a row.
#pragma once

#include "waybreaker/cell.hpp"

namespace waybreaker::site {

struct CellRun {
    Cell first;
    int length = 1;
    friend bool operator==(const CellRun&, const CellRun&) = default;
};

}  // namespace waybreaker::site

// The ground of a window: what bars or opens the way there beside the buildings.
#pragma once

#include <ogr_geometry.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "city/ground_rules.hpp"

namespace waybreaker::city {

struct GroundPiece {
    GroundUse use;
    std::unique_ptr<OGRGeometry> shape;  // in the window's system, not clipped; an area, or the middle line of a way
    std::int64_t source_id = 0;
    std::string name = {};
    bool destructible = false;           // of a barrier, as the user wants it
    bool sheltered = false;              // of a barrier: not destructible because of what it is, though nobody said so
    std::vector<std::string> tags = {};  // of a barrier, those that maps keep
};

// Whether it blocks, for ever.
bool bars(const GroundUse& use);

struct Ground {
    std::vector<GroundPiece> pieces;      // in the source's order
    std::vector<std::string> notes = {};  // what the user should know of them, a line each
};

// Makes strips of lines other than ways, sides of bridges, discs of what stands in ways, the sea of coastlines
// (`coasts`, water to the right of them, within `bounds`), and leaves out the lines of rivers where areas show them,
// and ways on closed ground. Strips that block have at least the width of a cell, so that no disc slips through them.
Ground finished(Ground ground, std::vector<GroundPiece> coasts, const OGREnvelope& bounds, double cell);

}  // namespace waybreaker::city

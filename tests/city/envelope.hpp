// An envelope by its sides.
#pragma once

#include <ogr_core.h>

namespace waybreaker::city {

inline OGREnvelope envelope(double west, double south, double east, double north) {
    OGREnvelope bounds;
    bounds.MinX = west;
    bounds.MinY = south;
    bounds.MaxX = east;
    bounds.MaxY = north;
    return bounds;
}

}  // namespace waybreaker::city

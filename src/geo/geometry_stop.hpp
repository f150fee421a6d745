// Lets a stop end GEOS's work, which can take hours on a single shape that crosses itself often.
#pragma once

#include "waybreaker/limits.hpp"

namespace waybreaker::geo {

// As long as it lives, a stop makes GEOS give up what it does on this thread, and what it is asked after: GDAL then
// returns no geometry. Whoever asked must check the stop before the result is used. Only one thread at a time may have
// one: GEOS keeps the request for all threads.
class GeometryStop {
  public:
    explicit GeometryStop(const StopToken& stop);
    ~GeometryStop();
    GeometryStop(const GeometryStop&) = delete;
    GeometryStop& operator=(const GeometryStop&) = delete;
};

}  // namespace waybreaker::geo

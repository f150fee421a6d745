#include "geo/geometry_stop.hpp"

#include <geos_c.h>

#include <mutex>

namespace waybreaker::geo {
namespace {

thread_local const StopToken* stop_of_thread = nullptr;

// GEOS calls it now and then, on the thread that works.
void look() {
    if (stop_of_thread != nullptr && stop_of_thread->stop_requested()) GEOS_interruptRequest();
}

}  // namespace

GeometryStop::GeometryStop(const StopToken& stop) {
    static std::once_flag registered;
    std::call_once(registered, [] { GEOS_interruptRegisterCallback(look); });
    stop_of_thread = &stop;
}

GeometryStop::~GeometryStop() {
    stop_of_thread = nullptr;
    GEOS_interruptCancel();
}

}  // namespace waybreaker::geo

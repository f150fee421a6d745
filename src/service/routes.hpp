// Routes of maps and plans, and of what describes the service.
#pragma once

#include <vector>

#include "service/limits.hpp"
#include "service/map_store.hpp"
#include "service/planner_pool.hpp"
#include "service/route.hpp"

namespace waybreaker::service {

// The handlers keep the references.
std::vector<Route> routes(MapStore& store, PlannerPool& planners, const ServiceLimits& limits);

}  // namespace waybreaker::service

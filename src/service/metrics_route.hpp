// The route of the metrics.
#pragma once

#include "service/executor.hpp"
#include "service/live_missions.hpp"
#include "service/map_store.hpp"
#include "service/memory_budget.hpp"
#include "service/metrics.hpp"
#include "service/route.hpp"

namespace waybreaker::service {

// The handler keeps the references.
Route metrics_route(const Metrics& metrics, const MapStore& store, const Executor& executor,
                    const LiveMissions& missions, const MemoryBudget& budget);

}  // namespace waybreaker::service

// The route of the metrics.
#pragma once

#include "server/executor.hpp"
#include "server/map_store.hpp"
#include "server/memory_budget.hpp"
#include "server/metrics.hpp"
#include "server/routes.hpp"

namespace waybreaker::server {

// The handler keeps the references.
Route metrics_route(const Metrics& metrics, const MapStore& store, const Executor& executor,
                    const MemoryBudget& budget);

}  // namespace waybreaker::server

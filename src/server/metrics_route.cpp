#include "server/metrics_route.hpp"

#include <algorithm>

#include "server/responses.hpp"

namespace waybreaker::server {

Route metrics_route(const Metrics& metrics, const MapStore& store, const Executor& executor,
                    const MemoryBudget& budget) {
    const auto handle = [&](const Call&) -> Answer {
        using Use = MemoryBudget::Use;
        const auto lane = [&executor](Lane lane) {
            return Metrics::Lane{executor.queue(lane).waiting(), executor.queue(lane).running()};
        };
        const auto maps = store.list();
        const auto loaded = std::count_if(maps.begin(), maps.end(), [](const auto& entry) { return entry.loaded; });
        Metrics::Gauges gauges{.plans = lane(Lane::plans),
                               .uploads = lane(Lane::uploads),
                               .imports = lane(Lane::imports),
                               .maps = std::size_t(loaded),
                               .map_bytes = budget.used(Use::maps) + budget.used(Use::sources),
                               .most_memory = budget.most()};
        for (const auto& [name, use] : {std::pair("maps", Use::maps), std::pair("sources", Use::sources),
                                        std::pair("planners", Use::planners), std::pair("jobs", Use::jobs),
                                        std::pair("imports", Use::imports), std::pair("requests", Use::requests),
                                        std::pair("answers", Use::answers)}) {
            gauges.memory.emplace_back(name, budget.used(use));
        }
        return ok_response(metrics.text(gauges), "text/plain; version=0.0.4; charset=utf-8");
    };
    return {"GET", "/metrics", Route::Body::none, false, handle};
}

}  // namespace waybreaker::server

#include "service/metrics_route.hpp"

#include "service/responses.hpp"

namespace waybreaker::service {

Route metrics_route(const Metrics& metrics, const MapStore& store, const Executor& executor,
                    const LiveMissions& missions, const MemoryBudget& budget) {
    const auto handle = [&](const Call&) -> Answer {
        using Use = MemoryBudget::Use;
        const auto lane = [&executor](Lane which) {
            return Metrics::Lane{executor.queue(which).waiting(), executor.queue(which).running()};
        };
        Metrics::Gauges gauges{.plans = lane(Lane::planning),
                               .uploads = lane(Lane::uploading),
                               .imports = lane(Lane::importing),
                               .refused = executor.refused(),
                               .maps = store.loaded(),
                               .missions = missions.figures(),
                               .map_bytes = budget.used(Use::map) + budget.used(Use::source),
                               .most_memory = budget.most()};
        for (const auto& [name, use] :
             {std::pair("maps", Use::map), std::pair("sources", Use::source), std::pair("planners", Use::planner),
              std::pair("jobs", Use::job), std::pair("imports", Use::importer), std::pair("requests", Use::request),
              std::pair("answers", Use::answer), std::pair("missions", Use::mission)}) {
            gauges.memory.emplace_back(name, budget.used(use));
        }
        return ok_response(metrics.text(gauges), "text/plain; version=0.0.4; charset=utf-8");
    };
    return {"GET", "/metrics", http::BodyType::none, false, handle};
}

}  // namespace waybreaker::service

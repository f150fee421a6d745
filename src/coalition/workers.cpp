#include "coalition/workers.hpp"

#include <algorithm>

namespace waybreaker::coalition {

Workers::Workers(const Problem& problem, CrossingSearcher& crossing, Searcher& theta)
    : problem_(problem), most_(thread_count(problem.interrupts().threads)), crossing_(crossing), theta_(theta) {}

Worker& Workers::own() {
    gather(1);
    return all_.front();
}

void Workers::gather(std::size_t count) {
    const auto openings = [this] {
        return EarliestOpenings(problem_.map(), problem_.rules(),
                                {problem_.aircraft().begin(), problem_.aircraft().end()});
    };
    if (all_.empty()) all_.push_back({crossing_, crossing::Access::another(crossing_), theta_, openings()});
    while (all_.size() < std::min(most_, count)) {
        CrossingSearcher& crossing = crossings_.emplace_back(crossing::Access::another(crossing_));
        all_.push_back({crossing, crossing::Access::another(all_.front().limits), thetas_.emplace_back(), openings()});
    }
}

}  // namespace waybreaker::coalition

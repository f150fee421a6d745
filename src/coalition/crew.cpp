#include "coalition/crew.hpp"

#include <algorithm>

namespace waybreaker::coalition {

Crew::Crew(const Problem& problem, CrossingSearcher& crossing, Searcher& theta)
    : problem_(problem), most_(thread_count(problem.interrupts().threads)), crossing_(crossing), theta_(theta) {}

Hand& Crew::own() {
    gather(1);
    return hands_.front();
}

void Crew::gather(std::size_t count) {
    const auto openings = [this] {
        return EarliestOpenings(problem_.map(), problem_.rules(),
                                {problem_.aircraft().begin(), problem_.aircraft().end()});
    };
    if (hands_.empty()) hands_.push_back({crossing_, crossing_.another(), theta_, openings()});
    while (hands_.size() < std::min(most_, count)) {
        CrossingSearcher& crossing = crossings_.emplace_back(crossing_.another());
        hands_.push_back({crossing, hands_.front().limits.another(), thetas_.emplace_back(), openings()});
    }
}

}  // namespace waybreaker::coalition

// CrossingSearcher::enumerate against the oracle: every set that no smaller one beats, in order of cost, no other.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "crossing_case.hpp"

namespace waybreaker {
namespace {

// Shortest lengths and least costs by set, and which sets are beaten by a set within them.
struct Front {
    slow::CrossingOracle oracle;
    std::map<slow::Set, double> length;
    std::map<slow::Set, double> cost;

    explicit Front(const CrossingCase& problem) : oracle(problem.oracle()) {
        for (const slow::Set set : problem.choices()) {
            length[set] = oracle.shortest(set | slow::set_of(problem.removed));
            cost[set] = problem.cost(length[set], set);
        }
    }

    double best_within(slow::Set set) const {
        double best = slow::CrossingOracle::nowhere;
        for (const auto& [other, other_cost] : cost) {
            if (other != set && (other & set) == other) best = std::min(best, other_cost);
        }
        return best;
    }
    // Sums of roots differ in the last digit: a set as dear as one within it may be told of or not.
    bool must_be_told(slow::Set set) const {
        return cost.at(set) < best_within(set) && !same_length(cost.at(set), best_within(set));
    }
    bool may_be_told(slow::Set set) const {
        return cost.at(set) < slow::CrossingOracle::nowhere &&
               (cost.at(set) < best_within(set) || same_length(cost.at(set), best_within(set)));
    }
};

RC_GTEST_PROP(Enumerate, TellsOfEverySetThatIsNotBeaten, ()) {
    const CrossingCase problem = *number(0, 1) == 0 ? *any_case(8) : *any_walls();
    const Front front(problem);
    std::vector<CrossingPath> told;
    const CrossingResult result = CrossingSearcher().enumerate(problem.map, problem.start, problem.goal,
                                                               problem.options(), [&](const CrossingPath& path) {
                                                                   told.push_back(path);
                                                                   return true;
                                                               });
    RC_LOG() << problem;
    for (const CrossingPath& path : told) {
        RC_LOG() << path.cost << ", set " << slow::set_of(path.crossed) << '\n';
    }
    std::map<slow::Set, int> times;
    double last = 0;
    for (const CrossingPath& path : told) {
        const slow::Set set = slow::set_of(path.crossed);
        RC_ASSERT(path_fault(problem, front.oracle, path) == "");
        RC_ASSERT(++times[set] == 1);
        RC_ASSERT(same_length(path.length, front.length.at(set)));
        RC_ASSERT(front.may_be_told(set));
        RC_ASSERT(path.cost >= last * (1 - 1e-12));
        last = path.cost;
    }
    for (const auto& [set, cost] : front.cost) RC_ASSERT(!front.must_be_told(set) || times[set] == 1);
    RC_ASSERT((result.status == SearchStatus::found) == !told.empty());
    if (!told.empty()) RC_ASSERT(result.best.path == told.front().path);
}

RC_GTEST_PROP(Enumerate, BoundsWhatItHasNotTold, ()) {
    const CrossingCase problem = *number(0, 1) == 0 ? *any_case(8) : *any_walls();
    const Front front(problem);
    const std::size_t most = std::size_t(*number(1, 3));
    std::vector<slow::Set> told;
    const CrossingResult result = CrossingSearcher().enumerate(problem.map, problem.start, problem.goal,
                                                               problem.options(), [&](const CrossingPath& path) {
                                                                   told.push_back(slow::set_of(path.crossed));
                                                                   return told.size() < most;
                                                               });
    RC_LOG() << problem << "told of " << told.size() << ", bound " << result.lower_bound << '\n';
    RC_ASSERT(told.size() <= most);
    for (const auto& [set, cost] : front.cost) {
        const bool is_told = std::find(told.begin(), told.end(), set) != told.end();
        if (front.must_be_told(set) && !is_told) RC_ASSERT(cost >= result.lower_bound * (1 - 1e-9));
    }
    for (const slow::Set set : told) RC_ASSERT(front.cost.at(set) <= result.lower_bound * (1 + 1e-9));
}

}  // namespace
}  // namespace waybreaker

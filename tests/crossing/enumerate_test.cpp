// CrossingSearcher::enumerate against the oracle: every set that no smaller one beats, in order of cost, no other.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "ascii_map.hpp"
#include "crossing_case.hpp"

namespace waybreaker {
namespace {

// Shortest lengths and least costs by set, and which sets are beaten by a set within them, what is paid aside.
struct Front {
    slow::CrossingOracle oracle;
    std::map<slow::Set, double> length;
    std::map<slow::Set, double> cost;
    std::map<slow::Set, double> unpaid;

    explicit Front(const CrossingCase& problem) : oracle(problem.oracle()) {
        for (const slow::Set set : problem.choices()) {
            length[set] = oracle.shortest(set | slow::set_of(problem.removed));
            cost[set] = problem.cost(length[set], set);
            unpaid[set] = problem.unpaid(length[set], set);
        }
    }

    double best_within(slow::Set set) const {
        double best = slow::CrossingOracle::nowhere;
        for (const auto& [other, other_cost] : unpaid) {
            if (other != set && (other & set) == other) best = std::min(best, other_cost);
        }
        return best;
    }
    // Sums of roots differ in the last digit: a set as dear as one within it may be told of or not.
    bool must_be_told(slow::Set set) const {
        return unpaid.at(set) < best_within(set) && !same_length(unpaid.at(set), best_within(set));
    }
    bool may_be_told(slow::Set set) const {
        return unpaid.at(set) < slow::CrossingOracle::nowhere &&
               (unpaid.at(set) < best_within(set) || same_length(unpaid.at(set), best_within(set)));
    }
};

// What is wrong with what enumerate() tells, or nothing.
std::string enumeration_fault(const CrossingCase& problem) {
    const Front front(problem);
    std::vector<CrossingPath> told;
    const CrossingResult result = problem.enumerate(problem.options(), [&](const CrossingPath& path) {
        told.push_back(path);
        return true;
    });
    std::map<slow::Set, int> times;
    double last = 0;
    for (const CrossingPath& path : told) {
        const slow::Set set = slow::set_of(path.crossed);
        const std::string which = " (set " + std::to_string(set) + ", cost " + std::to_string(path.cost) + ")";
        const std::string fault = path_fault(problem, front.oracle, path);
        if (!fault.empty()) return fault + which;
        if (++times[set] > 1) return "told twice" + which;
        // Where what it waits for decides the cost, a longer path will do.
        if (!same_length(path.cost, front.cost.at(set))) return "another cost" + which;
        if (!front.may_be_told(set)) return "beaten by one within it" + which;
        if (path.cost < last * (1 - 1e-12)) return "out of order" + which;
        last = path.cost;
    }
    for (const auto& [set, cost] : front.cost) {
        if (front.must_be_told(set) && times[set] != 1) return "not told of set " + std::to_string(set);
    }
    if ((result.status == SearchStatus::found) == told.empty()) return "another status";
    if (!told.empty() && result.best.path != told.front().path) return "the best is not the first";
    return "";
}

RC_GTEST_PROP(Enumerate, TellsOfEverySetThatIsNotBeaten, ()) {
    const CrossingCase problem = *number(0, 1) == 0 ? *any_case(8) : *any_walls();
    RC_LOG() << problem;
    RC_ASSERT(enumeration_fault(problem) == "");
}

// A point that squeezes between two obstacles can meet further parts of them on the way.
TEST(Enumerate, TellsOfSetsBehindSqueezes) {
    for (const std::string_view picture : {
             ".... .ce. SegG",
             ".G.. .eb. bbc. S...",
             "....G .ecdd .aeS. .....",
             "..... .egg. Sg.bG",
             ".......G ........ ......a. .....ea. ....aaa. ........ eee..... S.......",
         }) {
        const Map map = map_from_ascii(picture);
        const CrossingCase problem{map, mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), point_body, 1};
        EXPECT_EQ(enumeration_fault(problem), "") << picture;
    }
}

RC_GTEST_PROP(Enumerate, BoundsWhatItHasNotTold, ()) {
    const CrossingCase problem = *number(0, 1) == 0 ? *any_case(8) : *any_walls();
    const Front front(problem);
    const std::size_t most = std::size_t(*number(1, 3));
    std::vector<slow::Set> told;
    const CrossingResult result = problem.enumerate(problem.options(), [&](const CrossingPath& path) {
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

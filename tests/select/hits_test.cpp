// The paper's choice against a full sort.
#include "select/hits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace waybreaker {
namespace {

RC_GTEST_PROP(MostHit, IsTheHeadOfASort, ()) {
    // Obstacles of one cell each, every other cell of a row; some cannot be removed.
    const auto hits_and_strength = *rc::gen::container<std::vector<std::pair<int, bool>>>(
        rc::gen::pair(rc::gen::inRange(0, 6), rc::gen::arbitrary<bool>()));
    const int n = *rc::gen::inRange(-1, 8);
    RC_PRE(!hits_and_strength.empty());
    std::vector<std::uint32_t> labels;
    std::vector<ObstacleAttributes> attributes(1);
    std::vector<std::uint32_t> hits{7'000};  // of free cells: nobody's
    std::vector<std::tuple<int, std::uint32_t>> ranking;
    for (const auto& [count, destructible] : hits_and_strength) {
        const auto id = std::uint32_t(hits.size());
        labels.insert(labels.end(), {id, 0});
        attributes.push_back({.destructible = destructible});
        hits.push_back(std::uint32_t(count));
        if (count > 0 && destructible) ranking.emplace_back(-count, id);
    }
    const Map map = Map::from_labels(int(labels.size()), 1, labels, attributes);
    std::sort(ranking.begin(), ranking.end());
    ranking.resize(std::min(ranking.size(), std::size_t(std::max(n, 0))));
    std::vector<ObstacleId> expected;
    for (const auto& [count, id] : ranking) expected.push_back({id});
    RC_ASSERT(most_hit(map, hits, n) == expected);
}

}  // namespace
}  // namespace waybreaker

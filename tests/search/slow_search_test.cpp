// Every planner against the slow, obvious search: same path, same figures, same hits.
#include "slow_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "random_map.hpp"

namespace waybreaker {
namespace {

std::string text(const std::vector<Cell>& path) {
    std::ostringstream words;
    for (const Cell c : path) words << ' ' << c.x << ',' << c.y;
    return words.str();
}

void check_same(const PlainMap& closed, int most_removed, const SearchOptions& options) {
    const Map map(closed.grid());
    const std::vector<ObstacleId> removed = some_obstacles(map, most_removed);
    const PlainMap open = plain(map, removed);
    const OpenedMap opened(map, removed);
    Searcher searcher;
    for (int i = 0; i < 4; ++i) {
        const Cell start = any_free_cell(open);
        const Cell goal = any_free_cell(open);
        SearchOptions counting = options;
        counting.count_hits = true;
        const SearchResult fast = searcher.find(opened, start, goal, counting);
        const SearchResult slow = slow::Search(opened, open, start, goal, options).result;
        RC_LOG() << "fast:" << text(fast.path) << " expanded " << fast.expanded << '\n'
                 << "slow:" << text(slow.path) << " expanded " << slow.expanded << '\n';
        RC_ASSERT(fast.status == slow.status);
        RC_ASSERT(fast.path == slow.path);
        RC_ASSERT(fast.length == slow.length);
        RC_ASSERT(fast.expanded == slow.expanded);
        RC_ASSERT(fast.generated == slow.generated);
        RC_ASSERT(fast.hits == slow.hits);
    }
}

RC_GTEST_PROP(SlowSearch, AgreesWithThetaOfTheUnitDisc, ()) {
    check_same(*random_map(40, 30), 4, {.weight = *rc::gen::element(1.0, 1.0, 1.3, 2.0)});
}

RC_GTEST_PROP(SlowSearch, AgreesWithThetaOfAnyMotion, ()) {
    check_same(*random_map(24, 18), 3,
               {.weight = *rc::gen::element(1.0, 2.0),
                .tie_break = *rc::gen::element(TieBreak::g_max, TieBreak::g_min),
                .diagonal = mostly(),
                .body = any_body()});
}

RC_GTEST_PROP(SlowSearch, AgreesWithWideAgents, ()) {
    const Algorithm planner =
        *rc::gen::element(Algorithm::theta, Algorithm::astar, Algorithm::dijkstra, Algorithm::bfs);
    check_same(*random_map(24, 18), 3,
               {.planner = planner, .body = {.radius = *rc::gen::element(0.501, 0.8, 1.3, 2.0)}});
}

RC_GTEST_PROP(SlowSearch, AgreesWithLazyTheta, ()) {
    check_same(*random_map(30, 24), 3,
               {.planner = Algorithm::lazy_theta,
                .weight = *rc::gen::element(1.0, 1.5),
                .diagonal = mostly(),
                .body = any_body()});
}

RC_GTEST_PROP(SlowSearch, AgreesWithGridPlanners, ()) {
    check_same(*random_map(24, 18), 3,
               {.planner = *rc::gen::element(Algorithm::astar, Algorithm::dijkstra, Algorithm::bfs),
                .heuristic = *rc::gen::element<std::optional<Heuristic>>(std::nullopt, Heuristic::euclidean,
                                                                         Heuristic::chebyshev, Heuristic::zero),
                .weight = *rc::gen::element(1.0, 1.5),
                .tie_break = *rc::gen::element(TieBreak::g_max, TieBreak::g_min),
                .diagonal = mostly(),
                .body = any_body()});
}

}  // namespace
}  // namespace waybreaker

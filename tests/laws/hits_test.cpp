// What hits mean: an obstacle without a hit was in no search's way, so removing it changes nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_map.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {
namespace {

// For planners that only expand a cell's neighbours.
RC_GTEST_PROP(Hits, ZeroMeansThatRemovalChangesNothing, ()) {
    const PlainMap plain = *random_map(24, 24);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    const SearchOptions options{.planner = *rc::gen::element(Algorithm::astar, Algorithm::dijkstra, Algorithm::bfs),
                                .diagonal = mostly(),
                                .body = any_body(),
                                .count_hits = true};
    Searcher searcher;
    const SearchResult before = searcher.find(OpenedMap(map), start, goal, options);
    std::vector<ObstacleId> unhit;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (before.hits[obstacle.id.value] == 0) unhit.push_back(obstacle.id);
    }
    const SearchResult after = searcher.find(OpenedMap(map, unhit), start, goal, options);
    RC_ASSERT(before.status == after.status);
    RC_ASSERT(before.path == after.path);
    RC_ASSERT(before.expanded == after.expanded);
    RC_ASSERT(before.generated == after.generated);
    RC_ASSERT(before.hits == after.hits);
}

// If there is no way, every wall around the reachable cells was hit: some removal always helps, were it all of them.
RC_GTEST_PROP(Hits, NameEveryWallOfAPrison, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    const SearchOptions options{.planner = *rc::gen::element(Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar),
                                .count_hits = true};
    const SearchResult before = Searcher().find(OpenedMap(map), start, goal, options);
    if (before.status == SearchStatus::found) return;
    std::uint64_t hits = 0;
    for (std::size_t id = 1; id < before.hits.size(); ++id) hits += before.hits[id];
    RC_ASSERT(hits > 0);
    RC_ASSERT(before.hits[0] == 0U);  // free cells are no obstacle
}

}  // namespace
}  // namespace waybreaker

// Laws of the planners that go from neighbour to neighbour: they agree in length, and their paths are legal.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string_view>

#include "ascii_map.hpp"
#include "legal_path.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

struct World {
    explicit World(const PlainMap& closed, int most_removed = 3)
        : map(closed.grid()),
          removed(some_obstacles(map, most_removed)),
          open(plain(map, removed)),
          start(any_free_cell(open)),
          goal(any_free_cell(open)) {}

    // The path is legal, or there is none.
    SearchResult find(const SearchOptions& options) const {
        const SearchResult result = Searcher().find(OpenedMap(map, removed), start, goal, options);
        const std::string fault = path_fault(open, start, goal, options, result);
        if (!fault.empty()) RC_LOG() << fault << '\n';
        RC_ASSERT(fault.empty());
        return result;
    }

    Map map;
    std::vector<ObstacleId> removed;
    PlainMap open;
    Cell start;
    Cell goal;
};

void check_equally_long(const SearchResult& a, const SearchResult& b) {
    RC_ASSERT(a.status == b.status);
    RC_ASSERT(std::abs(a.length - b.length) <= 1e-9 * (1 + a.length));
}

RC_GTEST_PROP(GridPaths, AreEquallyLongByAnyOptimalPlanner, ()) {
    // Wide maps for jumps across words of bits.
    const World world(*random_map(*rc::gen::element(24, 200), *rc::gen::element(3, 24)));
    const Corners corners = any_corners();
    const SearchResult optimal = world.find({.planner = Algorithm::dijkstra, .body = {.corners = corners}});
    for (const Heuristic heuristic : {Heuristic::octile, Heuristic::euclidean, Heuristic::chebyshev, Heuristic::zero}) {
        for (const TieBreak tie_break : {TieBreak::g_max, TieBreak::g_min}) {
            for (const Algorithm planner : {Algorithm::astar, Algorithm::jps}) {
                check_equally_long(optimal, world.find({.planner = planner,
                                                        .heuristic = heuristic,
                                                        .tie_break = tie_break,
                                                        .body = {.corners = corners}}));
            }
        }
    }
}

RC_GTEST_PROP(GridPaths, OfWideAgentsAreEquallyLong, ()) {
    const World world(*random_map(30, 24));
    const Body body{.radius = *rc::gen::element(0.5, 0.501, 0.75, 1.2, 2.25)};
    check_equally_long(world.find({.planner = Algorithm::dijkstra, .body = body}),
                       world.find({.planner = Algorithm::astar, .body = body}));
}

RC_GTEST_PROP(GridPaths, OfBfsAreShortestOnFourNeighbours, ()) {
    const World world(*random_map(24, 24));
    const SearchResult by_moves = world.find({.planner = Algorithm::bfs, .diagonal = false});
    check_equally_long(by_moves, world.find({.planner = Algorithm::dijkstra, .diagonal = false}));
    check_equally_long(by_moves, world.find({.planner = Algorithm::astar, .diagonal = false}));
}

// On eight neighbours BFS takes the fewest moves: no more than a shortest path has.
RC_GTEST_PROP(GridPaths, OfBfsTakeTheFewestMoves, ()) {
    const World world(*random_map(24, 24));
    const Body body{.corners = any_corners()};
    const auto moves = [](const SearchResult& result) {
        int count = 0;
        for (std::size_t i = 1; i < result.path.size(); ++i) {
            count += std::max(std::abs(result.path[i].x - result.path[i - 1].x),
                              std::abs(result.path[i].y - result.path[i - 1].y));
        }
        return count;
    };
    const SearchResult fewest = world.find({.planner = Algorithm::bfs, .body = body});
    const SearchResult shortest = world.find({.planner = Algorithm::dijkstra, .body = body});
    RC_ASSERT(moves(fewest) <= moves(shortest));
    RC_ASSERT(fewest.length >= shortest.length - 1e-9);
}

RC_GTEST_PROP(GridPaths, StayWithinTheHeuristicsWeight, ()) {
    const World world(*random_map(30, 30));
    const Body body{.corners = any_corners()};
    const double weight = *rc::gen::element(1.1, 1.5, 2.0, 5.0);
    const SearchResult optimal = world.find({.planner = Algorithm::dijkstra, .body = body});
    for (const Algorithm planner : {Algorithm::astar, Algorithm::jps}) {
        const SearchResult greedy = world.find({.planner = planner, .weight = weight, .body = body});
        RC_ASSERT(greedy.status == optimal.status);
        RC_ASSERT(greedy.length <= weight * optimal.length + 1e-9);
        RC_ASSERT(greedy.length >= optimal.length - 1e-9);
    }
}

// A cell that was first entered by a detour is entered again, from another side: else no path was found here.
TEST(GridPaths, OfAWeightedJumpSearchAreFound) {
    constexpr std::string_view picture = R"(
        .........................
        ...................#....G
        ...........#####.........
        S..........#####.........
        .....#...................
        ......................#..
        .............#...........
        .........................
        .........................
        ..#...........#.........#
        ..............#..........
        ..#................#.....
        ..................######.
        ...........#......######.
        ..................######.
        ............#....#######.
        ............#....#######.
        ######.#.................
        ######...................)";
    const Map map = map_from_ascii(picture);
    for (const Corners corners : {Corners::cut, Corners::squeeze}) {
        const SearchOptions options{.planner = Algorithm::jps, .weight = 5, .body = {.corners = corners}};
        const SearchResult found =
            Searcher().find(OpenedMap(map, {}), mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'), options);
        EXPECT_EQ(found.status, SearchStatus::found);
    }
}

// More freedom never makes the way longer.
RC_GTEST_PROP(GridPaths, ShortenWithFreedom, ()) {
    const PlainMap closed = *random_map(24, 24);
    const World world(closed);
    const Map map(closed.grid());
    const auto length = [&world](const Body& body, bool diagonal = true) {
        const SearchResult result = world.find({.planner = Algorithm::astar, .diagonal = diagonal, .body = body});
        return result.status == SearchStatus::found ? result.length : std::numeric_limits<double>::infinity();
    };
    const double none = length({});
    const double cut = length({.corners = Corners::cut});
    const double squeeze = length({.corners = Corners::squeeze});
    RC_ASSERT(squeeze <= cut + 1e-9);
    RC_ASSERT(cut <= none + 1e-9);
    RC_ASSERT(none <= length({}, false) + 1e-9);
    RC_ASSERT(none <= length({.radius = 0.9}) + 1e-9);
    // Removals too.
    if (closed.blocked(world.start) || closed.blocked(world.goal)) return;
    const SearchResult before = Searcher().find(OpenedMap(map), world.start, world.goal, {.planner = Algorithm::astar});
    if (before.status == SearchStatus::found) RC_ASSERT(none <= before.length + 1e-9);
}

}  // namespace
}  // namespace waybreaker

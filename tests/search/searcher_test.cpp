// What a searcher guarantees besides the path: limits, ends, memory, listeners.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "ascii_map.hpp"
#include "legal_path.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr std::array planners{Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar,
                              Algorithm::jps,   Algorithm::dijkstra,   Algorithm::bfs};

Algorithm any_planner() {
    return planners[std::size_t(*number(0, int(planners.size()) - 1))];
}

bool same(const SearchResult& a, const SearchResult& b) {
    return a.status == b.status && a.path == b.path && a.length == b.length && a.expanded == b.expanded &&
           a.generated == b.generated;
}

RC_GTEST_PROP(Searcher, DoesNotRememberEarlierQueries, ()) {
    Searcher used;
    for (int query = 0; query < 8; ++query) {
        const PlainMap plain = *random_map(30, 30);
        const Map map(plain.grid());
        const Cell start = any_cell(plain);
        const Cell goal = any_cell(plain);
        const SearchOptions options{.planner = any_planner(), .weight = *rc::gen::element(1.0, 1.7)};
        RC_ASSERT(same(used.find(OpenedMap(map), start, goal, options),
                       Searcher().find(OpenedMap(map), start, goal, options)));
    }
}

RC_GTEST_PROP(Searcher, FindsTheSameWhoeverWatches, ()) {
    struct : SearchListener {
        std::uint64_t generated_count = 0;
        std::set<Cell> known;
        std::set<Cell> taken;
        void generated(Cell cell, Cell parent, double g, double f) override {
            ++generated_count;
            RC_ASSERT(known.insert(cell).second);
            RC_ASSERT(known.count(parent) == 1U);
            RC_ASSERT(g <= f + 1e-9);
        }
        void updated(Cell cell, Cell parent, double, double) override {
            RC_ASSERT(known.count(cell) == 1U && taken.count(cell) == 0U);
            RC_ASSERT(known.count(parent) == 1U);
        }
        void expanded(Cell cell, Cell, double, double) override {
            RC_ASSERT(known.count(cell) == 1U);
            RC_ASSERT(taken.insert(cell).second);  // each once
        }
    } listener;
    const PlainMap plain = *random_map(30, 30);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    SearchOptions options{.planner = any_planner()};
    Searcher searcher;
    const SearchResult alone = searcher.find(OpenedMap(map), start, goal, options);
    RC_ASSERT(alone.hits.empty());
    options.count_hits = true;
    const SearchResult counted = searcher.find(OpenedMap(map), start, goal, options);
    options.listener = &listener;
    const SearchResult watched = searcher.find(OpenedMap(map), start, goal, options);
    RC_ASSERT(same(alone, counted));
    RC_ASSERT(same(alone, watched));
    RC_ASSERT(counted.hits == watched.hits);
    RC_ASSERT(listener.taken.size() == alone.expanded);
    RC_ASSERT(listener.generated_count == alone.generated);

    // The hits by their definition, from what was expanded: with any planner.
    std::vector<std::uint32_t> hits(map.obstacles().size() + 1, 0);
    for (const Cell cell : listener.taken) {
        for (int i = 0; i < 9 && cell != goal; ++i) {
            const Cell c{cell.x - 1 + i % 3, cell.y - 1 + i / 3};
            if (plain.contains(c) && plain.blocked(c)) ++hits[map.obstacle_at(c).value];
        }
    }
    RC_ASSERT(counted.hits == hits);
}

RC_GTEST_PROP(Searcher, StopsAtItsExpansionLimit, ()) {
    const PlainMap plain = *random_map(24, 24);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    SearchOptions options{.planner = any_planner()};
    const SearchResult whole = Searcher().find(OpenedMap(map), start, goal, options);
    options.limits.expansions = std::uint64_t(*number(0, int(whole.expanded) + 2));
    const SearchResult part = Searcher().find(OpenedMap(map), start, goal, options);
    if (options.limits.expansions >= whole.expanded) {
        RC_ASSERT(same(whole, part));
    } else {
        RC_ASSERT(part.status == SearchStatus::limit_reached);
        RC_ASSERT(part.expanded == options.limits.expansions);
        RC_ASSERT(part.path.empty());
        RC_ASSERT(part.length == 0);
    }
}

TEST(Searcher, StopsWhenAsked) {
    const Map map(Grid(200, 200));
    StopSource source;
    struct StopSoon : SearchListener {
        explicit StopSoon(StopSource& stop) : source(stop) {}
        StopSource& source;
        int count = 0;
        void generated(Cell, Cell, double, double) override {}
        void updated(Cell, Cell, double, double) override {}
        void expanded(Cell, Cell, double, double) override {
            if (++count == 100) source.request_stop();
        }
    } listener(source);
    for (const Algorithm planner : {Algorithm::dijkstra, Algorithm::bfs}) {
        const SearchResult result =
            Searcher().find(OpenedMap(map), {0, 0}, {199, 199},
                            {.planner = planner, .limits = {.stop = source.get_token()}, .listener = &listener});
        EXPECT_EQ(result.status, SearchStatus::stopped);
        EXPECT_LE(result.expanded, 1024U);
        EXPECT_TRUE(result.path.empty());
    }
}

TEST(Searcher, SaysThatThereIsNoPath) {
    constexpr std::string_view picture = R"(
        S.#..
        ..#..
        ..#.G)";
    const Map map = map_from_ascii(picture);
    for (const Algorithm planner : planners) {
        const SearchResult result =
            Searcher().find(OpenedMap(map), mark_in_ascii(picture, 'S'), mark_in_ascii(picture, 'G'),
                            {.planner = planner, .count_hits = true});
        EXPECT_EQ(result.status, SearchStatus::no_path);
        EXPECT_TRUE(result.path.empty());
        EXPECT_GT(result.expanded, 0U);
        EXPECT_EQ(result.generated, result.expanded);
        ASSERT_EQ(result.hits.size(), 2U);
        // JPS tests neighbours at jump points only, and there is none on the way to a straight wall.
        EXPECT_EQ(result.hits[1] > 0, planner != Algorithm::jps);
        const SearchResult opened = Searcher().find(OpenedMap(map, std::vector<ObstacleId>{{1}}), {0, 0}, {4, 2},
                                                    {.planner = planner, .count_hits = true});
        EXPECT_EQ(opened.status, SearchStatus::found);
        EXPECT_EQ(opened.hits[1], 0U) << "an obstacle that is gone is in nobody's way";
    }
}

TEST(Searcher, TakesStartAndGoalAsTheyCome) {
    const Map map = map_from_ascii(R"(
        ..#
        ...)");
    for (const Algorithm planner : planners) {
        const SearchOptions options{.planner = planner, .count_hits = true};
        const SearchResult stay = Searcher().find(OpenedMap(map), {1, 1}, {1, 1}, options);
        EXPECT_EQ(stay.status, SearchStatus::found);
        EXPECT_EQ(stay.path, (std::vector<Cell>{{1, 1}}));
        EXPECT_EQ(stay.length, 0);
        EXPECT_EQ(stay.expanded, 1U);
        EXPECT_EQ(stay.generated, 1U);
        EXPECT_EQ(stay.hits, (std::vector<std::uint32_t>{0, 0})) << "the goal is not expanded";
        for (const Cell wrong : {Cell{2, 0}, Cell{-1, 0}, Cell{3, 1}, Cell{0, 2}, Cell{1'000'000, -1'000'000}}) {
            for (const auto& [start, goal] : {std::pair{wrong, Cell{0, 0}}, std::pair{Cell{0, 0}, wrong}}) {
                const SearchResult result = Searcher().find(OpenedMap(map), start, goal, options);
                EXPECT_EQ(result.status, SearchStatus::no_path);
                EXPECT_EQ(result.expanded, 0U);
                EXPECT_EQ(result.hits.size(), 2U);
            }
        }
    }
}

TEST(Searcher, WalksTheThinnestMaps) {
    const Map row(Grid(300, 1));
    const Map column(Grid(1, 300));
    for (const Algorithm planner : planners) {
        const SearchResult along = Searcher().find(OpenedMap(row), {299, 0}, {0, 0}, {.planner = planner});
        EXPECT_EQ(along.path, (std::vector<Cell>{{299, 0}, {0, 0}}));
        const SearchResult down = Searcher().find(OpenedMap(column), {0, 0}, {0, 299}, {.planner = planner});
        EXPECT_EQ(down.path, (std::vector<Cell>{{0, 0}, {0, 299}}));
    }
}

// Cells as they are expanded.
struct Heard : SearchListener {
    std::vector<std::pair<Cell, double>> cells;
    void generated(Cell, Cell, double, double) override {}
    void updated(Cell, Cell, double, double) override {}
    void expanded(Cell cell, Cell, double g, double) override { cells.emplace_back(cell, g); }
};

RC_GTEST_PROP(Searcher, ExploresWhatThereIsAWayTo, ()) {
    const PlainMap plain = *random_map(12, 10);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Algorithm planner = *rc::gen::element(Algorithm::dijkstra, Algorithm::bfs, Algorithm::astar, Algorithm::theta,
                                                Algorithm::lazy_theta);
    Heard heard;
    Searcher searcher;
    searcher.explore(OpenedMap(map), start, {.planner = planner, .weight = 3, .listener = &heard});
    std::set<Cell> seen;
    double last = 0;
    for (const auto& [cell, g] : heard.cells) {
        RC_ASSERT(seen.insert(cell).second);
        if (planner == Algorithm::lazy_theta) continue;  // may find that a cell is farther than it was taken to be
        RC_ASSERT(g >= last - 1e-9);
        last = g;
        const SearchResult way = searcher.find(OpenedMap(map), start, cell, {.planner = Algorithm::dijkstra});
        if (planner == Algorithm::dijkstra || planner == Algorithm::astar) RC_ASSERT(std::abs(g - way.length) < 1e-9);
    }
    for (const Cell cell : plain.free_cells()) {
        const SearchResult way = searcher.find(OpenedMap(map), start, cell, {.planner = Algorithm::dijkstra});
        RC_ASSERT((way.status == SearchStatus::found) == seen.contains(cell));
    }
}

TEST(Searcher, ExploresFromNowhereNothing) {
    const Map map = map_from_ascii("..#");
    Heard heard;
    Searcher().explore(OpenedMap(map), {2, 0}, {.listener = &heard});
    Searcher().explore(OpenedMap(map), {5, 0}, {.listener = &heard});
    EXPECT_TRUE(heard.cells.empty());
    EXPECT_THROW(Searcher().explore(OpenedMap(map), {0, 0}, {.planner = Algorithm::jps}), InputError);
    EXPECT_THROW(Searcher().explore(OpenedMap(map), {0, 0}, {.planner = Algorithm::optimal}), InputError);
}

TEST(Searcher, RefusesOptionsThatContradictEachOther) {
    EXPECT_THROW(validate(SearchOptions{.weight = 0.99}), InputError);
    EXPECT_THROW(validate(SearchOptions{.weight = std::nan("")}), InputError);
    EXPECT_THROW(validate(SearchOptions{.planner = Algorithm::jps, .diagonal = false}), InputError);
    EXPECT_THROW(validate(SearchOptions{.planner = Algorithm::jps, .body = {.radius = 1}}), InputError);
    EXPECT_THROW(validate(SearchOptions{.body = {.radius = 0.0001}}), InputError);
    EXPECT_THROW(validate(SearchOptions{.planner = Algorithm(99)}), InputError);
    const Map map(Grid(2, 2));
    EXPECT_THROW(Searcher().find(OpenedMap(map), {0, 0}, {1, 1}, {.weight = 0}), InputError);
}

}  // namespace
}  // namespace waybreaker

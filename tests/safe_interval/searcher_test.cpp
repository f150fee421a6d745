// What the search promises: legal paths that meet nobody, none where there is none, and early ones.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <string>

#include "ascii_map.hpp"
#include "random_map.hpp"
#include "waybreaker/advanced/safe_interval.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

// What is wrong with a path; empty if nothing is.
std::string faults(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal,
                   const SafeIntervalOptions& options, const std::vector<Waypoint>& path) {
    if (path.empty()) return "no points";
    const auto cell = [](const Waypoint& at) { return Cell{int(at.x), int(at.y)}; };
    if (cell(path.front()) != start || path.front().t != 0) return "does not start at the start at time 0";
    if (cell(path.back()) != goal) return "does not end at the goal";
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double way = distance(cell(path[i - 1]), cell(path[i]));
        const double lasts = path[i].t - path[i - 1].t;
        if (lasts < 0) return "goes back in time";
        if (way > 0 && std::abs(lasts - way / options.speed) > 1e-6) return "has another speed";
        if (way > 0 && path[i - 1].t < options.ready_at) return "leaves too early";
        if (!line_of_sight(map, cell(path[i - 1]), cell(path[i]), options.body)) return "meets an obstacle";
    }
    if (path.back().t < options.ready_at) return "ends before it is ready";
    if (!traffic.met(path, options.body.reach(), options.stays).empty()) return "meets somebody";
    return "";
}

RC_GTEST_PROP(SafeInterval, MeetsNobody, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid());
    const OpenedMap opened(map);
    SafeIntervalSearcher searcher;
    Traffic traffic(map.width(), map.height(), *rc::gen::element(0.0, 0.4));
    // Each is planned past those before.
    for (std::uint32_t who = 0; who < 6; ++who) {
        SafeIntervalOptions options;
        options.body.radius = *rc::gen::element(0.3, 0.5, 1.0);
        options.speed = *rc::gen::element(0.5, 1.0, 2.0);
        options.ready_at = *rc::gen::element(0.0, 3.0);
        options.stays = *number(0, 3) > 0;
        const Cell start = any_free_cell(plain);
        const Cell goal = any_free_cell(plain);
        const SafeIntervalResult found = searcher.find(opened, traffic, start, goal, options);
        if (found.status != SearchStatus::found) {
            RC_ASSERT(found.path.empty());
            continue;
        }
        RC_ASSERT(faults(opened, traffic, start, goal, options, found.path) == "");
        // Somebody who has not searched before finds the same.
        RC_ASSERT(SafeIntervalSearcher().find(opened, traffic, start, goal, options).path == found.path);
        traffic.add(who, found.path, options.body.radius, options.stays);
    }
}

// Nothing that is late; and what is in time as well as without a limit, but for a few ways that its distances, which
// are those of Theta*, make look longer than they are.
TEST(SafeInterval, LooksForNoLateArrival) {
    std::mt19937 random(7);
    const auto below = [&](int count) { return int(random() % unsigned(count)); };
    SafeIntervalSearcher searcher;
    int known = 0;
    int found_again = 0;
    for (int round = 0; round < 100; ++round) {
        PlainMap plain{10 + below(10), 10 + below(10), {}};
        for (int i = 0; i < plain.width * plain.height; ++i) plain.obstacles.push_back(below(100) < 20 ? 1 : 0);
        const std::vector<Cell> free = plain.free_cells();
        const auto any = [&] { return free[std::size_t(below(int(free.size())))]; };
        const Map map(plain.grid());
        const OpenedMap opened(map);
        Traffic traffic(map.width(), map.height());
        for (std::uint32_t who = 0; who < 8; ++who) {
            const Cell start = any();
            const Cell goal = any();
            SafeIntervalOptions options{.ready_at = double(below(3)), .stays = below(4) > 0};
            const SafeIntervalResult without = searcher.find(opened, traffic, start, goal, options);
            if (without.status != SearchStatus::found) continue;
            ++known;
            const double arrival = without.path.back().t;
            options.arrive_before = arrival + 0.01;
            const SafeIntervalResult in_time = searcher.find(opened, traffic, start, goal, options);
            if (in_time.status == SearchStatus::found) {
                EXPECT_EQ(faults(opened, traffic, start, goal, options, in_time.path), "");
                found_again += in_time.path.back().t < arrival + 1e-6 ? 1 : 0;
            }
            options.arrive_before = arrival;
            const SafeIntervalResult earlier = searcher.find(opened, traffic, start, goal, options);
            EXPECT_TRUE(earlier.status != SearchStatus::found || earlier.path.back().t < arrival);
            traffic.add(who, without.path, options.body.radius, options.stays);
        }
    }
    EXPECT_GT(known, 500);
    EXPECT_GE(found_again, known * 98 / 100) << "of " << known;
}

// One cell wide.
Map corridor_with_a_bay() {
    return map_from_ascii(R"(
        ####.####
        .........
        #########)");
}

// One that drives through the corridor, from right to left.
Traffic through_it(const Map& map) {
    Traffic traffic(map.width(), map.height());
    traffic.add(0, std::vector<Waypoint>{{8, 1, 0}, {0, 1, 8}}, 0.5, false);
    return traffic;
}

// In the bay until the other one has passed.
TEST(SafeInterval, WaitsInABay) {
    const Map map = corridor_with_a_bay();
    const Traffic traffic = through_it(map);
    SafeIntervalSearcher searcher;
    SafeIntervalOptions options;
    options.speed = 0.5;
    // From the right end of the corridor, behind the other one.
    const auto behind = searcher.find(OpenedMap(map), traffic, {8, 1}, {4, 0}, options);
    EXPECT_EQ(behind.status, SearchStatus::no_path);  // it stands where the other one is
    // From the bay's side: it has to let the other one pass.
    options.speed = 1;
    const auto found = searcher.find(OpenedMap(map), traffic, {4, 0}, {8, 1}, options);
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_EQ(faults(OpenedMap(map), traffic, {4, 0}, {8, 1}, options, found.path), "");
    // The other one passes the bay at 4, and is a cell further at 5.
    EXPECT_GT(found.path.back().t, 8);
    EXPECT_LT(found.path.back().t, 11);
}

TEST(SafeInterval, GoesIntoABayToLetOthersPass) {
    const Map map = corridor_with_a_bay();
    const Traffic traffic = through_it(map);
    SafeIntervalOptions options;
    options.speed = 1;
    // Both would meet at 4; the bay is reached just then, too late for a disc that needs a cell.
    const auto found = SafeIntervalSearcher().find(OpenedMap(map), traffic, {2, 1}, {8, 1}, options);
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_EQ(faults(OpenedMap(map), traffic, {2, 1}, {8, 1}, options, found.path), "");
}

// Who has nowhere to go stands there until it is ready as well.
TEST(SafeInterval, StandsAtItsStartUntilItIsReady) {
    const Map map = map_from_ascii(".........\n.........\n.........");
    const SafeIntervalOptions options{.ready_at = 3, .stays = false};
    const std::vector<Waypoint> stands{{4, 1, 0}, {4, 1, 3}};
    const Traffic nobody(map.width(), map.height());
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), nobody, {4, 1}, {4, 1}, options).path, stands);
    Traffic early(map.width(), map.height());
    early.add(0, std::vector<Waypoint>{{0, 1, 0}, {8, 1, 4}}, 0.5, false);
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), early, {4, 1}, {4, 1}, options).status,
              SearchStatus::no_path);
    Traffic late(map.width(), map.height());
    late.add(0, std::vector<Waypoint>{{0, 1, 0}, {8, 1, 8}}, 0.5, false);
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), late, {4, 1}, {4, 1}, options).path, stands);
    // The search itself, where the way alone is not free.
    Traffic passes(map.width(), map.height());
    passes.add(0, std::vector<Waypoint>{{0, 0, 0}, {4, 0, 4}, {4, 2, 6}}, 0.5, false);
    const SafeIntervalOptions for_ever{.ready_at = 2};
    const auto found = SafeIntervalSearcher().find(OpenedMap(map), passes, {4, 1}, {4, 1}, for_ever);
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_EQ(faults(OpenedMap(map), passes, {4, 1}, {4, 1}, for_ever, found.path), "");
}

TEST(SafeInterval, ReachesAGoalOnlyForGood) {
    const Map map = map_from_ascii(".........\n.........\n.........");
    Traffic traffic(map.width(), map.height());
    traffic.add(0, std::vector<Waypoint>{{0, 0, 0}, {0, 0, 20}, {8, 0, 28}}, 0.5, false);
    SafeIntervalOptions options;
    const auto stays = SafeIntervalSearcher().find(OpenedMap(map), traffic, {4, 2}, {4, 0}, options);
    ASSERT_EQ(stays.status, SearchStatus::found);
    // The other one is over the goal at 24; straight behind it one arrives at 25, across its way at 24 + sqrt(2).
    EXPECT_GE(stays.path.back().t, 25);
    EXPECT_LT(stays.path.back().t, 25.42);
    options.stays = false;
    const auto leaves = SafeIntervalSearcher().find(OpenedMap(map), traffic, {4, 2}, {4, 0}, options);
    ASSERT_EQ(leaves.status, SearchStatus::found);
    EXPECT_DOUBLE_EQ(leaves.path.back().t, 2);
    options.arrive_before = 2;
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), traffic, {4, 2}, {4, 0}, options).status,
              SearchStatus::no_path);
}

// A wall with two gaps, the nearer one closed by somebody for long; too large a map to look everywhere at once.
TEST(SafeInterval, GoesAnotherWayWhereTheNearOneTakesLong) {
    std::string picture;
    for (int y = 0; y < 90; ++y) {
        picture += std::string(40, '.') + (y == 10 || y == 80 ? '.' : '#') + std::string(40, '.') + '\n';
    }
    const Map map = map_from_ascii(picture);
    Traffic traffic(map.width(), map.height());
    traffic.add(0, std::vector<Waypoint>{{40, 10, 0}, {40, 10, 150}, {80, 10, 190}}, 0.5, false);
    SafeIntervalOptions options;
    const Cell start{20, 30};
    const Cell goal{60, 30};
    const auto found = SafeIntervalSearcher().find(OpenedMap(map), traffic, start, goal, options);
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_EQ(faults(OpenedMap(map), traffic, start, goal, options, found.path), "");
    const double around = distance(start, {39, 80}) + 2 + distance({41, 80}, goal);
    EXPECT_GE(found.path.back().t, around - 1e-6);
    EXPECT_LT(found.path.back().t, around + 1);
    // Also where only that one is in time, and not where none is.
    options.arrive_before = around + 1;
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), traffic, start, goal, options).status, SearchStatus::found);
    options.arrive_before = around - 1;
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), traffic, start, goal, options).status, SearchStatus::no_path);
}

TEST(SafeInterval, WaitsUntilAnObstacleIsGone) {
    const std::string_view picture = R"(
        ..a..
        ..a..
        ..a..)";
    const Map map = map_from_ascii(picture);
    const ObstacleId wall = map.obstacle_at({2, 0});
    const std::array removed{wall};
    const OpenedMap opened(map, removed);
    const Traffic traffic(map.width(), map.height());
    const std::array openings{TimedOpening{wall, 10}};
    SafeIntervalOptions options;
    options.openings = openings;
    const auto found = SafeIntervalSearcher().find(opened, traffic, {0, 1}, {4, 1}, options);
    ASSERT_EQ(found.status, SearchStatus::found);
    EXPECT_NEAR(found.path.back().t, 13, 1e-6);  // it touches the wall from 1,1 on, and drives on at 10
    options.openings = {};
    EXPECT_DOUBLE_EQ(SafeIntervalSearcher().find(opened, traffic, {0, 1}, {4, 1}, options).path.back().t, 4);
    options.openings = openings;
    EXPECT_THROW(SafeIntervalSearcher().find(OpenedMap(map), traffic, {0, 1}, {4, 1}, options), InputError);
}

TEST(SafeInterval, ObeysLimits) {
    const Map map = map_from_ascii("....\n....");
    Traffic traffic(map.width(), map.height());
    traffic.add(0, std::vector<Waypoint>{{3, 0, 0}, {0, 0, 3}}, 0.5);
    SafeIntervalOptions options;
    options.limits.expansions = 1;
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), traffic, {1, 1}, {3, 0}, options).status,
              SearchStatus::limit_reached);
    StopSource source;
    source.request_stop();
    options.limits = {.stop = source.get_token()};
    EXPECT_EQ(SafeIntervalSearcher().find(OpenedMap(map), traffic, {1, 1}, {3, 0}, options).status,
              SearchStatus::stopped);
    const std::array<Cell, 2> elsewhere{{{0, 0}, {3, 0}}};
    options.known = elsewhere;
    EXPECT_THROW(SafeIntervalSearcher().find(OpenedMap(map), traffic, {1, 1}, {3, 0}, options), InputError);
    EXPECT_THROW(SafeIntervalSearcher().find(OpenedMap(map), Traffic(9, 9), {1, 1}, {3, 0}), InputError);
}

}  // namespace
}  // namespace waybreaker

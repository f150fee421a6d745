#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "zones/slow_zones.hpp"

namespace waybreaker {
namespace {

constexpr int side = 24;

Zone square(double x, double y, double edge) {
    return {.polygon = {{{x, y}, {x + edge, y}, {x + edge, y + edge}, {x, y + edge}}}};
}

double length_of(const std::vector<Point>& way) {
    double length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) length += distance(way[i - 1], way[i]);
    return length;
}

TEST(Airspace, IsOpenWithoutZones) {
    const Airspace air;
    EXPECT_TRUE(air.is_open());
    EXPECT_TRUE(air.allows({3, 4}));
    EXPECT_EQ(air.length({0, 0}, {3, 4}), 5);
    EXPECT_EQ(air.way({0, 0}, {3, 4}), (std::vector<Point>{{0, 0}, {3, 4}}));
}

TEST(Airspace, BendsAtCornersOfTheNearerSide) {
    const Airspace air(std::vector<Zone>{square(4, 2, 4)}, side, side);
    EXPECT_EQ(air.way({0, 3}, {12, 3}), (std::vector<Point>{{0, 3}, {4, 2}, {8, 2}, {12, 3}}));
    EXPECT_DOUBLE_EQ(air.length({0, 3}, {12, 3}), 4 + 2 * std::sqrt(17.0));
    EXPECT_EQ(air.way({12, 3}, {0, 3}), (std::vector<Point>{{12, 3}, {8, 2}, {4, 2}, {0, 3}}));
}

TEST(Airspace, IsOpenAlongOutlinesAndAtCorners) {
    const Airspace air(std::vector<Zone>{square(4, 4, 4)}, side, side);
    EXPECT_TRUE(air.is_clear({0, 4}, {12, 4}));
    EXPECT_TRUE(air.is_clear({2, 6}, {6, 2}));   // past a corner
    EXPECT_TRUE(air.is_clear({4, 5}, {4, 7}));   // on a side
    EXPECT_FALSE(air.is_clear({4, 4}, {8, 8}));  // from corner to corner
    EXPECT_FALSE(air.is_clear({4, 5}, {8, 6}));  // from side to side
    EXPECT_TRUE(air.allows({4, 5}));
    EXPECT_FALSE(air.allows({5, 5}));
}

TEST(Airspace, IsClosedBetweenZonesThatShareASide) {
    const Airspace air(std::vector<Zone>{square(4, 4, 4), square(4, 8, 4)}, side, side);
    EXPECT_FALSE(air.is_clear({0, 8}, {12, 8}));
    EXPECT_TRUE(air.is_clear({4, 2}, {4, 14}));
    // Corner to corner there is a way between.
    const Airspace diagonal(std::vector<Zone>{square(4, 4, 4), square(8, 8, 4)}, side, side);
    EXPECT_TRUE(diagonal.is_clear({10, 6}, {6, 10}));
}

TEST(Airspace, HasNoWayOutOfAHole) {
    Zone ring = square(2, 2, 16);
    ring.polygon.push_back({{6, 6}, {14, 6}, {14, 14}, {6, 14}});
    validate(ring, 1);
    const Airspace air(std::vector<Zone>{ring}, side, side);
    EXPECT_EQ(air.length({7, 7}, {13, 13}), distance(Cell{7, 7}, Cell{13, 13}));
    EXPECT_EQ(air.length({7, 7}, {20, 20}), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(air.way({7, 7}, {20, 20}).empty());
}

TEST(Airspace, HasNoWayRoundOffTheMap) {
    const Zone wall{.polygon = {{{10, -5}, {12, -5}, {12, 40}, {10, 40}}}};
    const Airspace air(std::vector<Zone>{wall}, side, side);
    EXPECT_EQ(air.length({2, 2}, {20, 2}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(air.length({2, 2}, {2, 20}), 18);
}

// A place on a slanted side is rounded to the outside of it.
TEST(Airspace, LeavesASlantedSideWhereRoundingPutsIt) {
    const std::vector<Zone> zones{{.polygon = {{{2, 1}, {19, 8}, {5, 20}}}}};
    const Airspace air(zones, side, side);
    for (int i = 1; i < 100; ++i) {
        const Point at(2 + 17 * i / 100.0, 1 + 7 * i / 100.0);
        EXPECT_TRUE(air.allows(at)) << i;
        EXPECT_TRUE(air.is_clear(at, {20, 0})) << i;
    }
}

TEST(Airspace, IgnoresZonesForVehicles) {
    Zone zone = square(4, 4, 4);
    zone.kind = ZoneKind::keep_out;
    EXPECT_TRUE(Airspace(std::vector<Zone>{zone}, side, side).is_open());
}

RC_GTEST_PROP(Airspace, SeesWhatIsClear, ()) {
    const std::vector<Zone> zones = any_zones(6, side);
    const Airspace air(zones, side, side);
    for (int i = 0; i < 20; ++i) {
        const Point a = any_cell(side);
        const Point b = any_cell(side);
        RC_ASSERT(air.is_clear(a, b) == slowly_clear(zones, a, b));
        RC_ASSERT(air.allows(a) == !slowly_inside(zones, a));
    }
}

RC_GTEST_PROP(Airspace, KnowsTheShortestWay, ()) {
    const std::vector<Zone> zones = any_zones(6, side);
    const Airspace air(zones, side, side);
    for (int i = 0; i < 3; ++i) {
        const Point a = any_cell(side);
        const Point b = any_cell(side);
        if (a == b || slowly_inside(zones, a) || slowly_inside(zones, b)) continue;
        const double slow = slow_length(zones, side, side, a, b);
        const double length = air.length(a, b);
        RC_ASSERT((std::isinf(slow) ? std::isinf(length) : std::abs(length - slow) < 1e-9));
        RC_ASSERT(air.length(b, a) == length);
        const std::vector<Point> way = air.way(a, b);
        RC_ASSERT(way.empty() == std::isinf(length));
        if (way.empty()) continue;
        RC_ASSERT(way.front() == a);
        RC_ASSERT(way.back() == b);
        RC_ASSERT(std::abs(length_of(way) - length) < 1e-9);
        for (std::size_t k = 1; k < way.size(); ++k) RC_ASSERT(slowly_clear(zones, way[k - 1], way[k]));
        std::vector<Point> back = air.way(b, a);
        std::reverse(back.begin(), back.end());
        RC_ASSERT(back == way);
    }
}

RC_GTEST_PROP(Airspace, ClosesMoreWithEveryZone, ()) {
    std::vector<Zone> zones = any_zones(5, side);
    const Point a = any_cell(side);
    const Point b = any_cell(side);
    const double before = Airspace(zones, side, side).length(a, b);
    const Zone more = any_zone(side);
    RC_PRE(is_valid(more));
    zones.push_back(more);
    RC_ASSERT(Airspace(zones, side, side).length(a, b) >= before - 1e-9);
}

// Corners anywhere on the lattice, and many flights: none of the points along them lies inside.
TEST(Airspace, HoldsNoPointOfTenThousandFlights) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.5, 299.5);
    std::uniform_real_distribution<double> share(0, 1);
    std::size_t flights = 0;
    std::size_t bent = 0;
    std::size_t inside = 0;
    while (flights < 10000) {
        std::vector<Zone> zones;
        while (zones.size() < 12) {
            Zone zone;
            std::vector<Point>& ring = zone.polygon.emplace_back();
            const Point centre(place(random), place(random));
            const int corners = 3 + int(share(random) * 12);
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * std::numbers::pi * (i + 0.9 * share(random)) / corners;
                const double radius = 5 + 40 * share(random);
                const auto rounded = [](double v) { return std::round(v * zone_steps) / zone_steps; };
                ring.emplace_back(rounded(centre.x + radius * std::cos(angle)),
                                  rounded(centre.y + radius * std::sin(angle)));
            }
            if (is_valid(zone)) zones.push_back(std::move(zone));
        }
        const Airspace air(zones, 300, 300);
        for (int i = 0; i < 500; ++i) {
            const Point a(std::round(300 * share(random) - 0.5), std::round(300 * share(random) - 0.5));
            const Point b(std::round(300 * share(random) - 0.5), std::round(300 * share(random) - 0.5));
            if (!air.allows(a) || !air.allows(b)) continue;
            const std::vector<Point> way = air.way(a, b);
            if (way.empty()) continue;
            ++flights;
            bent += way.size() > 2;
            for (int k = 0; k < 100; ++k) {
                const std::size_t leg = std::size_t(share(random) * double(way.size() - 1));
                const double s = share(random);
                const Point p(way[leg].x + s * (way[leg + 1].x - way[leg].x),
                              way[leg].y + s * (way[leg + 1].y - way[leg].y));
                inside += slowly_inside(zones, p);
            }
        }
    }
    EXPECT_GT(bent, flights / 4);
    EXPECT_EQ(inside, 0U);
}

}  // namespace
}  // namespace waybreaker

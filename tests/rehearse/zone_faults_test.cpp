// The executor's own geometry of zones.
#include "rehearse/zone_faults.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace waybreaker::rehearsal {
namespace {

// A square with a square hole.
Zone ring(ZoneKind kind) {
    return {kind, {{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}}, "", {}};
}

bool is_seen(const Zone& zone, const std::vector<Point>& path, double radius = 0) {
    Trail trail{.agent = "a", .kind = zone.kind == ZoneKind::no_fly ? AgentKind::air : AgentKind::ground};
    trail.radius = radius;
    for (std::size_t i = 0; i < path.size(); ++i) trail.add(path[i], double(i));
    return zone_faults(std::array{zone}, trail).fault.has_value();
}

TEST(ZoneFault, FlightsMayTouchASideAndAreInTheHole) {
    const Zone zone = ring(ZoneKind::no_fly);
    EXPECT_FALSE(is_seen(zone, {{0, 0}, {2, 2}, {2, 8}, {5, 8}, {8, 8}, {8, 0}}));
    EXPECT_FALSE(is_seen(zone, {{4, 5}, {6, 6}, {5, 5}}));
    EXPECT_FALSE(is_seen(zone, {{0, 4}, {4, 0}}));  // through a corner
    EXPECT_TRUE(is_seen(zone, {{0, 4.1}, {4.1, 0}}));
    EXPECT_TRUE(is_seen(zone, {{5, 5}, {5, 9}}));
    EXPECT_TRUE(is_seen(zone, {{2, 2}, {4, 4}}));
    EXPECT_TRUE(is_seen(zone, {{0, 3}, {9, 3}}));
    EXPECT_TRUE(is_seen(zone, {{3, 3}}));
    EXPECT_FALSE(is_seen(zone, {{5, 5}}));
}

TEST(ZoneFault, DiscsKeepTheirRadiusAway) {
    const Zone zone = ring(ZoneKind::keep_out);
    EXPECT_FALSE(is_seen(zone, {{1.5, 0}, {1.5, 9}}, 0.5));
    EXPECT_TRUE(is_seen(zone, {{1.55, 0}, {1.55, 9}}, 0.5));
    EXPECT_TRUE(is_seen(zone, {{0, 3}, {9, 3}}, 0.5));
    EXPECT_FALSE(is_seen(zone, {{5, 5}}, 1));
    EXPECT_TRUE(is_seen(zone, {{5, 5}}, 1.1));
    EXPECT_FALSE(is_seen(zone, {{2, 0}, {2, 9}}));  // a point
}

TEST(ZoneFault, HoldsForWhomItNames) {
    Zone zone = ring(ZoneKind::no_fly);
    zone.agents = {"b"};
    EXPECT_FALSE(is_seen(zone, {{0, 3}, {9, 3}}));
    zone.agents = {"b", "a"};
    EXPECT_TRUE(is_seen(zone, {{0, 3}, {9, 3}}));
    Trail rover{.agent = "a"};
    rover.add({0, 3}, 0);
    rover.add({9, 3}, 9);
    EXPECT_FALSE(zone_faults(std::array{zone}, rover).fault);
}

// It is in the ring from 2 to 4, in its hole until 6, and in the ring again until 8.
TEST(ZoneFault, HoldsBetweenItsTimes) {
    struct Case {
        double from;
        double until;
        bool fault;
        bool caught;
    };
    for (const Case& c : {Case{0, 2, false, false},
                          {0, 2.1, true, false},
                          {3.9, 6, false, true},
                          {4.1, 5.9, false, false},
                          {4.1, 6.1, true, false},
                          {3, 7, true, true},
                          {7, 9, false, true},
                          {8, 9, false, false}}) {
        Zone zone = ring(ZoneKind::no_fly);
        zone.from = c.from;
        zone.until = c.until;
        Trail flight{.agent = "a", .kind = AgentKind::air};
        for (const double t : {0.0, 3.5, 5.0, 10.0}) flight.add({t, 5}, t);
        const ZoneFaults faults = zone_faults(std::array{zone}, flight);
        EXPECT_EQ(faults.fault.has_value(), c.fault) << c.from << " to " << c.until;
        EXPECT_EQ(faults.caught, c.caught) << c.from << " to " << c.until;
    }
}

}  // namespace
}  // namespace waybreaker::rehearsal

// Times and touches compared with samples at many moments of the drive.
#include "model/timeline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "ascii_map.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

// How deep the disc at (x, y) reaches into the obstacle: radius minus the distance to its nearest cell's square.
double depth(const PlainMap& map, std::uint32_t obstacle, double x, double y, double radius) {
    double nearest = 1e9;
    for (const Cell c : map.cells()) {
        if (map.at(c) != obstacle) continue;
        nearest = std::min(nearest,
                           std::hypot(std::max(std::abs(x - c.x) - 0.5, 0.0), std::max(std::abs(y - c.y) - 0.5, 0.0)));
    }
    return radius - nearest;
}

RC_GTEST_PROP(Timeline, FirstTouchIsWhenItLooksSo, ()) {
    const Map map((*random_map(12, 12)).grid());
    RC_PRE(!map.obstacles().empty());
    const PlainMap labels = plain(map);
    const double radius = *rc::gen::element(0.0, 0.5, 0.8, 2.0);
    const double speed = *rc::gen::element(0.5, 1.0, 3.0);
    std::vector<Point> path{any_cell(labels)};
    const int turns = *number(1, 4);
    while (int(path.size()) <= turns) path.push_back(any_cell(labels));
    const std::vector<Waypoint> points = timed(path, speed);
    const std::uint32_t obstacle = std::uint32_t(*number(1, int(map.obstacles().size())));
    const std::optional<double> touch = first_touch(map, {obstacle}, points, radius);
    RC_ASSERT(!touch || (*touch >= 0 && *touch <= points.back().t));
    constexpr int samples = 400;  // of each leg
    constexpr double hair = 1e-6;
    const auto depth_at = [&](double x, double y) { return depth(labels, obstacle, x, y, radius); };
    bool touched = false;  // as surely as can be seen at these moments
    for (std::size_t leg = 1; leg < points.size(); ++leg) {
        const Waypoint& a = points[leg - 1];
        const Waypoint& b = points[leg];
        for (int i = 0; i <= samples; ++i) {
            const double share = double(i) / samples;
            const double t = a.t + share * (b.t - a.t);
            const double deep = depth_at(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
            if (!touch || t < *touch - hair) RC_ASSERT(deep < hair);
            touched = touched || deep > hair;
            // At the moment it names, the disc has reached the obstacle.
            if (touch && a.t <= *touch && *touch <= b.t && b.t > a.t) {
                const double at = (*touch - a.t) / (b.t - a.t);
                RC_ASSERT(depth_at(a.x + at * (b.x - a.x), a.y + at * (b.y - a.y)) > -hair);
            }
        }
    }
    RC_ASSERT(touch || !touched);
}

TEST(Timeline, DrivesWithoutAStop) {
    const std::vector<Point> path{{0, 0}, {3, 4}, {3, 4}, {3, 0}};
    EXPECT_DOUBLE_EQ(path_length(path), 9);
    EXPECT_EQ(timed(path, 2), (std::vector<Waypoint>{{0, 0, 0}, {3, 4, 2.5}, {3, 4, 2.5}, {3, 0, 4.5}}));
    EXPECT_TRUE(timed({}, 1).empty());
    EXPECT_EQ(path_length({}), 0);
    EXPECT_EQ(path_length(std::vector<Point>{{7, 7}}), 0);
}

TEST(Timeline, NamesTheMomentOfTheTouch) {
    const Map map = map_from_ascii(R"(
        .........
        .........
        ......#..)");
    const auto touch = [&map](Cell from, Cell to, double radius) {
        return first_touch(map, {1}, timed(std::vector<Point>{from, to}, 2), radius);
    };
    EXPECT_NEAR(touch({0, 2}, {8, 2}, 0.5).value(), 2.5, 1e-12);   // head on: at x = 5
    EXPECT_NEAR(touch({0, 2}, {8, 2}, 0.0).value(), 2.75, 1e-12);  // a point: at x = 5.5
    EXPECT_FALSE(touch({0, 1}, {8, 1}, 0.5)) << "to graze is not to touch";
    EXPECT_NEAR(touch({0, 1}, {8, 1}, 0.75).value(), (5.5 - std::sqrt(0.3125)) / 2,
                1e-12);  // with its side, at a corner
    EXPECT_FALSE(touch({0, 0}, {8, 0}, 0.75));
    EXPECT_EQ(touch({6, 2}, {8, 2}, 0.5), 0) << "it starts inside";
    // The obstacle's corner at 5.5,2.5 lies 1.1 from the line through 3,2 and 7,5.
    EXPECT_FALSE(touch({3, 2}, {7, 5}, 1.1)) << "nor is it for a radius that no sum of powers of two is";
    EXPECT_TRUE(touch({3, 2}, {7, 5}, 1.101));
}

TEST(Timeline, RoundingIsNoTouch) {
    const Map map = map_from_ascii("....#");
    const std::vector<Waypoint> path{{std::nextafter(3.0, 4.0), 0.25, 0}, {3, 0, 1}, {2, 0, 2}};
    EXPECT_FALSE(first_touch(map, {1}, path, 0.5))
        << "it is under way along the obstacle, and to graze is not to touch";
    const std::vector<Waypoint> nearer{{3 + 1e-6, 0.25, 0}, {3, 0, 1}, {2, 0, 2}};
    EXPECT_EQ(first_touch(map, {1}, nearer, 0.5), 0);
}

TEST(Timeline, CountsWaits) {
    const Map map = map_from_ascii("..#");
    const std::vector<Waypoint> path{{0, 0, 0}, {1, 0, 1}, {1, 0, 11}, {2, 0, 12}};
    EXPECT_NEAR(first_touch(map, {1}, path, 0.25).value(), 11.25, 1e-12);
    EXPECT_NEAR(first_touch(map, {1}, path, 0.75).value(), 0.75, 1e-12);
}

}  // namespace
}  // namespace waybreaker

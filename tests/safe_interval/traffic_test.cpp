// The index of moving discs against a look at all pairs of legs.
#include "safe_interval/traffic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "random_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

std::vector<Waypoint> any_path(int width, int height) {
    std::vector<Waypoint> path;
    double time = *number(0, 20);
    const int points = *number(1, 6);
    for (int i = 0; i < points; ++i) {
        path.push_back({double(*number(0, width - 1)), double(*number(0, height - 1)), time});
        if (*number(0, 3) == 0) {
            time += *number(0, 5);
            path.push_back({path.back().x, path.back().y, time});
        }
        time += *number(1, 30);
    }
    return path;
}

RC_GTEST_PROP(Traffic, FindsWhomAPathMeets, ()) {
    const int width = *number(1, 40);
    const int height = *number(1, 40);
    const double separation = *rc::gen::element(0.0, 0.7);
    Traffic traffic(width, height, separation);
    struct Disc {
        std::vector<Waypoint> path;
        double radius;
        bool stays;
    };
    std::vector<Disc> discs;
    for (std::uint32_t who = 0; who < 12; ++who) {
        discs.push_back({any_path(width, height), *rc::gen::element(0.0, 0.5, 1.7), *number(0, 1) == 0});
        traffic.add(who, discs.back().path, discs.back().radius, discs.back().stays);
    }
    const auto gone = std::uint32_t(*number(0, 11));
    traffic.remove(gone);
    const std::vector<Waypoint> path = any_path(width, height);
    const double radius = 0.5;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t who = 0; who < discs.size(); ++who) {
        bool meets = false;
        for (const auto& a : safe_interval::TrafficIndex::legs(path, true)) {
            for (const auto& b : safe_interval::TrafficIndex::legs(discs[who].path, discs[who].stays)) {
                const double reach = radius + discs[who].radius + separation - clearance_slack;
                // Pieces of a leg are rounded: who only just overlaps may or may not.
                const auto wide = safe_interval::overlap(a, b, reach + 1e-6);
                const auto narrow = safe_interval::overlap(a, b, reach - 1e-6);
                if (wide.empty() != narrow.empty()) return;
                meets = meets || !narrow.empty();
            }
        }
        if (meets && who != gone) expected.push_back(who);
    }
    RC_ASSERT(traffic.met(path, radius) == expected);
}

TEST(Traffic, RefusesWhatCannotBe) {
    Traffic traffic(10, 10);
    const std::vector<Waypoint> path{{0, 0, 0}, {9, 0, 9}};
    traffic.add(1, path, 0.5);
    EXPECT_THROW(traffic.add(1, path, 0.5), InputError);
    EXPECT_THROW(traffic.add(2, {}, 0.5), InputError);
    EXPECT_THROW(traffic.add(2, path, 33), InputError);
    EXPECT_THROW(traffic.add(2, std::vector<Waypoint>{{0, 0, 1}, {1, 0, 0}}, 0.5), InputError);
    EXPECT_THROW(traffic.add(2, std::vector<Waypoint>{{0, 10, 1}}, 0.5), InputError);
    EXPECT_THROW(Traffic(0, 5), InputError);
    EXPECT_THROW(Traffic(5, 5, -1), InputError);
    traffic.remove(2);  // is not there
    EXPECT_EQ(traffic.met(path, 0.5), std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace waybreaker

// A plan as GPX, read back by GDAL: places and times must be those of the plan.
#include "exports/plan_gpx.hpp"

#include <gtest/gtest.h>

#include <array>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "placed_town.hpp"

namespace waybreaker::exports {
namespace {

using PlanGpx = PlacedTown;

TEST_F(PlanGpx, HasATrackForEachAgent) {
    const auto file = read("plan.gpx", plan_gpx(placed()));
    ASSERT_TRUE(file);
    OGRLayer* const tracks = file->GetLayerByName("tracks");
    ASSERT_EQ(tracks->GetFeatureCount(), 2);
    std::vector<std::string> names;
    for (const OGRFeatureUniquePtr& track : *tracks) names.emplace_back(track->GetFieldAsString("name"));
    EXPECT_EQ(names, (std::vector<std::string>{"ground", "air"}));
    std::array<std::size_t, 2> next{};
    for (const OGRFeatureUniquePtr& point : *file->GetLayerByName("track_points")) {
        const auto track = std::size_t(point->GetFieldAsInteger("track_fid"));
        const std::vector<Waypoint>& path = plan.agents[track].path;
        std::size_t& i = next[track];
        while (i != 0 && i < path.size() && path[i] == path[i - 1]) ++i;
        ASSERT_LT(i, path.size());
        expect_at(*point->GetGeometryRef()->toPoint(), {path[i].x, path[i].y});
        EXPECT_NEAR(seconds(*point, "time"), path[i].t, 0.002);
        ++i;
    }
    EXPECT_EQ(next[0], plan.agents[0].path.size());
    EXPECT_EQ(next[1], plan.agents[1].path.size());
}

TEST_F(PlanGpx, HasAWayPointForEachBreach) {
    const auto file = read("plan.gpx", plan_gpx(placed()));
    ASSERT_TRUE(file);
    ASSERT_FALSE(plan.breaches.empty());
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& point : *file->GetLayerByName("waypoints")) {
        const Breach& breach = plan.breaches.at(i++);
        expect_at(*point->GetGeometryRef()->toPoint(), {double(breach.at.x), double(breach.at.y)});
        EXPECT_NEAR(seconds(*point, "time"), breach.cleared_at, 0.002);
        EXPECT_EQ(point->GetFieldAsString("type"), std::string("breach"));
    }
    EXPECT_EQ(i, plan.breaches.size());
}

TEST_F(PlanGpx, HoldsNamesOfAnyBytes) {
    map.annotations.title = "A < B & \"C\" \x01\xff";
    plan.agents[0].id = "<ground>";
    const auto file = read("plan.gpx", plan_gpx(placed()));
    ASSERT_TRUE(file);
    const OGRFeatureUniquePtr track(file->GetLayerByName("tracks")->GetNextFeature());
    EXPECT_EQ(track->GetFieldAsString("name"), std::string("<ground>"));
}

TEST_F(PlanGpx, NeedsToKnowWhereTheMapLies) {
    const io::MapFile nowhere{.map = map_from_ascii("..#.."), .source = "yard.map"};
    EXPECT_EQ(input_error([&] {
                  plan_gpx({.plan = plan, .map = nowhere});
              }).find("yard.map: GPX needs longitude and latitude"),
              0U);
}

}  // namespace
}  // namespace waybreaker::exports
